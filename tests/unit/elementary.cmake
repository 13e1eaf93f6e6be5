include(${PROJECT_SOURCE_DIR}/cmake/elementary_arrays.cmake)
isolaw_test(unit_elementary num_elementary_test.cpp)
target_link_libraries(unit_elementary PRIVATE elementary_arrays)
