isolaw_test(unit_data data_read_test.cpp data_columns_test.cpp data_refuse_test.cpp data_clean_test.cpp
            data_properties_test.cpp data_cycles_test.cpp data_error_budget_test.cpp data_corrections_test.cpp
            data_selection_test.cpp data_measured_test.cpp data_tests_test.cpp data_json_test.cpp data_workbook_test.cpp
            data_mat_test.cpp data_formats_test.cpp data_confined_test.cpp data_parts_test.cpp data_signals_test.cpp
            data_vertical_test.cpp data_ground_motion_test.cpp data_swings_test.cpp data_several_tests_test.cpp
            data_channel_changes_test.cpp data_blocks_test.cpp data_copies_test.cpp)
# The tests read files that other libraries wrote, so that a mistake in isolaw cannot hide in both reader and writer.
find_library(ISOLAW_XLSXWRITER xlsxwriter REQUIRED)
find_library(ISOLAW_MATIO matio REQUIRED)
target_link_libraries(unit_data PRIVATE ${ISOLAW_XLSXWRITER} ${ISOLAW_MATIO} isolaw::minizip ZLIB::ZLIB isolaw::hdf5)
target_include_directories(unit_data SYSTEM PRIVATE ${ISOLAW_HDF5_INCLUDE})
