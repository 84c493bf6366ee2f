# How everything is compiled.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()

option(RADLAB_WERROR "Treat warnings in radlab's own code as errors" OFF)
option(RADLAB_PRECOMPILE "Compile what nearly every file includes once" ON)
option(RADLAB_UNITY "Compile the files of a folder eight at a time: the headers are most of the work" ON)
option(RADLAB_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

add_library(radlab_options INTERFACE)
target_include_directories(radlab_options INTERFACE ${PROJECT_SOURCE_DIR}/framework ${PROJECT_SOURCE_DIR})
target_compile_definitions(radlab_options INTERFACE
  RADLAB_VERSION="${PROJECT_VERSION}"
  RADLAB_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  GL_SILENCE_DEPRECATION)

if(MSVC)
  target_compile_options(radlab_options INTERFACE /W4 /permissive- /utf-8 /bigobj)
  target_compile_definitions(radlab_options INTERFACE _USE_MATH_DEFINES NOMINMAX _CRT_SECURE_NO_WARNINGS)
  set(RADLAB_WERROR_FLAG /WX)
else()
  target_compile_options(radlab_options INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
  set(RADLAB_WERROR_FLAG -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_CLANG_TIDY)
    # False alarms on std::string + (GCC bug 105651), in 12 and 14 at least.
    target_compile_options(radlab_options INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
  if(RADLAB_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(radlab_options INTERFACE -Wno-subobject-linkage)  # takes a file that is one of eight for a header
  endif()
endif()
if(RADLAB_WERROR)
  target_compile_options(radlab_options INTERFACE ${RADLAB_WERROR_FLAG})
endif()

if(RADLAB_SANITIZE)
  set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND sanitize -Wno-maybe-uninitialized)  # the sanitizers' own code sets off false alarms
  endif()
  add_compile_options(${sanitize})
  add_link_options(${sanitize})
endif()
