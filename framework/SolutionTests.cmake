# The tests of the solutions, of the exercise as a student first compiles it, and of the window.

if(NOT doctest_FOUND)
  return()
endif()

# A test program of the files named, its cases listed one by one in ctest.
function(radlab_test_files name files)
  list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/)
  add_executable(${name} ${files})
  target_link_libraries(${name} PRIVATE radlab_test_main ${ARGN})
  radlab_compile_quickly(${name})
  radlab_reuse_headers(${name} radlab_precompiled_tests)
  radlab_unify(${name})
  doctest_discover_tests(${name} TEST_PREFIX "${name}: " PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: ")
endfunction()

# What holds for any right solution is held against both; the rest is each one's own.
set(any_solution solutions/ProgRefTest.cpp solutions/DrawingStagesTest.cpp solutions/ClosedFormTest.cpp solutions/ClosedSceneTest.cpp)
radlab_submission(older-style solutions/OlderStyle.cpp)
radlab_test_files(solution-test "${any_solution};solutions/EnergyTest.cpp;solutions/SelfCheckTest.cpp"
  radlab_solver radlab_solution ${RADLAB_OFFSCREEN})
radlab_test_files(older-style-test "${any_solution};solutions/OlderStyleTest.cpp"
  radlab_solver radlab_older-style ${RADLAB_OFFSCREEN})

# The exercise alone, with far more warnings than a student's own file gets: what radlab hands out has none.
file(GLOB handed_out CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/exercises/*.cpp ${PROJECT_SOURCE_DIR}/exercises/extensions/*.cpp)
list(FILTER handed_out EXCLUDE REGEX "Test\\.cpp$")
add_library(exercise-without-warnings OBJECT EXCLUDE_FROM_ALL ${handed_out})
target_link_libraries(exercise-without-warnings PRIVATE radlab_course)
target_include_directories(exercise-without-warnings PRIVATE ${PROJECT_SOURCE_DIR}/framework/course)
if(MSVC)
  target_compile_options(exercise-without-warnings PRIVATE /WX)
else()
  target_compile_options(exercise-without-warnings PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
endif()
add_test(NAME "the exercise compiles without a warning"
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --config $<CONFIG> --target exercise-without-warnings)
set_tests_properties("the exercise compiles without a warning" PROPERTIES RUN_SERIAL ON SKIP_REGULAR_EXPRESSION "-- skipped: ")

# The window, on a display that nobody sees where there is xvfb-run, else on the user's own. Without -noreset
# Xvfb restarts when the last window closes, and the next one may find no display.
if(RADLAB_HAVE_WINDOW)
  add_executable(window-test course/window/WindowTest.cpp)
  target_link_libraries(window-test PRIVATE radlab_test_main radlab_course radlab_gl_window)
  find_program(XVFB_RUN xvfb-run)
  set(on_display)
  if(XVFB_RUN)
    set(on_display ${XVFB_RUN} -a -s "-noreset -screen 0 640x480x24")
  endif()
  add_test(NAME "window-test: all cases" COMMAND ${on_display} $<TARGET_FILE:window-test>)
  set_tests_properties("window-test: all cases" PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: ")
endif()
