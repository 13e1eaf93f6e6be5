# Writes OUTPUT, which defines isolaw::app::source_commit, the commit of the sources in ROOT: "8394911", or "8394911, modified"
# if a file that git follows was changed since. Archives made by `git archive` carry their commit in cmake/COMMIT; a copy
# without either is of an "unknown commit". OUTPUT is only written if it changes, so that nothing is compiled in vain.
# cmake -DROOT=... -DOUTPUT=... -P commit.cmake
set(commit "unknown commit")
file(STRINGS ${ROOT}/cmake/COMMIT packed LIMIT_COUNT 1)
if(packed MATCHES "^[0-9a-f]+$")
  set(commit ${packed})
elseif(EXISTS ${ROOT}/.git)  # not the commit of a repository around an unpacked archive
  find_program(git git)
  if(git)
    execute_process(COMMAND ${git} -C ${ROOT} rev-parse --short HEAD RESULT_VARIABLE failed OUTPUT_VARIABLE head
                    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    execute_process(COMMAND ${git} --no-optional-locks -C ${ROOT} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT failed)
      set(commit ${head})
      if(changes)
        string(APPEND commit ", modified")
      endif()
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
     "namespace isolaw::app {\nextern char const* const source_commit;\nchar const* const source_commit = \"${commit}\";\n}\n")
