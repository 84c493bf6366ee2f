# radlab_library(), radlab_tests(), radlab_program(), radlab_program_tests(), radlab_submission(): one line a target in
# the lists.

# The library of a folder, framework/<name> or grader/<name>: every .cpp there except tests and programs. What it
# may depend on is said once, in checks/layers.txt, and read from there.
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/checks/layers.txt RADLAB_LAYERS REGEX "^[a-z]")

function(radlab_layer_of folder out)
  foreach(line IN LISTS RADLAB_LAYERS)
    if(line MATCHES "^${folder} *:(.*)$")
      separate_arguments(found UNIX_COMMAND "${CMAKE_MATCH_1}")
      set(${out} ${found} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "cmake/checks/layers.txt: no line for ${folder}")
endfunction()

# The targets of folders: radlab_base for framework/base, radlab_grader_stages for grader/stages.
function(radlab_targets_of folders out)
  list(TRANSFORM folders REPLACE "^framework/" "radlab_")
  list(TRANSFORM folders REPLACE "^grader/" "radlab_grader_")
  set(${out} ${folders} PARENT_SCOPE)
endfunction()

# What nearly every file includes, compiled once for libraries and once more, with doctest, for tests. Files still name
# what they use: with RADLAB_PRECOMPILE=OFF, as in the preset tidy, this is not there.
set(RADLAB_COMMON_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <sstream>
  <string> <vector> <glm/glm.hpp>)
function(radlab_precompile name)
  cmake_parse_arguments(arg "" "" "LIBRARIES;HEADERS" ${ARGN})
  if(RADLAB_PRECOMPILE)
    add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/Precompiled.cc)
    target_link_libraries(${name} PUBLIC radlab_options radlab_glm ${arg_LIBRARIES})
    target_precompile_headers(${name} PRIVATE ${RADLAB_COMMON_HEADERS} ${arg_HEADERS})
  endif()
endfunction()
radlab_precompile(radlab_precompiled)

# Whether a library, or one that it links, asks for a definition that changes the system's headers (_FILE_OFFSET_BITS): what is
# precompiled without it does not fit then. Such names begin with an underscore.
function(radlab_changes_headers library out)
  set(${out} FALSE PARENT_SCOPE)
  if(NOT TARGET ${library})
    return()
  endif()
  get_target_property(definitions ${library} INTERFACE_COMPILE_DEFINITIONS)
  if("${definitions}" MATCHES "(^|;)_")
    set(${out} TRUE PARENT_SCOPE)
    return()
  endif()
  get_target_property(linked ${library} INTERFACE_LINK_LIBRARIES)
  foreach(next IN LISTS linked)
    radlab_changes_headers("${next}" changes)  # not what is linked by $<LINK_ONLY:…>: its definitions do not arrive
    if(changes)
      set(${out} TRUE PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

function(radlab_reuse_headers_now name from)
  get_target_property(linked ${name} LINK_LIBRARIES)
  foreach(library IN LISTS linked)
    radlab_changes_headers("${library}" changes)
    if(changes)
      return()
    endif()
  endforeach()
  target_precompile_headers(${name} REUSE_FROM ${from})
endfunction()

# Gives a target what is precompiled, at the end of its folder's list: what it links is known then.
function(radlab_reuse_headers name from)
  if(RADLAB_PRECOMPILE)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL radlab_reuse_headers_now ${name} ${from})")
  endif()
endfunction()

# Compiles a target's files eight at a time, so that names in their anonymous namespaces must differ. Files with options of their own
# stay alone.
function(radlab_unify name)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${RADLAB_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# With APART, its files are compiled one by one: programs link some of them alone, as those that draw nothing do.
function(radlab_library folder)
  if(NOT IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder})
    return()  # not in the package that students get
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  list(FILTER sources EXCLUDE REGEX "(Test|Fuzz)\\.cpp$")
  radlab_layer_of(${folder} lower)
  radlab_targets_of("${lower}" lower)
  radlab_targets_of(${folder} name)
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC radlab_options radlab_glm ${lower})
  radlab_reuse_headers(${name} radlab_precompiled)
  if(NOT "APART" IN_LIST ARGN)
    radlab_unify(${name})
  endif()
endfunction()

# A submission: one file with the six functions, or those of the extensions, compiled as they stand, warnings included.
function(radlab_submission name)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  add_library(radlab_${name} OBJECT ${files})
  target_link_libraries(radlab_${name} PUBLIC radlab_course)
  target_include_directories(radlab_${name} PRIVATE ${PROJECT_SOURCE_DIR}/framework/course)
  target_precompile_headers(radlab_${name} PRIVATE ${PROJECT_SOURCE_DIR}/framework/course/ProgRef.h)
endfunction()

# Whether all the project's own libraries of a list are there: the package that students get has no solution.
function(radlab_have libraries out)
  set(${out} TRUE PARENT_SCOPE)
  foreach(library IN LISTS libraries)
    if(library MATCHES "^radlab_" AND NOT TARGET ${library})
      set(${out} FALSE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Tests are compiled once and run once: -O1 takes three quarters of the time of -O3. What they test is compiled as always.
function(radlab_compile_quickly name)
  if(TARGET ${name} AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# A test program of all …Test.cpp in a folder, its cases listed one by one in ctest.
function(radlab_tests name folder)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*Test.cpp)
  radlab_have("${ARGN}" have)
  if(NOT doctest_FOUND OR NOT sources OR NOT have)
    return()
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE radlab_test_main ${ARGN})
  radlab_compile_quickly(${name})
  radlab_reuse_headers(${name} radlab_precompiled_tests)
  radlab_unify(${name})
  doctest_discover_tests(${name} TEST_PREFIX "${name}: " PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: ")
endfunction()

# The program <source>.cpp.
function(radlab_program name source)
  radlab_have("${ARGN}" have)
  if(NOT CLI11_FOUND OR NOT have OR NOT EXISTS ${PROJECT_SOURCE_DIR}/${source}.cpp)
    return()
  endif()
  add_executable(${name} ${PROJECT_SOURCE_DIR}/${source}.cpp)
  target_link_libraries(${name} PRIVATE CLI11::CLI11 ${ARGN})
  radlab_reuse_headers(${name} radlab_precompiled)
  radlab_unify(${name})
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # CLI11 is all headers: half of the time that a program takes to compile goes into making its flags fast.
    set_source_files_properties(${PROJECT_SOURCE_DIR}/${source}.cpp PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O1>"
      SKIP_PRECOMPILE_HEADERS ON)  # they are compiled with -O3
  endif()
endfunction()

# Claims about a program, each a case of the shell script cmake/checks/<script>.
find_program(RADLAB_SH sh)
function(radlab_program_tests program script)
  if(NOT TARGET ${program} OR NOT RADLAB_SH OR NOT UNIX OR NOT EXISTS ${PROJECT_SOURCE_DIR}/cmake/checks/${script})
    return()
  endif()
  foreach(claim IN LISTS ARGN)
    add_test(NAME "${program}: ${claim}" COMMAND ${RADLAB_SH} ${PROJECT_SOURCE_DIR}/cmake/checks/${script}
      $<TARGET_FILE:${program}> ${PROJECT_SOURCE_DIR} "${claim}")
    # Long ones that wait a lot: they begin first, and short ones fill the gaps.
    set_tests_properties("${program}: ${claim}" PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: " COST 10)
  endforeach()
endfunction()
