# isolaw_embed(TARGET FUNCTION BASE FILES...) puts the names and texts of the files into TARGET as a table. The C++
# function `std::span<isolaw::Embedded const> FUNCTION()` (base/embedded.hpp) returns the table in the order of FILES.
# The name of a file below BASE is its path relative to BASE. Any other file is named without its folder. If a file
# changes, the next build writes the table again.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(isolaw_embed_script ${CMAKE_CURRENT_LIST_FILE})
  function(isolaw_embed target function base)
    string(REPLACE "::" "_" file ${function})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${file}.cpp)
    list(JOIN ARGN "|" files)
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DFUNCTION=${function} -DBASE=${base} "-DFILES=${files}" -DOUTPUT=${source} -P ${isolaw_embed_script}
      DEPENDS ${ARGN} ${isolaw_embed_script} VERBATIM COMMENT "Embedding ${function}")
    # TARGET may be in another folder, where CMake does not know this custom command. The custom target below is known
    # in all folders.
    add_custom_target(${file} DEPENDS ${source})
    add_dependencies(${target} ${file})
    target_sources(${target} PRIVATE ${source})
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES GENERATED ON SKIP_PRECOMPILE_HEADERS ON)
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
  # No character is special in a raw string. GCC and clang accept raw strings of any length.
  string(APPEND table "    {\"${named}\", R\"_embedded_(${text})_embedded_\"sv},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"isolaw/base/embedded.hpp\"\n\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\n"
  "namespace ${namespace} {\n\nusing namespace std::string_view_literals;\n\nstd::span<Embedded const> ${name}();\n\n"
  "std::span<Embedded const> ${name}() {\n  static constexpr Embedded files[] = {\n${table}  };\n  return files;\n}\n\n"
  "}  // namespace ${namespace}\n")
