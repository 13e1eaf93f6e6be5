isolaw_test(unit_fit fit_objective_test.cpp fit_box_test.cpp fit_kernels_test.cpp fit_best_known_test.cpp)
