"""Tests isolaw.building: the same bytes as the program, motions and buildings from memory, and refusals."""

import unittest

import numpy as np

import isolaw
from devices import InFolder, files_in, program, write_csv

SLAB = {"mass_Mg": 400.0, "gyration_m": 6.0}
PLAN = {
    "building": {"lower": 0.9, "upper": 1.1, "laws": ["bilinear"], "draws": 12, "rest_s": 1.0},
    "base": SLAB,
    "floors": {"count": 2, **SLAB, "period_x_s": 0.3, "period_y_s": 0.3},
    "grid": {"along": 3, "across": 2, "spacing_x_m": 6.0, "spacing_y_m": 6.0},
}


def ground(number, samples=400):
    t = 0.02 * np.arange(samples)
    return 2.0 * np.sin(2.5 * t + number) * np.sin(np.pi * t / t[-1])


class Study(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        files = files_in(cls.path / "r", (20.0, 22.0, 19.0))
        cls.lot = isolaw.calibrate(files, "bilinear", runs=1, replicates=40, out=cls.path / "lot")
        for number in (1, 2):
            for axis in "xy":
                write_csv(cls.path / f"m{number}{axis}.csv", 0.02 * np.arange(400), ground(number + (axis == "y")),
                          header="time [s],acceleration [m/s2]")  # fmt: skip

    def test_a_file_ends_as_by_the_program(self):
        text = "".join(
            f"[{name}]\n" + "".join(f"{key} = {str(value).lower() if isinstance(value, bool) else repr(value)}\n"
                                    for key, value in keys.items())
            for name, keys in PLAN.items())  # fmt: skip
        for number in (1, 2):
            text += f'[[motion]]\nx = "m{number}x.csv"\ny = "m{number}y.csv"\n'
        (self.path / "b.toml").write_text(text)
        program("building", "b.toml", "--from", "lot", "--out", "P", "--figures", "none", "--jobs", "1", cwd=self.path)
        told = []
        building = isolaw.building(self.path / "b.toml", self.path / "lot", out=self.path / "Y", jobs=2,
                                   progress=lambda done, total: told.append((done, total)))  # fmt: skip
        for name in ("building.sqlite", "building.json", "building.html", "tables/building.csv"):
            self.assertEqual((self.path / "P" / name).read_bytes(), (self.path / "Y" / name).read_bytes(), name)
        self.assertEqual(told[-1][0], told[-1][1])
        self.assertEqual(building.results["laws"][0]["draws"], 12)
        self.assertIn(building.results["verdict"][:30], building._repr_html_())
        # Builds the same building from arrays instead of files. The motions in memory have no names, so isolaw gives
        # them names.
        arrays_of = isolaw.building(PLAN, self.lot, [(0.02, ground(1), ground(2)), (0.02, ground(2), ground(3))])
        np.testing.assert_array_equal(arrays_of.peaks(), building.peaks())
        self.assertEqual(arrays_of.motions, ["motion 1", "motion 2"])
        pairs = isolaw.building(PLAN, self.lot, [(self.path / f"m{k}x.csv", self.path / f"m{k}y.csv") for k in (1, 2)])
        np.testing.assert_array_equal(pairs.peaks(), building.peaks())

    def test_arrays_are_what_is_answered(self):
        building = isolaw.building(PLAN, self.lot, [(0.02, ground(1), ground(2)), (0.02, ground(2))], draws=20, seed=3)
        self.assertEqual((building.laws, building.results["draws"], building.results["seed"]), (["bilinear"], 20, 3))
        peaks = building.peaks()
        self.assertEqual(peaks.shape, (1, 20, 2))
        law = building.results["laws"][0]
        self.assertAlmostEqual(np.quantile(peaks.mean(axis=2), 0.5), law["peak_mm"]["p50"], places=9)
        np.testing.assert_array_equal(building.displacements_mm.max(axis=3), peaks)
        np.testing.assert_array_equal(building.drifts_mm.max(axis=3), building.peaks("drift_mm"))
        self.assertEqual((building.displacements_mm.shape, building.drifts_mm.shape), ((1, 20, 2, 6), (1, 20, 2, 2)))
        roof_g = building.accelerations_mm_s2[..., -1] / 9806.65
        np.testing.assert_allclose(roof_g, building.peaks("roof_acceleration_g"))
        with self.assertRaises(ValueError):
            building.drifts_mm[0, 0, 0, 0] = 1.0
        inside = building.coverage["isolator_mm"]
        self.assertEqual(inside["inside"][0], law["coverage"]["inside"])
        self.assertTrue(inside["lower"][0] <= inside["inside"][0] <= inside["upper"][0])
        covered = {key for key, row in building.quantities.items() if row["uncovered"] is None}
        self.assertEqual(set(building.coverage), covered)
        history = building.history("bilinear", 0)
        steps = len(history["time_s"])
        self.assertEqual(history["outcome"], "completed")
        self.assertEqual((history["base"].shape, history["shear_kN"].shape), ((steps, 3), (steps, 2)))
        self.assertEqual(history["acceleration_mm_s2"].shape, (steps, 3, 2))
        centre = np.hypot(history["base"][:, 0], history["base"][:, 1]).max()
        self.assertAlmostEqual(centre / law["quantities"]["centre_mm"]["by_motion"][0]["nominal"], 1.0, delta=0.02)
        building.write(self.path / "W")
        self.assertEqual(isolaw._json.loads((self.path / "W/building.json").read_text()), building.results)

    def test_wrong_input_is_one_error(self):
        def refused(said, plan=PLAN, motions=((0.02, ground(1)),), **more):
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.building(plan, self.lot, motions, **more)

        refused("building: draws: -1", draws=-1)
        refused("no law 'bilinaer'|bilinaer", laws="bilinaer")
        refused("motion_unit: is given, and no motion is a file", motion_unit="g")
        refused("unknown key 'colour'", plan=PLAN | {"base": SLAB | {"colour": 1}})
        refused("mass_Mg.*a number above 0", plan=PLAN | {"base": SLAB | {"mass_Mg": -1.0}})
        refused("no \\[base\\]", plan={k: v for k, v in PLAN.items() if k != "base"})
        refused("motion 'motion 1': sample 3 is no number", motions=[(0.02, [0.0, 1.0, np.nan])])
        refused("400 samples along x and 399 along y", motions=[(0.02, ground(1), ground(1)[:-1])])
        refused("a step of 0", motions=[(0, ground(1))])
        refused("motions: neither a file", motions=[0.02])
        refused("no motions", motions=None)
        refused("jobs: -1", jobs=-1)
        column = self.path / "one.txt"
        column.write_text("".join(f"{value:.6f}\n" for value in ground(1)))
        refused("one.txt: .*try: motion_dt and motion_unit", motions=[column])
        refused("motion_dt: is given alone", motions=None, motion_dt=0.02)
        stated = isolaw.building(PLAN, self.lot, [column], draws=2, motion_dt=0.02, motion_unit="m/s2")
        same = isolaw.building(PLAN, self.lot, [(0.02, np.round(ground(1), 6))], draws=2)
        np.testing.assert_array_equal(stated.peaks(), same.peaks())
        with self.assertRaises(TypeError):
            isolaw.building(PLAN, self.lot, [(0.02, ground(1))], colour=1)
        building = isolaw.building(PLAN, self.lot, [(0.02, ground(1))])
        with self.assertRaisesRegex(isolaw.Error, "quantity: 'colour'; allowed: isolator_mm, "):
            building.peaks("colour")
        with self.assertRaisesRegex(isolaw.Error, "law: 'ozdemir'; allowed: bilinear"):
            building.history("ozdemir")

    def test_what_progress_raises_ends_it_and_the_same_call_goes_on(self):
        class Stopped(Exception):
            pass

        def stop(done, total):
            raise Stopped

        motions = [(0.02, ground(k), ground(k + 1)) for k in range(3)]
        with self.assertRaises(Stopped):
            isolaw.building(PLAN, self.lot, motions, draws=300, out=self.path / "I", jobs=1, progress=stop)
        self.assertFalse((self.path / "I/building.json").exists())
        building = isolaw.building(PLAN, self.lot, motions, draws=300, out=self.path / "I", jobs=2)
        isolaw.building(PLAN, self.lot, motions, draws=300, out=self.path / "J", jobs=1)
        for name in ("building.sqlite", "building.json"):
            self.assertEqual((self.path / "I" / name).read_bytes(), (self.path / "J" / name).read_bytes(), name)
        self.assertEqual(building.peaks().shape, (1, 300, 3))


if __name__ == "__main__":
    unittest.main()
