# isolaw_embed(TARGET FUNCTION BASE FILES...): the files as a table of names and texts in TARGET, which the function of that
# name, `std::span<isolaw::Embedded const> FUNCTION()` (base/embedded.hpp), returns in the order given. A file below BASE is
# named by its path from there, another by its last part. A changed file makes the table again, at build time.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(isolaw_embed_script ${CMAKE_CURRENT_LIST_FILE})
  function(isolaw_embed target function base)
    string(REPLACE "::" "_" file ${function})
    set(made ${CMAKE_CURRENT_BINARY_DIR}/${file}.cpp)
    list(JOIN ARGN "|" files)
    add_custom_command(OUTPUT ${made}
      COMMAND ${CMAKE_COMMAND} -DFUNCTION=${function} -DBASE=${base} "-DFILES=${files}" -DMADE=${made} -P ${isolaw_embed_script}
      DEPENDS ${ARGN} ${isolaw_embed_script} VERBATIM COMMENT "Embedding ${function}")
    # TARGET may be of another folder, which does not see the command.
    add_custom_target(${file} DEPENDS ${made})
    add_dependencies(${target} ${file})
    target_sources(${target} PRIVATE ${made})
    set_source_files_properties(${made} TARGET_DIRECTORY ${target} PROPERTIES GENERATED ON SKIP_PRECOMPILE_HEADERS ON)
  endfunction()
  return()
endif()

string(REGEX REPLACE "::[^:]*$" "" namespace ${FUNCTION})
string(REGEX REPLACE ".*::" "" name ${FUNCTION})
string(REPLACE "|" ";" FILES "${FILES}")
set(table "")
foreach(file IN LISTS FILES)
  cmake_path(IS_PREFIX BASE ${file} NORMALIZE below)
  if(below)
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${BASE} OUTPUT_VARIABLE named)
  else()
    cmake_path(GET file FILENAME named)
  endif()
  file(READ ${file} text)
  # Raw, so that nothing in the text means anything; one literal, which GCC and clang take at any length.
  string(APPEND table "    {\"${named}\", R\"_embedded_(${text})_embedded_\"sv},\n")
endforeach()
file(WRITE ${MADE} "#include \"isolaw/base/embedded.hpp\"\n\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\n"
  "namespace ${namespace} {\n\nusing namespace std::string_view_literals;\n\nstd::span<Embedded const> ${name}();\n\n"
  "std::span<Embedded const> ${name}() {\n  static constexpr Embedded files[] = {\n${table}  };\n  return files;\n}\n\n"
  "}  // namespace ${namespace}\n")
