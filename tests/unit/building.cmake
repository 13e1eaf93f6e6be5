isolaw_test(unit_building building_integrate_test.cpp building_lanes_test.cpp)
target_link_libraries(unit_building PRIVATE Eigen3::Eigen)
