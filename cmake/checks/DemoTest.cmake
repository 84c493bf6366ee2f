# What the demo program promises, on scenes small enough to take seconds.
# -DDEMO, -DEXERCISE: the two programs; -DROOT: the project; -DFOLDER: an empty folder to work in.

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(WRITE ${FOLDER}/empty.xml "<Resource><Values hemicube_size='16' form_factor_method='auto'
  patch_subdivision_size='150' light_subdivision_size='150' file_name='${ROOT}/resources/scenes/cornell_1.x3d'/></Resource>")
file(WRITE ${FOLDER}/furnished.xml "<Resource><Values hemicube_size='16' form_factor_method='auto'
  patch_subdivision_size='150' light_subdivision_size='150' file_name='${ROOT}/resources/scenes/cornell_2.x3d'/></Resource>")
file(WRITE ${FOLDER}/misspelt.xml "<Resource><Values hemicube_sise='16' form_factor_method='auto'
  patch_subdivision_size='150' light_subdivision_size='150' file_name='${ROOT}/resources/scenes/cornell_2.x3d'/></Resource>")

function(run program expected_code)
  execute_process(COMMAND ${program} ${ARGN} WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  set(said "${out}${err}" PARENT_SCOPE)
  if(NOT code EQUAL expected_code)
    message(FATAL_ERROR "${program} ${ARGN}\nexit code: found ${code}, expected ${expected_code}\n${out}${err}")
  endif()
endfunction()

function(expect text)
  string(FIND "${said}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "expected '${text}' in what was said:\n${said}")
  endif()
endfunction()

set(small --empty ${FOLDER}/empty.xml --furnished ${FOLDER}/furnished.xml)

run(${DEMO} 0 ${small} --out ${FOLDER}/solved)
foreach(file IN ITEMS index.html contact_sheet.png shots_strip.png shots_00001.png 01_patches.png 10_shadows.png)
  if(NOT EXISTS ${FOLDER}/solved/${file})
    message(FATAL_ERROR "the demo did not write ${file}")
  endif()
endforeach()
file(READ ${FOLDER}/solved/index.html page)
string(REGEX MATCHALL "(src|href|file:) *[=]? *\"([^\"]*)\"" links "${page}")
list(LENGTH links count)
if(count LESS 20)
  message(FATAL_ERROR "the page shows ${count} pictures, expected at least 20")
endif()
foreach(link IN LISTS links)
  string(REGEX REPLACE ".*\"([^\"]*)\"" "\\1" file "${link}")
  if(NOT EXISTS ${FOLDER}/solved/${file})
    message(FATAL_ERROR "the page names ${file}, which is not there")
  endif()
endforeach()

run(${EXERCISE} 0 ${small} --out ${FOLDER}/exercise)
expect("not yet  Stage 1")
expect("made     The scene is cut into patches")

run(${DEMO} 2 --empty ${FOLDER}/misspelt.xml --out ${FOLDER}/broken)
expect("misspelt.xml:1")
expect("did you mean")
if(EXISTS ${FOLDER}/broken)
  message(FATAL_ERROR "a demo that failed left a folder behind")
endif()
run(${DEMO} 2 --empty ${FOLDER}/nowhere.xml)
run(${DEMO} 2 --no-such-flag)
run(${DEMO} 0 --version)
expect("radlab 0.")
run(${DEMO} 0 --help)
expect("Example: ")
