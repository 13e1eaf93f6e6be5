# Runs the library's example and the program on one record. The two must give the same objectives of two laws, and the
# example must say that the law with the smaller objective is the better one.
# Usage: cmake -DEXAMPLE=... -DISOLAW=... -DRECORD=... -P same_as_program.cmake
execute_process(COMMAND ${EXAMPLE} ${RECORD} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${EXAMPLE} no-such-file.csv RESULT_VARIABLE code ERROR_VARIABLE error OUTPUT_QUIET)
if(NOT code EQUAL 2 OR NOT error MATCHES "no-such-file.csv: no such file")
  message(FATAL_ERROR "a missing record: ${code}: ${error}")
endif()
# The seed of a run depends on the device's name, and the program names a device after its file. The record is therefore
# copied to the name that the example gives its device.
configure_file(${RECORD} bearing.csv COPYONLY)
execute_process(COMMAND ${ISOLAW} calibrate bearing.csv --laws bilinear,bouc-wen --analysis none --out campaign --fresh --json
                OUTPUT_VARIABLE summary ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(least 1e9)
foreach(i 0 1)
  string(JSON law GET "${summary}" laws ${i} id)
  string(JSON objective GET "${summary}" laws ${i} objective best)
  string(REGEX MATCH "${law} +objective ([0-9.]+)" line "${printed}")
  # The example prints its objective to six decimals. Cut both objectives to five, so that rounding does not matter.
  string(SUBSTRING "${CMAKE_MATCH_1}" 0 7 shown)
  string(SUBSTRING "${objective}" 0 7 expected)
  if(NOT shown STREQUAL expected)
    message(FATAL_ERROR "${law}: ${shown} printed, ${objective} by the program\n${printed}")
  endif()
  if(objective LESS least)
    set(least ${objective})
    set(better ${law})
  endif()
endforeach()
if(NOT printed MATCHES "better: ${better}\n" OR NOT printed MATCHES "largest force under half of it: [0-9.]+ kN")
  message(FATAL_ERROR "not what is expected:\n${printed}")
endif()
