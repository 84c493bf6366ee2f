# The fuzzer of the scene readers: built by clang whatever the project's compiler is, since only clang has libFuzzer.

find_program(RADLAB_CLANGXX NAMES clang++ clang++-14)

# Adds a test that feeds the readers with that many changed copies of the seed corpus, the same ones on every new build. What is TOGETHER
# is compiled as one file.
function(radlab_fuzz_test name source runs)
  cmake_parse_arguments(arg "" "CORPUS;DICTIONARY" "SOURCES;TOGETHER" ${ARGN})
  if(NOT EXISTS ${source})
    return()
  endif()
  if(NOT RADLAB_CLANGXX)
    radlab_missing("clang" "the short fuzz run is left out of the tests")
    return()
  endif()
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/framework/base/*.h ${PROJECT_SOURCE_DIR}/framework/course/*.h
    ${PROJECT_SOURCE_DIR}/framework/scene/*.h)
  set(folder ${PROJECT_BINARY_DIR}/fuzz)
  set(program ${folder}/${name}-program)
  list(TRANSFORM arg_TOGETHER REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE together)
  list(JOIN together "" together)
  file(GENERATE OUTPUT ${folder}/${name}-together.cpp CONTENT "${together}")
  add_custom_command(OUTPUT ${program}
    COMMAND ${RADLAB_CLANGXX} -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined
      -I${PROJECT_SOURCE_DIR}/framework -idirafter ${GLM_INCLUDE_DIR} ${source} ${arg_SOURCES} ${folder}/${name}-together.cpp
      $<TARGET_FILE:tinyxml2::tinyxml2> -o ${program}
    DEPENDS ${source} ${arg_SOURCES} ${arg_TOGETHER} ${headers}
    COMMENT "Building ${name} with clang and its sanitizers" VERBATIM)
  add_custom_target(${name} ALL DEPENDS ${program})
  add_test(NAME "${name}: survives ${runs} mutated inputs" COMMAND ${program} -runs=${runs} -seed=1 -timeout=60
    -artifact_prefix=${folder}/ -rss_limit_mb=2048 -print_final_stats=1 -dict=${arg_DICTIONARY} ${folder}/${name}-found ${arg_CORPUS})
  set_tests_properties("${name}: survives ${runs} mutated inputs" PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: ")
  file(MAKE_DIRECTORY ${folder}/${name}-found)
endfunction()
