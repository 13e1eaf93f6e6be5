# Writes the C++ source OUTPUT, which defines isolaw::app::source_commit: the commit of the sources in ROOT, for example
# "8394911", or "8394911, modified" if a file under version control was changed since. `git archive` writes the commit
# into cmake/COMMIT. If that file has no commit and ROOT has no .git, the text is "unknown commit". OUTPUT is only
# written if it changes, so that an unchanged commit compiles nothing again.
# cmake -DROOT=... -DOUTPUT=... -P commit.cmake
set(commit "unknown commit")
file(STRINGS ${ROOT}/cmake/COMMIT packed LIMIT_COUNT 1)
if(packed MATCHES "^[0-9a-f]+$")
  set(commit ${packed})
elseif(EXISTS ${ROOT}/.git)  # else git would find a repository around an unpacked archive
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
