isolaw_test(unit_programs programs_untested_motions_test.cpp programs_export_test.cpp programs_model_test.cpp
  programs_opensees_model_test.cpp programs_opensees_test.cpp programs_response_test.cpp programs_run_test.cpp programs_user_test.cpp)
# The tests compile exported headers with the compiler of the build.
target_compile_definitions(unit_programs PRIVATE ISOLAW_COMPILER="${CMAKE_CXX_COMPILER}"
  ISOLAW_PROGRAMS_STAND_INS="${CMAKE_CURRENT_SOURCE_DIR}")
