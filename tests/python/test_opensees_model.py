"""Tests exported buildings in OpenSeesPy. The isolators have the law itself if the package isolaw is installed.

Otherwise they have the re-fit, the nearest material of OpenSees. isolaw states the response with the re-fit, and
OpenSees must confirm it.
"""

import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

import isolaw
from devices import BINARY, SOURCE, InFolder, program

try:
    import openseespy
except ImportError as error:
    raise unittest.SkipTest(f"skipped: {error} (tools/opensees.sh build/opensees installs it)") from None

OPENSEES = pathlib.Path(openseespy.__file__).parent.parent
PACKAGE = pathlib.Path(isolaw.__file__).parent.parent
# Laws that OpenSees does not have. In this order: a law with a form in two directions, a law without such a form, a law
# that is not odd, and a law that depends on velocity.
LAWS = ["history-integral", "power-masing", "gallardo", "power-masing-viscous"]


class Models(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        program("calibrate", SOURCE / "examples/published-lot/device-01.csv", "--laws", ",".join(LAWS), "--runs", 1,
                "--analysis", "none", "--figures", "none", "--out", "C", cwd=cls.path)
        program("example", "b", "--building", cwd=cls.path)
        (cls.path / "one.csv").write_text("x [m],y [m]\n0,0\n")
        (cls.path / "four.csv").write_text("x [m],y [m]\n0,0\n6,0\n0,5\n6,5\n")

    def exported(self, law, to, *more):
        done = subprocess.run([BINARY, "export", "C", "--law", law, "--device", "device-01", "--to", to, "--anyway", *map(str, more)],
                              cwd=self.path, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def model(self, law, *more, layout="one.csv", mass="160t"):
        """Writes the model of a law to m.py and returns what isolaw said."""
        return self.exported(law, "openseespy-model", "--layout", layout, "--mass", mass, "--axial", "900kN/mm",
                             "--ground-motion", "b/motion-2-x.csv", *more, "--out", "m.py").stderr

    def run_model(self, *arguments, package=PACKAGE, script="m.py"):
        path = os.pathsep.join(str(folder) for folder in (OPENSEES, package) if folder)
        done = subprocess.run([sys.executable, script, *arguments], cwd=self.path, capture_output=True, text=True,
                              timeout=300, env={**os.environ, "PYTHONPATH": path})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def peaks(self, folder):
        """Returns the largest displacement and the largest force of the first isolator with the nominal law."""
        with open(self.path / folder / "peaks.csv", encoding="utf-8") as file:
            row = next(row for row in csv.DictReader(file) if row["case"] == "nominal")
        return [float(value) for name, value in row.items() if name.startswith("largest")]

    def test_the_effect_that_isolaw_states_is_that_in_opensees(self):
        for law in LAWS:
            with self.subTest(law=law):
                stated = json.loads(self.exported(law, "json", "--motion", "b/motion-2-x.csv").stdout)["in_a_building"]
                (motion,) = stated["motions"]
                said = self.model(law, mass=f"{stated['mass_t']!r}t")
                self.assertIn(f"off by {stated['displacement_percent']:+.1f} % and its peak base shear by "
                              f"{stated['shear_percent']:+.1f} % under b/motion-2-x.csv", said)
                self.assertIn("have the law itself", self.run_model("run", "law"))
                self.assertIn("have the re-fit", self.run_model("run", "refit", "--re-fit"))
                of_law, of_refit = self.peaks("law"), self.peaks("refit")
                # isolaw interpolates the peak displacement between steps; OpenSees gives the largest value at a step.
                for found, expected in zip(of_law, (motion["law_displacement"], motion["law_shear"])):
                    self.assertAlmostEqual(found / expected, 1.0, delta=2e-3)
                # OpenSees integrates the re-fit's Bouc-Wen by backward Euler, isolaw exactly.
                for name, law_peak, refit_peak in zip(("displacement_percent", "shear_percent"), of_law, of_refit):
                    self.assertAlmostEqual(100.0 * (refit_peak / law_peak - 1.0), stated[name], delta=0.5)

    def test_the_re_fit_is_taken_where_the_law_cannot_be_had_or_is_not_wanted(self):
        self.model("power-masing")
        said = self.run_model("run", "law")
        self.assertIn(f"The isolators have the law itself, by the Python package isolaw {isolaw.__version__}.", said)
        self.assertEqual((self.path / "law/isolators.txt").read_text(),
                         f"The isolators have the law itself, by the Python package isolaw {isolaw.__version__}.\n")
        self.assertIn("have the re-fit. Why not the law itself: ModuleNotFoundError: No module named 'isolaw'",
                      self.run_model("run", "without", package=None))
        refusing = self.path / "refusing/isolaw"
        refusing.mkdir(parents=True)
        (refusing / "__init__.py").write_text("")
        (refusing / "opensees.py").write_text("def attach(ops):\n    raise ValueError('this OpenSees is another one')\n")
        self.assertIn("have the re-fit. Why not the law itself: ValueError: this OpenSees is another one",
                      self.run_model("run", "refused", package=refusing.parent))
        text = (self.path / "m.py").read_text()
        (self.path / "switched.py").write_text(text.replace("\nRE_FIT = False\n", "\nRE_FIT = True\n"))
        self.assertIn("have the re-fit. Why not the law itself: RE_FIT", self.run_model("run", "switched", script="switched.py"))
        for folder in ("refused", "switched"):
            self.assertEqual(self.peaks("without"), self.peaks(folder))
        self.assertNotEqual(self.peaks("without"), self.peaks("law"))

    def test_the_check_covers_both(self):
        self.model("power-masing-viscous")
        with_law, without = self.run_model(), self.run_model(package=None)
        for said in (with_law, without):
            self.assertIn("isolaw material nominal: largest difference", said)
            self.assertNotIn("FAIL", said)
        self.assertEqual(len(re.findall("isolaw power-masing-viscous nominal: .*: PASS", with_law)), 1)
        self.assertNotIn("isolaw power-masing-viscous", without)
        self.assertNotIn("Warning", with_law)
        # The law is changed in the file, as if isolaw had another version of it. The file must notice this and not use
        # the law.
        text = (self.path / "m.py").read_text()
        (self.path / "other.py").write_text(re.sub(r'(LAW_PARAMETERS = \{\n    "\w+": )', r"\g<1>1.01 * ", text))
        done = subprocess.run([sys.executable, "other.py"], cwd=self.path, capture_output=True, text=True, timeout=300,
                              env={**os.environ, "PYTHONPATH": f"{OPENSEES}{os.pathsep}{PACKAGE}"})
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("have the re-fit. Why not the law itself: its check failed", done.stdout)

    def test_in_two_directions_by_the_law_s_own_form_or_springs(self):
        for law, kind in (("history-integral", "section"), ("power-masing", "section"), ("gallardo", "material")):
            with self.subTest(law=law):
                self.model(law, "--ground-motion-y", "b/motion-2-y.csv", "--scale", 0.2, layout="four.csv", mass="640t")
                build = (self.path / "m.py").read_text().partition("def build(")[2].partition("\ndef ")[0]
                self.assertEqual("isolaw.opensees.section" in build, kind == "section")
                self.assertEqual("law_material(" in build, kind == "material")
                self.assertIn("have the law itself", self.run_model("run", "plane"))
                self.assertNotIn("failed to converge", self.run_model("run", "plane", "nominal"))


if __name__ == "__main__":
    unittest.main()
