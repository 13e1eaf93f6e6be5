"""Tests what docs/export.md says about steps that do not converge in OpenSees, and the tangent within a dead band."""

import unittest
import warnings

import isolaw
import isolaw.opensees
from devices import InFolder, arrays, write_csv
from test_opensees import LAWS, ops, usual_parameters


def one_bearing(law, source, **keywords):
    """Makes a model of one node on a bearing along direction 1, with a unit load in this direction."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0, "-mass", 1.0)
    ops.fix(1, 1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        isolaw.opensees.material(7, law, source, **keywords)
    ops.element("zeroLength", 1, 1, 2, "-mat", 7, "-dir", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", 1e-8, 50)


def steps_under_load(law, parameters, algorithm, most, count=10):
    """Makes 5 * count steps under loads to +most, -most and +most. Returns how many succeed before one fails."""
    one_bearing(law, parameters)
    path = [0.0, *(most * k / count for k in range(1, count + 1))]
    path += [most * (1.0 - k / count) for k in range(1, 2 * count + 1)]
    path += [most * (k / count - 1.0) for k in range(1, 2 * count + 1)]
    ops.timeSeries("Path", 1, "-dt", 1.0, "-values", *path)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 1.0)
    ops.algorithm(algorithm)
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    for step in range(5 * count):
        if ops.analyze(1) != 0:
            return step
    return 5 * count


class Steps(InFolder):
    def test_under_load_newton_fails_after_a_turn_where_krylov_newton_from_the_start_does_not(self):
        failed = {"Newton": {}, "KrylovNewton": {}}
        for law in ("bouc-wen", "gallardo", "kikuchi-aiken", "power-masing", "ramberg-osgood"):
            parameters = usual_parameters(law)
            force = isolaw.force(law, parameters, isolaw.motion([0.0, 50.0, 100.0], [0.0, 1e9, 2e9]))
            for algorithm, of in failed.items():
                steps = steps_under_load(law, parameters, algorithm, 0.6 * abs(force[-1]))
                if steps < 50:
                    of[law] = steps
        self.assertTrue(failed["Newton"])
        self.assertLessEqual(set(failed["Newton"].values()), {0, 10, 30})  # at the first step or after a turn
        self.assertEqual(failed["KrylovNewton"], {})

    def test_steps_of_displacement_converge_with_newton_for_every_law(self):
        for law in LAWS:
            with self.subTest(law=law):
                one_bearing(law, usual_parameters(law))
                ops.timeSeries("Linear", 1)
                ops.pattern("Plain", 1, 1)
                ops.load(2, 1.0)
                ops.algorithm("Newton")
                ops.integrator("DisplacementControl", 2, 1, 5.0)
                ops.analysis("Static")
                for step, count in ((5.0, 20), (-5.0, 40), (5.0, 40)):
                    ops.integrator("DisplacementControl", 2, 1, step)
                    self.assertEqual(ops.analyze(count), 0)

    def test_every_law_carries_a_load_of_nothing_has_a_mode_and_takes_a_static_and_a_transient_step(self):
        for law in LAWS:
            with self.subTest(law=law):
                parameters = usual_parameters(law)
                at_5_mm = isolaw.force(law, parameters, isolaw.motion([0.0, 2.5, 5.0], [0.0, 1e9, 2e9]))[-1]
                one_bearing(law, parameters)
                ops.timeSeries("Path", 1, "-dt", 1.0, "-values", 0.0, 0.0, 0.5 * at_5_mm, 0.5 * at_5_mm, "-useLast")
                ops.pattern("Plain", 1, 1)
                ops.load(2, 1.0)
                ops.algorithm("KrylovNewton", "-initial")
                ops.integrator("LoadControl", 1.0)
                ops.analysis("Static")
                self.assertEqual(ops.analyze(1), 0)
                self.assertAlmostEqual(ops.nodeDisp(2, 1), 0.0, delta=1e-9)
                mode = ops.eigen("-fullGenLapack", 1)[0]
                self.assertTrue(0.0 < mode < 1e9, mode)
                self.assertEqual(ops.analyze(1), 0)
                self.assertGreater(ops.nodeDisp(2, 1), 0.0)
                ops.wipeAnalysis()
                ops.constraints("Plain")
                ops.numberer("Plain")
                ops.system("FullGeneral")
                ops.test("NormDispIncr", 1e-8, 50)
                ops.algorithm("Newton")
                ops.integrator("Newmark", 0.5, 0.25)
                ops.analysis("Transient")
                self.assertEqual(ops.analyze(1, 0.001), 0)

    def test_a_law_that_ignores_tremor_has_a_first_stiffness_and_a_step_within_its_dead_band(self):
        write_csv(self.path / "a.csv", *arrays(20.0))
        for law in ("gallardo", "ramberg-osgood"):
            with self.subTest(law=law):
                fitted = isolaw.calibrate([self.path / "a.csv"], [law], runs=1, analysis="none", dead_band=0.5)
                one_bearing(law, fitted, device="a")
                self.assertGreater(ops.eigen("-fullGenLapack", 1)[0], 0.0)
                # Under zero load the bearing stays within its dead band.
                ops.timeSeries("Linear", 1)
                ops.pattern("Plain", 1, 1)
                ops.load(2, 0.0)
                ops.algorithm("Newton")
                ops.integrator("LoadControl", 1.0)
                ops.analysis("Static")
                self.assertEqual(ops.analyze(2), 0)


if __name__ == "__main__":
    unittest.main()
