# Compiles tests/unit/elementary_arrays.cpp once for each instruction set. The unit test and the benchmark use these
# objects.
include_guard(GLOBAL)
add_library(elementary_arrays INTERFACE)
function(elementary_table set)
  add_library(elementary_${set} OBJECT ${PROJECT_SOURCE_DIR}/tests/unit/elementary_arrays.cpp)
  target_include_directories(elementary_${set} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(elementary_${set} PRIVATE ISOLAW_ELEMENTARY_TABLE=elementary_${set})
  target_link_libraries(elementary_${set} PRIVATE isolaw_warnings)
  # The compiler turns the loops of this source into vector code only with -O3, so -O3 is set in every build type.
  target_compile_options(elementary_${set} PRIVATE ${ARGN} -O3 -fno-math-errno -fno-trapping-math -fno-signed-zeros
                         $<$<CXX_COMPILER_ID:GNU>:-fschedule-insns -fsched-pressure>)
  # isolaw_warnings sets -ffp-contract=off, which forbids fused multiply-adds. The option of a source file comes later
  # on the command line than those of its target, so -ffp-contract=fast wins.
  set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/unit/elementary_arrays.cpp
                              TARGET_DIRECTORY elementary_${set} PROPERTIES COMPILE_OPTIONS -ffp-contract=fast)
  target_link_libraries(elementary_arrays INTERFACE $<TARGET_OBJECTS:elementary_${set}>)
endfunction()
elementary_table(baseline)
elementary_table(v3 -march=x86-64-v3)
elementary_table(v4 -march=x86-64-v4 -mprefer-vector-width=512)
