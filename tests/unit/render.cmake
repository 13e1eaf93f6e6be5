find_package(EXPAT REQUIRED)  # reads the SVG figures as XML
isolaw_test(unit_render render_json_test.cpp render_latex_test.cpp render_doubtful_test.cpp render_figures_test.cpp
            render_tables_test.cpp render_terminal_test.cpp render_page_test.cpp render_symbols_test.cpp render_write_test.cpp render_building_test.cpp)
target_link_libraries(unit_render PRIVATE nlohmann_json::nlohmann_json EXPAT::EXPAT Eigen3::Eigen)
