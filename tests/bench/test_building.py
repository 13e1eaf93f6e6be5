"""Runs bench/building with a fake program that prints fixed times, and checks rows and ratios of its table."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["ISOLAW_SOURCE_DIR"])
TOLD = """#!/bin/sh
echo '{"instruction_set": "avx2", "lanes_wall_s": 2.5, "lanes_cpu_s": 4.0, "scalar_draws": 8, "scalar_s": 0.75, "implicit_s": 1.5}'
"""


class Building(unittest.TestCase):
    def test_times_and_the_ratio_to_the_scalar_loop_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            build = pathlib.Path(folder)
            (build / "cli").mkdir()
            (build / "bench").mkdir()
            (build / "cli/isolaw").symlink_to(pathlib.Path(os.environ["ISOLAW_BUILD"]) / "cli/isolaw")
            (build / "bench/building_bench").write_text(TOLD)
            (build / "bench/building_bench").chmod(0o755)
            file = build / "times.csv"
            done = subprocess.run([sys.executable, ROOT / "bench/building", "--quick", "--build", build, "--out", file],
                                  capture_output=True, text=True)  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            text = file.read_text()
        self.assertIn("# cpu", [line.split(":")[0] for line in text.splitlines() if line.startswith("# ")])
        rows = list(csv.DictReader(line for line in text.splitlines() if not line.startswith("# ")))
        self.assertEqual([row["part"] for row in rows], 2 * ["lanes", "scalar", "implicit"])
        lanes, scalar, implicit = rows[:3]
        self.assertEqual((lanes["wall_s"], lanes["threads"], lanes["draws"], lanes["motions"]), ("2.5", "2", "16", "1"))
        self.assertEqual((float(lanes["ms_each"]), float(lanes["over_scalar"])), (250.0, 3.0))
        self.assertEqual((float(scalar["ms_each"]), float(implicit["ms_each"])), (750.0, 1500.0))


if __name__ == "__main__":
    unittest.main()
