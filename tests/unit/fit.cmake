isolaw_test(unit_fit fit_objective_test.cpp fit_box_test.cpp fit_kernels_test.cpp fit_springs_test.cpp fit_several_tests_test.cpp bench_best_known_test.cpp
            ${PROJECT_SOURCE_DIR}/bench/best_known.cpp)
target_include_directories(unit_fit PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(unit_fit PRIVATE tomlplusplus::tomlplusplus)
