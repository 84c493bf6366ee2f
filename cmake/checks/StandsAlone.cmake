# Fails where a file names a folder outside the project: such a path holds on one machine only.
#   cmake -D ROOT=<the project> -P StandsAlone.cmake
cmake_minimum_required(VERSION 3.25)

# Each pattern has a bracket, so that this file does not match itself.
set(outside "[.][.]/shared|(^|[^a-z0-9_.$}-])/([w]ork|[h]ome|[r]oot|[U]sers)/")

execute_process(COMMAND git -c core.quotePath=false ls-files --cached --others --exclude-standard
  WORKING_DIRECTORY ${ROOT} RESULT_VARIABLE result OUTPUT_VARIABLE files ERROR_QUIET)
if(result EQUAL 0)
  string(REGEX REPLACE "\n" ";" files "${files}")
else()
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*)
  list(FILTER files EXCLUDE REGEX "^(build|out|[.]cache|[.]git)/")
endif()

set(faults 0)
foreach(file IN LISTS files)
  if(file STREQUAL "" OR NOT EXISTS ${ROOT}/${file} OR IS_DIRECTORY ${ROOT}/${file})
    continue()
  endif()
  file(STRINGS ${ROOT}/${file} hits REGEX "${outside}")
  foreach(hit IN LISTS hits)
    message(NOTICE "${file}: names a path outside the project: ${hit}")
    math(EXPR faults "${faults} + 1")
  endforeach()
endforeach()
if(faults)
  message(FATAL_ERROR "${faults} paths outside the project")
endif()
