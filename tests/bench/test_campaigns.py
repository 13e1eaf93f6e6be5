"""Runs bench/campaigns on the cheapest law. All parts write rows, and the phases add up to the campaign."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["ISOLAW_SOURCE_DIR"])
MEASURED = (ROOT.parent / "shared/data/hdrb-gallardo-device/cyclic-24-49-98pct.csv").exists()


def campaigns(*words):
    return subprocess.run([sys.executable, ROOT / "bench/campaigns", "--build", os.environ["ISOLAW_BUILD"], *words],
                          capture_output=True, text=True)  # fmt: skip


class Campaigns(unittest.TestCase):
    def test_every_part_tells_what_a_campaign_and_its_phases_took(self):
        parts = ["third-stage", "lot-best", "lot-ga", "devices-100"]
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "times.csv"
            done = campaigns("--quick", "--laws", "bilinear", "--parts", ",".join(parts), "--out", file)
            self.assertEqual(done.returncode, 0, done.stderr)
            text = file.read_text()
        machine = [line.split(":")[0] for line in text.splitlines() if line.startswith("# ")]
        self.assertIn("# cpu", machine)
        rows = list(csv.DictReader(line for line in text.splitlines() if not line.startswith("# ")))
        self.assertEqual(list(dict.fromkeys(row["part"] for row in rows)), parts)
        for part in parts if MEASURED else parts[1:]:
            whole, *phases = [row for row in rows if row["part"] == part]
            devices = {"third-stage": "1", "devices-100": "4"}.get(part, "10")
            method = "ga" if part == "lot-ga" else "best"
            self.assertEqual((whole["phase"], whole["devices"], whole["method"]), ("all", devices, method))
            lot = ["lot", "left_out"] if devices != "1" else []
            analyses = ["determination", "intervals", *lot] if part != "devices-100" else []
            self.assertEqual([row["phase"] for row in phases], ["read", "search", *analyses, "report"])
            # The table rounds times to four digits but gives the numbers of evaluations exactly.
            kernels = sum(float(row["kernel_s"]) for row in phases)
            self.assertAlmostEqual(kernels / float(whole["kernel_s"]), 1.0, delta=0.01)
            self.assertEqual(sum(int(row["evaluations"]) for row in phases), int(whole["evaluations"]))
            # The campaign's own CPU time also contains the start and end of the process, which belong to no phase.
            self.assertGreaterEqual(1.01 * float(whole["cpu_s"]) + 0.01, sum(float(row["cpu_s"]) for row in phases))
            ratio = float(whole["cpu_s"]) / float(whole["kernel_s"])
            self.assertAlmostEqual(float(whole["cpu_over_kernel"]) / ratio, 1.0, delta=0.01)

    def test_parts_that_are_none_are_refused(self):
        done = campaigns("--parts", "lot-best,lots")
        self.assertEqual(done.returncode, 2)
        self.assertIn("unknown part lots; allowed: bearing, third-stage, lot-best", done.stderr)


if __name__ == "__main__":
    unittest.main()
