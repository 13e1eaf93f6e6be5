"""Tests which law isolaw names for devices whose behaviour is known and for measured ones.

Two independent programs gave the expected numbers.
"""

import csv
import importlib.machinery
import importlib.util
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["ISOLAW_SOURCE_DIR"])
PROGRAM = pathlib.Path(os.environ["ISOLAW_BUILD"]) / "cli/isolaw"
BEARING = ROOT.parent / "shared" / "data" / "hdrb-gallardo-device" / "cyclic-24-49-98pct.csv"
LOADER = importlib.machinery.SourceFileLoader("measured_building", str(ROOT / "bench/measured_building"))
building = importlib.util.module_from_spec(importlib.util.spec_from_loader("measured_building", LOADER))
LOADER.exec_module(building)


def elastoplastic(x, stiffness, strength):
    """Returns the force of an elastic-perfectly-plastic spring that starts at rest."""
    force, before, forces = 0.0, 0.0, []
    for value in x:
        force = max(-strength, min(strength, force + stiffness * (value - before)))
        before = value
        forces.append(force)
    return forces


# Each function returns forces in kN for displacements in mm. The two sliders start to slide at 50 kN, after 0.5 mm.
DEVICES = {
    "flat slider": lambda x: elastoplastic(x, 100.0, 50.0),
    "curved slider": lambda x: [f + 0.1 * v for f, v in zip(elastoplastic(x, 100.0, 50.0), x)],
    "lead-rubber": lambda x: [f + 1.0 * v for f, v in zip(elastoplastic(x, 9.0, 90.0), x)],
    "hardening rubber": lambda x: [f + 0.5 * v + 1e-5 * v ** 3 for f, v in zip(elastoplastic(x, 4.0, 40.0), x)],
}
LAWS = "bilinear,bouc-wen,abe-y0,power-masing,ramberg-osgood,menegotto-pinto"


def cycles(amplitudes, count=3, per_cycle=200):
    return [a * math.sin(2.0 * math.pi * i / per_cycle) for a in amplitudes for i in range(count * per_cycle)] + [0.0]


def write_record(file, x, force, interval_s=0.01):
    with open(file, "w", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["time [s]", "displacement [mm]", "force [kN]"])
        rows.writerows((f"{i * interval_s:.4f}", f"{a:.6f}", f"{f:.6f}") for i, (a, f) in enumerate(zip(x, force)))


def last_cycle(x, force, per_cycle=200):
    """Returns the stiffness from peak to peak and the energy of the last cycle."""
    x, force = x[-per_cycle - 1:], force[-per_cycle - 1:]
    high, low = x.index(max(x)), x.index(min(x))
    energy = sum((force[i] + force[i - 1]) / 2.0 * (x[i] - x[i - 1]) for i in range(1, len(x)))
    return (force[high] - force[low]) / (x[high] - x[low]), energy


class Choice(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def isolaw(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True)
        self.assertIn(done.returncode, (0, 1), done.stderr[-2000:])
        return done.stdout

    def calibrate(self, out, *words):
        self.isolaw("calibrate", *words, "--replicates", 0, "--figures", "none", "--out", out)
        return json.loads((self.folder / out / "summary.json").read_text())

    def test_devices_of_other_kinds_get_a_law_that_holds_beyond_their_tests(self):
        draw = random.Random(7)
        tested, beyond = cycles([70.0, 140.0, 200.0]), cycles([300.0])
        for name, force_of in DEVICES.items():
            with self.subTest(name):
                force = force_of(tested)
                noise = 0.02 * max(map(abs, force))
                write_record(self.folder / "d.csv", tested, [f + noise * draw.gauss(0.0, 1.0) for f in force])
                out = name.replace(" ", "-")
                law = self.calibrate(out, "d.csv", "--laws", LAWS)["recommendation"]["law"]
                self.assertIsNotNone(law)
                if name == "hardening rubber":
                    continue
                (self.folder / "m.csv").write_text("time [s],displacement [mm]\n" + "".join(f"{0.01 * i:.4f},{x:.8g}\n" for i, x in enumerate(beyond)))
                text = self.isolaw("simulate", law, "--from", out, "--device", "d", "--motion", "m.csv")
                rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
                place = next(i for i, head in enumerate(rows[0]) if head.startswith("force"))
                found = last_cycle(beyond, [float(row[place]) for row in rows[1:]])
                for value, truth in zip(found, last_cycle(beyond, force_of(beyond))):
                    self.assertLess(abs(value / truth - 1.0), 0.15, f"{law}: {found}")

    def test_a_hold_inside_a_test_changes_nothing(self):
        """One of two equal tests has a pause of sixty seconds. Both must give the same law and nearly equal fits."""
        draw, at = random.Random(3), 700
        x = cycles([60.0]) + cycles([100.0])
        force = DEVICES["lead-rubber"](x)
        for name, hold in (("plain", 0), ("held", 6000)):
            samples = list(zip(x[:at] + [x[at]] * hold + x[at:], force[:at] + [force[at]] * hold + force[at:]))
            write_record(self.folder / f"{name}.csv", [a + 0.01 * draw.gauss(0.0, 1.0) for a, _ in samples],
                         [f + 2.0 * draw.gauss(0.0, 1.0) for _, f in samples])
        found = [self.calibrate(name, f"{name}.csv", "--laws", "bilinear,bouc-wen,ramberg-osgood", "--samples-per-cycle", "all")
                 for name in ("plain", "held")]
        self.assertEqual(*(one["recommendation"]["law"] for one in found))
        for plain, held in zip(*(one["laws"] for one in found)):
            self.assertAlmostEqual(plain["devices"][0]["optimum"], held["devices"][0]["optimum"], delta=1e-3, msg=plain["id"])

    @unittest.skipUnless(building.DATA.exists(), f"no measured data: {building.DATA} is not there")
    def test_rest_after_an_earthquake_counts_for_nothing(self):
        building.Run("ICA50").write_record(self.folder / "run.csv")
        rows = (self.folder / "run.csv").read_text().splitlines()
        last = rows[-1].split(",")
        interval = float(last[0]) - float(rows[-2].split(",")[0])
        rest = [f"{float(last[0]) + interval * i:.4f},{last[1]},{last[2]}" for i in range(1, round(600.0 / interval) + 1)]
        (self.folder / "rested.csv").write_text("\n".join(rows + rest) + "\n")
        fixed = [word for value in ("K1=20", "K2=6", "xy=8") for word in ("--set", f"bilinear.{value}")]
        found = [self.calibrate(name, f"{name}.csv", "--laws", "bilinear", "--dead-band", 0, "--analysis", "none", *fixed)["laws"][0]["devices"][0]
                 for name in ("run", "rested")]
        self.assertAlmostEqual(*(one["objective"]["best"] for one in found), delta=1e-6)
        self.assertGreater(abs(found[0]["objective_by_time"] - found[1]["objective_by_time"]), 0.01)

    @unittest.skipUnless(BEARING.exists(), f"no measured data: {BEARING} is not there")
    def test_the_measured_bearing_has_one_law_in_the_tie(self):
        summary = self.calibrate("bearing", BEARING, "--dt", 0.00215, "--laws", "power-masing-worn,power-masing,power-scragging,abe,history-integral")
        places = {one["law"]: one for one in summary["recommendation"]["standings"]}
        self.assertEqual(summary["recommendation"]["law"], "power-masing-worn")
        self.assertEqual([law for law, one in places.items() if one["place"] == "ties"], [])
        self.assertAlmostEqual(places["power-masing-worn"]["error"], 0.0174, delta=0.0174 * 0.1)

    def test_the_example_lot_is_answered_for_a_device_left_out(self):
        """Fits the paper's laws to one amplitude. Samples count by time, and no swing is larger than the others."""
        self.isolaw("example", "lot")
        summary = self.calibrate("out", "lot", "--laws", "paper")
        wanted = {"jankowski": 0.0419, "hwang-wu": 0.0421, "abe-y0": 0.0441, "abe": 0.0441, "bouc-wen": 0.0461, "vaiana": 0.0440, "bilinear": 0.0657}
        for law in summary["laws"]:
            # Only one run in ten finds vaiana's best fit. The lot's law may therefore depend on the random starts, and
            # the tolerance is wider.
            tolerance = 0.06 if law["id"] == "vaiana" else 0.01
            self.assertAlmostEqual(law["loo_objective"], wanted[law["id"]], delta=tolerance * wanted[law["id"]], msg=law["id"])
            self.assertIsNone(law["larger_swings_objective"])
        self.assertEqual(summary["recommendation"]["law"], "bouc-wen")


if __name__ == "__main__":
    unittest.main()
