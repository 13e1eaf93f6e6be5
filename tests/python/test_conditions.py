"""Tests isolaw.conditions: its numbers must be those of the program and of closed forms."""

import json
import pathlib
import subprocess
import tempfile
import unittest
from xml.etree import ElementTree

import isolaw
from devices import BINARY, needs


class Conditions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.lot = pathlib.Path(folder.name) / "ex/lot.toml"
        subprocess.run([BINARY, "example", cls.lot.parent, "--conditions"], check=True, capture_output=True)
        cls.study = isolaw.conditions(cls.lot)

    def test_the_results_are_those_of_the_program(self):
        program = subprocess.run([BINARY, "conditions", self.lot, "--json"], capture_output=True, text=True)
        self.assertEqual(self.study.results, json.loads(program.stdout))
        shown = ElementTree.fromstring(self.study._repr_html_())
        self.assertEqual(shown.text, str(self.study))

    # The numbers follow from the closed form by which the records of the example were computed.
    def test_bounds_and_levels_are_those_of_the_closed_form(self):
        bounds = {(row["quantity"], end): row[end] for row in self.study.results["bounds"] for end in ("max", "min")}
        for key, number in {("K_eff", "max"): 1.869155861, ("K_eff", "min"): 0.705430235,
                            ("energy", "max"): 1.859391152, ("energy", "min"): 0.665827352}.items():  # fmt: skip
            self.assertAlmostEqual(bounds[key]["factor"] / number, 1.0, delta=1e-3)
            self.assertEqual(self.study.bounds[key[0]][key[1]], bounds[key])
        rates = {row["at"]: row["factor"]["lambda"] for row in self.study.levels
                 if (row["quantity"], row["effect"]) == ("K_eff", "rate")}  # fmt: skip
        self.assertEqual(len(rates), 2)
        for at, number in zip(sorted(rates), (0.927280900, 1.067708704)):
            self.assertAlmostEqual(rates[at] / number, 1.0, delta=1e-3)

    # The tables of a lot file may be given as a dict and its tests as isolaw.Test. The results must be those of the
    # file.
    @needs("tomllib")  # of Python 3.11
    def test_tables_give_what_the_lot_file_gives(self):
        import tomllib

        tables = tomllib.loads(self.lot.read_text())
        for device in tables["device"]:
            device["test"] = [
                isolaw.Test(test.pop("file"), **{key.replace("-", "_"): value for key, value in test.items()})
                for test in device["test"]
            ]
        study = isolaw.conditions(tables, folder=self.lot.parent)
        self.assertEqual(study.results, self.study.results)

    def test_wrong_tables_name_the_device_and_the_test(self):
        def study(**wrong):
            test = isolaw.Test("p1-warm.csv", order=1, temperature_C=20) | wrong
            return isolaw.conditions(
                {"conditions": {"reference": {"temperature-C": 20}}, "device": [{"name": "P1", "test": [test]}]},
                folder=self.lot.parent,
            )

        for wrong, message in {
            ("rest-h", -1): "lot, 'P1', 'p1-warm.csv': .*rest-h.*0 or more",
            ("temperature-X", 20): "lot, 'P1', 'p1-warm.csv': .*temperature-X",
            ("file", "../p1.csv"): "lot, 'P1', '../p1.csv': .*outside",
            ("order", "first"): "lot, 'P1', 'p1-warm.csv': .*order.*first",
        }.items():
            with self.assertRaisesRegex(isolaw.Error, message):
                study(**dict([wrong]))
        with self.assertRaisesRegex(isolaw.Error, r"no table \[conditions\]"):
            isolaw.conditions({"device": [{"file": "p1-warm.csv"}]}, folder=self.lot.parent)
        with self.assertRaises(TypeError):
            isolaw.Test("p1-warm.csv", order=1, temperature=20)

    # A test that lacks its temperature or its record must be refused with the reason, and the other tests must count.
    @needs("tomllib")  # of Python 3.11
    def test_a_test_that_cannot_be_used_says_why(self):
        import tomllib

        tables = tomllib.loads(self.lot.read_text())
        tables["device"][0]["test"][1].pop("temperature-C")
        tables["device"][1]["test"][1]["file"] = "no-such.csv"
        refused = isolaw.conditions(tables, folder=self.lot.parent).results["refused"]
        self.assertEqual({row["device"] for row in refused}, {"P1", "P2"})
        self.assertIn("temperature", str(refused[0]))
        self.assertIn("no-such.csv", str(refused[1]))

    def test_the_plan_has_the_twelve_tests_that_are_missing(self):
        self.assertEqual(len(self.study.plan()), 12)
        self.assertGreater(len(self.study.plan(devices=3)), 12)
        with self.assertRaisesRegex(isolaw.Error, "devices: 0"):
            self.study.plan(devices=0)

    def test_the_value_of_p6_at_reference_is_the_true_one(self):
        row = next(row for row in self.study.at_reference if (row["device"], row["quantity"]) == ("P6", "K_eff"))
        self.assertAlmostEqual(row["measured"] / 0.603681447, 1.0, delta=1e-3)
        self.assertAlmostEqual(row["at_reference"] / 0.677589534, 1.0, delta=2e-3)

    def test_it_shows_what_the_program_prints(self):
        program = subprocess.run([BINARY, "conditions", self.lot], capture_output=True, text=True)
        self.assertEqual(str(self.study).strip(), program.stdout.strip())
        self.assertEqual(repr(self.study), "<isolaw.Conditions of 26 tests of 6 devices>")

    def test_observations_are_rows_for_pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        frame = pandas.DataFrame(self.study.observations)
        self.assertEqual(set(frame["device"]), {f"P{i}" for i in range(1, 7)})

    def test_wrong_input_is_one_error(self):
        with self.assertRaisesRegex(isolaw.Error, "no-such.toml"):
            isolaw.conditions("no-such.toml")
        text = self.lot.read_text()
        for wrong, message in {
            text.replace("temperature-C = -20", "temperature-X = -20", 1): "temperature-X",
            text.replace("order = 1", "order = 'first'", 1): "order",
            "[[device]]\nfile = 'p1.csv'\n": r"no table \[conditions\]",
        }.items():
            self.assertNotEqual(wrong, text)
            file = self.lot.with_name("wrong.toml")
            file.write_text(wrong)
            with self.assertRaisesRegex(isolaw.Error, message):
                isolaw.conditions(file)


if __name__ == "__main__":
    unittest.main()
