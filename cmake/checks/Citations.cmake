# Fails where a source that a comment cites is not in the list of references.
#   cmake -D ROOT=<the project> -P Citations.cmake
cmake_minimum_required(VERSION 3.25)

file(STRINGS ${ROOT}/resources/references.bib entries REGEX "^@")
set(keys "")
foreach(entry IN LISTS entries)
  string(REGEX REPLACE "^@[a-z]+{([A-Za-z0-9]+),.*" "\\1" key "${entry}")
  list(APPEND keys ${key})
endforeach()

file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/framework/*.h ${ROOT}/framework/*.cpp ${ROOT}/grader/*.h ${ROOT}/grader/*.cpp
  ${ROOT}/solutions/*.cpp
  ${ROOT}/resources/scenes/*.x3d ${ROOT}/resources/scenes/generate.py)
set(cited 0)
foreach(source IN LISTS sources)
  file(READ ${ROOT}/${source} text)
  string(REGEX REPLACE "[][]" "|" text "${text}")  # CMake's lists give brackets a meaning of their own
  string(REGEX MATCHALL "[|]([A-Z][A-Za-z]+[0-9][0-9][0-9][0-9]|X3D|Howell|CornellBox|Lindbloom|IEC61966)[|,]" found "${text}")
  foreach(citation IN LISTS found)
    string(REGEX REPLACE "[^A-Za-z0-9]" "" key "${citation}")
    math(EXPR cited "${cited} + 1")
    if(NOT key IN_LIST keys)
      message(SEND_ERROR "${source}: cites ${key}, which resources/references.bib does not have")
    endif()
  endforeach()
endforeach()
if(cited LESS 20)
  message(SEND_ERROR "found ${cited} citations, expected at least 20: has their form changed?")
endif()
