# Writes the C++ source OUTPUT, which defines isolaw::app::source_commit: the commit of the sources in ROOT, for example
# "commit 8394911", or "commit 8394911, modified" if a file under version control was changed since. In an archive of
# the sources, `git archive` has written the commit into cmake/COMMIT. If neither that file nor ROOT/.git gives a commit,
# the text is "unknown commit". An unchanged OUTPUT is not written again, so that nothing is compiled again.
# cmake -DROOT=... -DOUTPUT=... -P commit.cmake
set(commit "unknown commit")
file(STRINGS ${ROOT}/cmake/COMMIT packed LIMIT_COUNT 1)
if(packed MATCHES "^[0-9a-f]+$")
  set(commit "commit ${packed}")
# git is asked only if ROOT has its own .git. Otherwise git might find another repository in a folder above ROOT and
# return the commit of that one.
elseif(EXISTS ${ROOT}/.git)
  find_program(git git)
  if(git)
    execute_process(COMMAND ${git} -C ${ROOT} rev-parse --short HEAD RESULT_VARIABLE failed OUTPUT_VARIABLE head
                    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    execute_process(COMMAND ${git} --no-optional-locks -C ${ROOT} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT failed)
      set(commit "commit ${head}")
      if(changes)
        string(APPEND commit ", modified")
      endif()
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
     "namespace isolaw::app {\nextern char const* const source_commit;\nchar const* const source_commit = \"${commit}\";\n}\n")
