# Fails where something asks the compiler for arithmetic that knows no NaN and no infinity.
#   cmake -D ROOT=<the project> -P ExactArithmetic.cmake
cmake_minimum_required(VERSION 3.25)

# Each pattern has a bracket, so that this file does not match itself.
set(inexact "[-]ffast-math|[-]Ofast|[-]funsafe-math|[-]ffinite-math|[-]fassociative-math|[-]freciprocal-math|[/]fp:fast")
string(APPEND inexact "|optimize *[(]\"[^)]*(fast|math)|fp[ ]+(reassociate|contract)|float_[c]ontrol")

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/framework/* ${ROOT}/grader/* ${ROOT}/exercises/* ${ROOT}/solutions/*
  ${ROOT}/cmake/*.cmake ${ROOT}/cmake/*.txt)
# Attacks may ask for anything.
list(FILTER files EXCLUDE REGEX "^grader/attacks/code/")
list(APPEND files CMakeLists.txt CMakePresets.json radlab)
foreach(file IN LISTS files)
  file(STRINGS ${ROOT}/${file} hits REGEX "${inexact}")
  foreach(hit IN LISTS hits)
    message(SEND_ERROR "${file}: asks for arithmetic that knows no NaN and no infinity: ${hit}")
  endforeach()
endforeach()
