isolaw_test(unit_data SANITIZED data_read_test.cpp data_columns_test.cpp data_refuse_test.cpp data_clean_test.cpp
            data_properties_test.cpp data_measured_test.cpp)
