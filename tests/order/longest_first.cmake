# CTest reads this file after all tests are known. Tests that a build lacks are passed over.
foreach(test IN ITEMS
        bench.choice bench.measured_building bench.campaigns bench.building
        cli.InOpenSees.exports_of_the_measured_bearing cli.InOpenSees.exports_of_the_example_lot
        regression.aarch64
        cli.Agreement.simulate_header_and_table_of_every_law_agree_at_every_step
        unit_programs.InTime.elements_give_the_force_of_the_replay
        verification.ConvergedIntegration.HoldsOnTheExampleLot
        cli.slurm python.interrupt python.campaign
        cli_fault.Fault.starting_over_does_not_take_the_former_log_for_its_own
        cli_fault.Fault.a_kill_while_starting_over_leaves_one_of_both
        cli_fault.Fault.a_campaign_killed_again_and_again_ends_like_one_that_was_not)
  set_tests_properties(${test} PROPERTIES COST 400)
endforeach()
