# Good modules are joined in the order of their imports; bad ones end the build with a message that names file and fault.
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

# refused(WORDS PAGE A [FILE TEXT]...) expects an error that contains WORDS if page.js and low/a.js have the texts PAGE
# and A. Further files may be given.
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
string(SUBSTRING "${good_a}" 7 -1 bare) # without `export `
string(FIND "${joined}" "${bare}return { a };" low)
string(FIND "${joined}" "const { a } = modules['low/a.js'];\nconsole.log(a);" high)
if(failed OR low LESS 0 OR high LESS low)
  message(SEND_ERROR "joined wrong: ${said} ${joined}")
endif()

# Two scripts of one folder each get the modules that they reach. A module that no script reaches is refused.
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
