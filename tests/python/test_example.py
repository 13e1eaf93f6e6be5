"""Runs the examples of the documentation."""

import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from devices import BINARY, SOURCE, needs


class Examples(unittest.TestCase):
    def test_the_front_of_the_example_lot(self):
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.run(
                [sys.executable, SOURCE / "examples/python/front.py", "--out", folder, "--laws", "bilinear,bouc-wen",
                 "--runs", "2", "--generations", "5"],
                capture_output=True, text=True, timeout=300,
            )  # fmt: skip
            self.assertEqual(process.returncode, 0, process.stderr)
            with open(pathlib.Path(folder) / "front.csv", newline="") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual([row["law"] for row in rows], ["bilinear", "bouc-wen"])
        for row in rows:
            self.assertGreater(float(row["accuracy"]), 0.0)
            self.assertGreater(float(row["robustness"]), 0.0)
            self.assertIn(row["law"], process.stdout)
        self.assertTrue(any(row["on_front"] == "True" for row in rows))

    def objectives_of(self, example):
        """Runs an example, and returns the objectives of the other package's fit and of isolaw's."""
        process = subprocess.run(
            [sys.executable, SOURCE / "examples/python" / example], capture_output=True, text=True, timeout=300
        )
        self.assertEqual(process.returncode, 0, process.stderr)
        return map(float, re.findall("[0-9.]+(?= with)", process.stdout))

    @needs("scipy")
    def test_least_squares_of_scipy(self):
        scipy, own = self.objectives_of("least_squares.py")
        self.assertLess(scipy, 2.0 * own)  # squares and absolute values have different best fits

    @needs("lmfit")
    def test_lmfit_takes_a_model_as_it_is(self):
        lmfit, own = self.objectives_of("lmfit_fit.py")
        self.assertLess(lmfit, 1.2 * own)

    @needs("pypesto")
    def test_pypesto_takes_a_model_as_it_is(self):
        pypesto, own = self.objectives_of("pypesto_fit.py")
        self.assertLess(pypesto, 1.001 * own)  # both packages minimise the same objective

    def test_a_building_on_the_example_lot(self):
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.run(
                [sys.executable, SOURCE / "examples/python/isolated_building.py", "--draws", "20", "--out", folder],
                capture_output=True, text=True, timeout=300,
            )  # fmt: skip
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertTrue((pathlib.Path(folder) / "building.html").exists())
        verdict = r"^The building file sets no limits, so .* or less in 95 % of 20 drawn buildings"
        self.assertRegex(process.stdout, verdict)
        self.assertEqual(process.stdout.count("a bearing moves"), 7)

    @needs("matplotlib")
    def test_the_page_of_the_documentation(self):
        blocks = re.findall(r"```python\n(.*?)```", (SOURCE / "docs/python.md").read_text(), re.S)
        self.assertGreater(len(blocks), 0)
        with tempfile.TemporaryDirectory() as folder:  # the folder must hold no results of another version
            (pathlib.Path(folder) / "examples").symlink_to(SOURCE / "examples")
            subprocess.run([BINARY, "example", "ex", "--conditions"], cwd=folder, check=True, capture_output=True)
            process = subprocess.run(
                [sys.executable, "-c", "\n".join(blocks)], cwd=folder, capture_output=True, text=True, timeout=300
            )  # fmt: skip
        self.assertEqual(process.returncode, 0, process.stderr)

    def test_every_page_is_in_the_menu_of_the_site(self):
        menu = (SOURCE / "mkdocs.yml").read_text().partition("\nnav:\n")[2]
        pages = {str(page.relative_to(SOURCE / "docs")) for page in (SOURCE / "docs").rglob("*.md")}
        self.assertEqual(pages, set(re.findall(r"[\w/-]+\.md", menu)))


if __name__ == "__main__":
    unittest.main()
