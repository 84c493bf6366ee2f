# Runs IncludeDirections.cmake on small made-up trees with a fault each.
cmake_minimum_required(VERSION 3.25)

# Writes a right tree with the given text as line 3 of one file, and expects the check to say what is given.
function(expect said file text)
  file(REMOVE_RECURSE ${TREE})
  file(WRITE ${TREE}/cmake/checks/layers.txt "# low to high\nframework/base :\nframework/course : framework/base\n"
    "framework/display : framework/base framework/course\n")
  file(WRITE ${TREE}/framework/base/Error.h "")
  file(WRITE ${TREE}/framework/course/ProgRef.h "#include \"base/Error.h\"\n")
  file(WRITE ${TREE}/framework/display/Draw.h "#include \"course/ProgRef.h\"\n#include <vector>\n")
  file(WRITE ${TREE}/framework/apps/demo.cpp "#include \"display/Draw.h\"\n")
  file(WRITE ${TREE}/exercises/ProgRef.cpp "#include \"ProgRef.h\"\n")
  file(WRITE ${TREE}/${file} "// [one; two\n\n${text}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${TREE} -P ${CMAKE_CURRENT_LIST_DIR}/IncludeDirections.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(said STREQUAL "nothing")
    if(result OR output)
      message(FATAL_ERROR "${file} with ${text}: expected no fault, found:\n${output}")
    endif()
    return()
  endif()
  string(FIND "${output}" "${said}" at)
  if(result EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "${file} with ${text}: expected a failure that says\n${said}\nfound:\n${output}")
  endif()
endfunction()

expect("nothing" framework/display/DrawTest.cpp "#include \"Draw.h\"")
expect("nothing" solutions/ProgRefTest.cpp "#include \"display/Draw.h\"")
expect("framework/course/MesherTest.cpp:3: framework/course may not include framework/display (\"display/Draw.h\"); allowed: framework/base"
  framework/course/MesherTest.cpp "#include \"display/Draw.h\"  // [an open bracket")
expect("framework/base/Image.h:3: framework/base may not include framework/course"
  framework/base/Image.h "# include \"../course/ProgRef.h\"")
expect("exercises/Other.cpp:3: exercises may not include framework/base" exercises/Other.cpp "#include <base/Error.h>")
expect("framework/new has no line in cmake/checks/layers.txt" framework/new/New.h "")
expect("framework/base depends on framework/course, which must have a line above it"
  cmake/checks/layers.txt "framework/base : framework/course\nframework/course :\nframework/display : framework/course")
