isolaw_test(unit_campaign campaign_settings_test.cpp campaign_store_test.cpp campaign_run_test.cpp campaign_lot_file_test.cpp
            campaign_summary_test.cpp campaign_profile_test.cpp campaign_estimate_test.cpp campaign_merge_test.cpp
            campaign_copies_test.cpp campaign_names_of_tests_test.cpp)
target_link_libraries(unit_campaign PRIVATE SQLite::SQLite3)
