import json
import pathlib
import tempfile
import unittest

import numpy as np

import isolaw
from devices import SOURCE, arrays, program, write_csv


class Records(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def test_a_file_is_read_and_said_how(self):
        t, x, f = arrays()
        write_csv(self.path / "d.csv", t, x, f)
        record = isolaw.read_record(self.path / "d.csv")
        self.assertEqual((record.name, len(record)), ("d", len(x)))
        np.testing.assert_array_equal(record.time_s, t)
        np.testing.assert_array_equal(record.disp_mm, x)
        np.testing.assert_array_equal(record.force_kN, f)
        self.assertIsNone(record.load_kN)
        self.assertTrue(any("by its name; unit mm" in line for line in record.recognised))

    def test_columns_and_units_as_dict_or_text(self):
        _, x, f = arrays()
        write_csv(self.path / "d.csv", f, x, header="a,b")
        for columns, units in (({"disp": 2, "force": "a"}, {"disp": "cm", "force": "kN"}), ("disp=2,force=1", "disp=cm,force=kN")):
            record = isolaw.read_record(self.path / "d.csv", columns=columns, units=units, dt=0.01, name="one")
            np.testing.assert_array_equal(record.disp_mm, 10.0 * x)
            self.assertEqual(record.name, "one")
            self.assertEqual(record.time_s[1], 0.01)

    def test_arrays_are_views_without_a_copy_that_outlive_the_record(self):
        t, x, f = arrays()
        record = isolaw.record(x, f, t)
        first, second = record.disp_mm, record.disp_mm
        self.assertTrue(np.shares_memory(first, second))
        self.assertFalse(np.shares_memory(first, x))
        self.assertFalse(first.flags.writeable)
        with self.assertRaises(ValueError):
            first[0] = 1.0
        del record, second
        np.testing.assert_array_equal(first, x)

    def test_tests_of_one_device_share_its_parameters(self):
        t, x, f = arrays()
        slow, fast = isolaw.record(x, f, t, name="slow"), isolaw.record(2.0 * x, 1.7 * f, t, name="fast")
        both = isolaw.same_device([slow, fast])
        self.assertEqual((both.name, len(both)), ("slow + fast", 2 * len(x)))
        self.assertEqual(isolaw.same_device([slow, fast], name="B1").name, "B1")
        model, apart = isolaw.Model("bilinear", both, weights="swing"), [isolaw.Model("bilinear", one, weights="swing") for one in (slow, fast)]
        self.assertAlmostEqual(model.objective([1.5, 0.5, 30.0]), sum(one.objective([1.5, 0.5, 30.0]) for one in apart) / 2.0, places=12)
        campaign = isolaw.calibrate([both], ["bilinear"], analysis=False)
        self.assertEqual([one["test"] for one in campaign.summary["laws"][0]["devices"][0]["tests"]], ["slow", "fast"])
        for wrong in ([], [slow, slow], [isolaw.motion(x, t)], [slow, isolaw.record(x, f, name="timeless")], [slow, None]):
            with self.assertRaises(isolaw.Error):
                isolaw.same_device(wrong)

    def test_properties_are_those_that_inspect_prints(self):
        file = SOURCE / "examples/published-lot/device-01.csv"
        found = isolaw.properties(isolaw.read_record(file))
        printed = json.loads(program("inspect", file, "--json"))
        self.assertGreater(len(found["blocks"][0]["cycles"]), 0)
        self.assertEqual(found["blocks"], printed["blocks"])
        self.assertEqual(found["reported"], printed["reported"])
        self.assertEqual(found, isolaw.properties(file))

    def test_errors_hold_every_complaint(self):
        write_csv(self.path / "bad.csv", [0, 1, 2], [0, 1, 2], [3, 4, 5], header="a,b,c")
        with self.assertRaises(isolaw.Error) as caught:
            isolaw.read_record(self.path / "bad.csv")
        self.assertIsInstance(caught.exception, ValueError)
        self.assertIn("bad.csv", str(caught.exception))
        self.assertGreaterEqual(len(caught.exception.complaints), 1)
        self.assertEqual(set(caught.exception.complaints[0]), {"where", "found", "allowed", "advice"})
        with self.assertRaisesRegex(isolaw.Error, "no such file"):
            isolaw.read_record(self.path / "none.csv")

    def test_arrays_are_checked_as_files_are(self):
        t, x, f = arrays()
        wrong = f.copy()
        wrong[7] = np.nan
        for given, said in (
            ((x, wrong, t), "record:8: force_kN is nan"),
            ((x, f[:-1], t), "600 values of force_kN, 601 of disp_mm"),
            ((x, f, t[::-1]), "time goes back"),
            ((x, np.full_like(f, 3.0), t), "force is constant"),
            ((f, x, t), "the other way round"),
            ((x[:2], f[:2], t[:2]), "2 samples"),
            ((x.reshape(1, -1), f, t), "2 dimensions"),
        ):
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.record(*given)

    def test_arrays_that_numpy_would_change_are_refused(self):
        t, x, f = arrays()
        for wrong, said in (
            ((t * 1e9).astype("timedelta64[ns]"), "time_s: dates or times"),
            ((t * 1e9).astype("datetime64[ns]"), "time_s: dates or times"),
            (t + 0j, "time_s: complex numbers"),
            (t.astype(str), "time_s: .* is no array of numbers"),
            (np.ma.masked_greater(t, 5.0), "time_s: an array with masked values"),
        ):
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.record(x, f, wrong)
        self.assertEqual(isolaw.record(x, f, np.ma.array(t)), isolaw.record(x, f, list(t)))

    def test_units_that_cannot_be_are_asked_about_by_their_names(self):
        t, x, f = arrays()
        self.assertIn("displacements really in mm and forces in kN", isolaw.record(x / 1000, f, t).warnings[0])

    def test_a_motion_needs_no_force(self):
        t, x, f = arrays()
        write_csv(self.path / "m.csv", t, x, header="time [s],displacement [mm]")
        motion = isolaw.read_motion(self.path / "m.csv")
        self.assertIsNone(motion.force_kN)
        np.testing.assert_array_equal(motion.disp_mm, isolaw.motion(x, t).disp_mm)
        with self.assertRaisesRegex(isolaw.Error, "without force"):
            isolaw.properties(motion)
        (self.path / "g.csv").write_text("time [s],acceleration [g]\n0,0\n1,1\n2,0\n")
        with self.assertRaisesRegex(isolaw.Error, "acceleration"):
            isolaw.read_motion(self.path / "g.csv")


if __name__ == "__main__":
    unittest.main()
