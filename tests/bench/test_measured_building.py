"""Computes again the numbers of docs/measured-building.md on the law that isolaw names."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import re
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["ISOLAW_SOURCE_DIR"])
LOADER = importlib.machinery.SourceFileLoader("measured_building", str(ROOT / "bench/measured_building"))
measured = importlib.util.module_from_spec(importlib.util.spec_from_loader("measured_building", LOADER))
LOADER.exec_module(measured)
PAGE = (ROOT / "docs/measured-building.md").read_text()


NAMED = re.search(r"isolaw names `(.+?)`", PAGE)[1]
LAWS = [NAMED, "power-masing", "ozdemir"]


def said(law):
    """Returns the errors that the page states for a law, in percent: displacement and roof in SP100, then in ICA100."""
    row = re.search(rf"^\| `{law}`.*$", PAGE, re.MULTILINE)[0]
    cells = [cell.strip() for cell in row.strip("| ").split("|")]
    return [float(cells[i]) for i in (3, 4, 7, 8)]


@unittest.skipUnless(measured.DATA.exists(), f"no measured data: {measured.DATA} is not there")
class MeasuredBuilding(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        folder = pathlib.Path(cls.folder.name)
        cls.runs = {name: measured.Run(name) for name in measured.FITTED + measured.PREDICTED}
        for name in measured.PREDICTED:
            measured.write_motion(folder / f"{name}.csv", [cls.runs[name]])
        program = measured.Program(pathlib.Path(os.environ["ISOLAW_BUILD"]) / "cli/isolaw", folder)
        cls.summary = program.calibrate("two-runs", [cls.runs[name] for name in measured.FITTED], LAWS)
        period = measured.period_of(cls.runs)
        histories = program.shake("floors", "two-runs", LAWS, period, measured.PREDICTED)
        cls.errors = {law: [measured.Errors(histories[law][name], cls.runs[name]) for name in measured.PREDICTED] for law in LAWS}

    def test_the_page_says_what_is_computed(self):
        for law, errors in self.errors.items():
            computed = [value for e in errors for value in (e.disp, e.roof)]
            for found, stated in zip(computed, said(law)):
                self.assertAlmostEqual(found, stated, delta=1.5, msg=f"{law}: {computed} and {said(law)}")

    def test_the_two_runs_are_tests_of_one_device(self):
        device, = self.summary["devices"]
        self.assertEqual([test["name"] for test in device["tests"]], ["CNP100", "ICA50"])
        for law in self.summary["laws"]:
            fit, = law["devices"]
            mean = sum(test["objective"] for test in fit["tests"]) / 2.0
            self.assertAlmostEqual(mean, fit["objective"]["best"], delta=1e-9)

    def test_errors_are_those_of_two_independent_programs(self):
        """Each error is the mean of two independent programs, which differ by 5 % (fits) or 10 % (predictions)."""
        for law, fits, predicts in (("power-masing-viscous", 0.0615, 0.0775), ("power-masing", 0.0695, 0.0995), ("ozdemir", 0.0855, 0.127)):
            fit = next(one for one in self.summary["laws"] if one["id"] == law)["devices"][0]
            self.assertAlmostEqual(fit["optimum"], fits, delta=0.05 * fits, msg=law)
            self.assertAlmostEqual(fit["larger_swings_objective"], predicts, delta=0.1 * predicts, msg=law)

    def test_the_law_named_predicts_the_displacement_of_a_run_twice_as_large(self):
        self.assertEqual(self.summary["recommendation"]["law"], "power-masing-viscous")
        self.assertEqual(NAMED, "power-masing-viscous")
        places = {one["law"]: one["place"] for one in self.summary["recommendation"]["standings"]}
        self.assertEqual(places["ozdemir"], "behind")
        for error in self.errors[NAMED]:
            self.assertLess(abs(error.disp), 10.0)
        self.assertGreater(self.errors["ozdemir"][1].disp, 10.0)
        self.assertGreater(measured.peak(self.runs["ICA100"].disp_mm),
                           1.9 * max(measured.peak(self.runs[name].disp_mm) for name in measured.FITTED))

    def test_the_levels_are_turned_in_the_runs_named_after_ica(self):
        """The files of these runs number the levels from the roof down, and the script must turn them round.

        Below its first mode a building moves more at the roof than at the base.
        """
        self.assertEqual([name for name, run in self.runs.items() if run.turned], ["ICA50", "ICA100"])
        for run in self.runs.values():
            self.assertGreater(abs(measured.transfer(run.roof, run.acceleration[0], 0.6)), 1.15)


if __name__ == "__main__":
    unittest.main()
