# The viewer, and the libraries with the six functions that it builds and loads while it runs.

# A library of one file with the six functions. Inside it they call each other; all else it finds in the viewer.
function(radlab_course_library name file)
  if(NOT EXISTS ${file})
    return()
  endif()
  add_library(${name} MODULE EXCLUDE_FROM_ALL ${file} ${PROJECT_SOURCE_DIR}/framework/viewer/LibraryEntry.cc)
  target_link_libraries(${name} PRIVATE radlab_options radlab_glm)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/framework/course)
  target_include_directories(${name} SYSTEM PRIVATE ${OPENGL_HEADERS})
  target_precompile_headers(${name} PRIVATE ${PROJECT_SOURCE_DIR}/framework/course/ProgRef.h)
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${name} PRIVATE -fno-gnu-unique)  # else a library shares its statics with the one before it
  endif()
  if(APPLE)
    target_link_options(${name} PRIVATE -undefined dynamic_lookup)
  elseif(WIN32)
    target_link_libraries(${name} PRIVATE view)
  endif()
endfunction()

if(NOT RADLAB_HAVE_VIEWER)
  return()
endif()

file(GLOB sources CONFIGURE_DEPENDS viewer/window/*.cpp)
radlab_program(view framework/apps/view radlab_viewer radlab_gl_window ${IMGUI_LIBRARY})
if(NOT TARGET view)
  return()
endif()
target_sources(view PRIVATE ${sources})
if(STB_LIBRARY)
  target_link_libraries(view PRIVATE ${STB_LIBRARY})
endif()
target_include_directories(view SYSTEM PRIVATE ${IMGUI_INCLUDE_DIR} ${IMGUI_BACKENDS_DIR} ${NLOHMANN_JSON_INCLUDE_DIR})
set_target_properties(view PROPERTIES ENABLE_EXPORTS ON WINDOWS_EXPORT_ALL_SYMBOLS ON)
target_compile_definitions(view PRIVATE RADLAB_BUILD_DIR="${PROJECT_BINARY_DIR}" RADLAB_LIBRARY_DIR="${PROJECT_BINARY_DIR}/lib"
  RADLAB_LIBRARY_SUFFIX="${CMAKE_SHARED_MODULE_SUFFIX}")

radlab_course_library(exercise-library ${PROJECT_SOURCE_DIR}/exercises/ProgRef.cpp)
radlab_course_library(solution-library ${PROJECT_SOURCE_DIR}/solutions/ProgRef.cpp)

# The tests: the real window on a display of their own, driven by real events. A third library is built of a file that they may change.
if(NOT TARGET radlab_solution OR NOT EXISTS ${PROJECT_SOURCE_DIR}/cmake/checks/ViewTest.py)
  return()
endif()
radlab_program(view-picture framework/apps/view-picture radlab_viewer radlab_solution ${RADLAB_OFFSCREEN})
target_include_directories(view-picture SYSTEM PRIVATE ${NLOHMANN_JSON_INCLUDE_DIR})
file(COPY ${PROJECT_SOURCE_DIR}/exercises/ProgRef.cpp DESTINATION ${PROJECT_BINARY_DIR}/view-test)
radlab_course_library(view-test-library ${PROJECT_BINARY_DIR}/view-test/ProgRef.cpp)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_Interpreter_FOUND AND UNIX)
  foreach(claim IN ITEMS
      "every key and every button does what it says, and each picture is what a headless render gives"
      "a saved file is rebuilt: a compile error is shown with its line, then the new functions are in use"
      "a crash and a hang are named, and the viewer starts again on the same view"
      "a shot that takes long stops neither frames nor the mouse, and what is asked for comes after it"
      "what is wrong is said in one line with exit code 2")
    add_test(NAME "view: ${claim}" COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/checks/ViewTest.py
      $<TARGET_FILE:view> $<TARGET_FILE:view-picture> ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} "${claim}")
    set_tests_properties("view: ${claim}" PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: " RESOURCE_LOCK window)
    if(RADLAB_SANITIZE)
      set_tests_properties("view: ${claim}" PROPERTIES ENVIRONMENT RADLAB_SANITIZED=1)
    endif()
  endforeach()
endif()
