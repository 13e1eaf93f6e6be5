isolaw_test(unit_num num_random_test.cpp num_statistics_test.cpp)
isolaw_test(unit_opt SANITIZED opt_genetic_operators_test.cpp opt_genetic_test.cpp opt_pareto_test.cpp)
isolaw_test(unit_lot lot_robustness_test.cpp)
