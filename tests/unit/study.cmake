isolaw_test(unit_study SANITIZED study_verdict_test.cpp)
