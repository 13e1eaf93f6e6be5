isolaw_test(unit_analysis analysis_problems_test.cpp analysis_determination_test.cpp analysis_intervals_test.cpp
            analysis_one_law_test.cpp analysis_larger_swings_test.cpp)
