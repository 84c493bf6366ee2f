# Fails where clang-format would change a source.
#   cmake -D ROOT=<the project> -D CLANG_FORMAT=<the program> -P Format.cmake
cmake_minimum_required(VERSION 3.25)

if(NOT CLANG_FORMAT)
  message(STATUS "skipped: clang-format was not found")
  return()
endif()
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT version MATCHES "version 14\\.")
  message(STATUS "skipped: another version than 14 formats otherwise; found ${version}")
  return()
endif()

set(sources "")
foreach(top framework grader exercises solutions)
  foreach(ending h hpp cpp cc inl)
    file(GLOB_RECURSE found RELATIVE ${ROOT} ${ROOT}/${top}/*.${ending})
    list(APPEND sources ${found})
  endforeach()
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror --ferror-limit=1 ${sources} WORKING_DIRECTORY ${ROOT}
  RESULT_VARIABLE result)
if(result)
  message(FATAL_ERROR "correct the places above with: clang-format -i FILE")
endif()
