# Tests cmake/join_modules.cmake. It must join correct modules in the order of their imports. For wrong modules it must
# end with an error that names the file and the fault.
#   cmake -D SCRIPT=join_modules.cmake -D WORK=DIR -P join_modules_test.cmake
set(folder ${WORK}/modules)
set(good "import { a } from './low/a.js';\nconsole.log(a);\n")
set(good_a "export const a = [';', \"$\", '\\n'];\n")

macro(join)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -D FOLDER=${folder} -D ENTRY=page.js -D OUTPUT=${WORK}/joined.js -P ${SCRIPT}
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
endmacro()

# refused(WORDS PAGE A [FILE TEXT]) writes a file page.js with the text PAGE, a file low/a.js with the text A and, if
# given, FILE with TEXT. Joining these files must end with an error that contains WORDS.
function(refused words page a)
  file(REMOVE_RECURSE ${folder})
  file(WRITE ${folder}/page.js "${page}")
  file(WRITE ${folder}/low/a.js "${a}")
  if(ARGC GREATER 3)
    file(WRITE "${folder}/${ARGV3}" "${ARGV4}")
  endif()
  join()
  if(NOT failed)
    message(SEND_ERROR "joined, though: ${words}")
  elseif(NOT said MATCHES "${words}")
    message(SEND_ERROR "refused with '${said}', expected '${words}'")
  endif()
endfunction()

refused("page.js: imports b, which low/a.js does not export" "import { a, b } from './low/a.js';\n" "${good_a}")
refused("page.js: imports low/b.js, which does not exist" "import { b } from './low/b.js';\n" "${good_a}")
refused("low/a.js: no module imports c" "${good}" "${good_a}export function c() {}\n")
refused("low/b.js: no module imports it" "${good}" "${good_a}" low/b.js "const b = 1;\n")
refused("page.js: 'import \\* as low from './low/a.js'' is not understood; allowed: import {" "import * as low from './low/a.js';\n" "${good_a}")
refused("page.js: 'import './low/a.js'' is not understood; allowed" "import './low/a.js';\n" "${good_a}")
refused("page.js: 'import { a } from 'a'' is not understood; allowed" "import { a } from 'a';\n" "${good_a}")
refused("low/a.js: 'export default 3' is not understood; allowed: export const" "${good}" "${good_a}export default 3;\n")
refused("low/a.js: 'export { a }' is not understood; allowed" "${good}" "const a = 1;\nexport { a };\n")
refused("modules that import one another, or wait for such: low/a.js, low/b.js, page.js" "${good}"
        "import { b } from './b.js';\nexport const a = () => b;\n" low/b.js "import { a } from './a.js';\nexport const b = () => a;\n")

file(REMOVE_RECURSE ${folder})
file(WRITE ${folder}/page.js "${good}")
file(WRITE ${folder}/low/a.js "${good_a}")
join()
file(READ ${WORK}/joined.js joined)
string(SUBSTRING "${good_a}" 7 -1 bare) # good_a without the word `export `
string(FIND "${joined}" "${bare}return { a };" low)
string(FIND "${joined}" "const { a } = modules['low/a.js'];\nconsole.log(a);" high)
if(failed OR low LESS 0 OR high LESS low)
  message(SEND_ERROR "joined wrong: ${said} ${joined}")
endif()

# The folder holds the modules of two scripts, and the test joins one of them. The joined script must contain only the
# modules that it imports. A module that neither script imports must be an error.
macro(join_of_two)
  file(WRITE ${folder}/other.js "import { b } from './low/b.js';\nconsole.log(b);\n")
  file(WRITE ${folder}/low/b.js "export const b = 2;\n")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -D FOLDER=${folder} -D ENTRY=page.js -D ENTRIES=page.js,other.js -D OUTPUT=${WORK}/joined.js
            -P ${SCRIPT}
    RESULT_VARIABLE failed ERROR_VARIABLE said)
endmacro()
join_of_two()
file(READ ${WORK}/joined.js joined)
if(failed OR NOT joined MATCHES "low/a.js" OR joined MATCHES "low/b.js|other.js")
  message(SEND_ERROR "one of two joined wrong: ${said} ${joined}")
endif()
file(WRITE ${folder}/low/c.js "export const c = 3;\n")
join_of_two()
if(NOT failed OR NOT said MATCHES "low/c.js: no module")
  message(SEND_ERROR "a module that neither reaches was joined: ${said}")
endif()
