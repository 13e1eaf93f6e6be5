find_package(EXPAT REQUIRED)  # figures are read as XML
isolaw_test(unit_report SANITIZED report_json.cpp report_latex.cpp report_doubtful.cpp report_figures.cpp report_tables.cpp report_terminal.cpp report_page.cpp report_verdict.cpp report_write.cpp)
target_link_libraries(unit_report PRIVATE nlohmann_json::nlohmann_json EXPAT::EXPAT)
