import json
import pathlib
import tempfile
import threading
import unittest

import numpy as np

import isolaw
from devices import arrays, program, write_csv

LAWS = ["bilinear", "bouc-wen"]


class Campaigns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        (cls.path / "r").mkdir()
        for name, strength in (("a", 20.0), ("b", 24.0)):
            write_csv(cls.path / "r" / f"{name}.csv", *arrays(strength))
        cls.files = [cls.path / "r/a.csv", cls.path / "r/b.csv"]
        program("calibrate", "r", "--laws", ",".join(LAWS), "--runs", "2", "--seed", "7", "--replicates", "0", "--out", "O",
                cwd=cls.path)  # fmt: skip
        cls.printed = json.loads((cls.path / "O/summary.json").read_text())
        cls.made = isolaw.calibrate(cls.files, LAWS, runs=2, seed=7, replicates=0, title="r", jobs=3)

    def test_numbers_are_those_of_the_program_bit_by_bit(self):
        self.assertTrue(self.made.complete)
        self.assertEqual(self.made.summary, self.printed)

    def test_the_genetic_algorithm_too(self):
        how = {"method": "ga", "runs": 2, "population": 20, "generations": 5, "box": "published", "smooth": 3}
        made = isolaw.calibrate(self.files, "bouc-wen", analysis=False, title="r", set=["bouc-wen.A=1:2"], **how)
        program("calibrate", "r", "--laws", "bouc-wen", "--method", "ga", "--runs", "2", "--population", "20", "--generations", "5",
                "--box", "published", "--smooth", "3", "--set", "bouc-wen.A=1:2", "--analysis", "none", "--out", "G",
                cwd=self.path)  # fmt: skip
        self.assertEqual(made.summary, json.loads((self.path / "G/summary.json").read_text()))

    def test_records_of_arrays_give_the_numbers_of_files(self):
        records = [isolaw.record(x, f, t, name=name) for name, (t, x, f) in (("a", arrays(20.0)), ("b", arrays(24.0)))]
        made = isolaw.calibrate(records, LAWS, runs=2, seed=7, analysis=False)
        for law, printed in zip(made.summary["laws"], self.printed["laws"]):
            self.assertEqual(law["objective"], printed["objective"])
            self.assertEqual(law["beta"], printed["beta"])

    def test_a_directory_is_written_and_loaded(self):
        out = self.path / "P"
        made = isolaw.calibrate(self.files, LAWS, runs=2, seed=7, replicates=0, title="r", out=out)
        self.assertEqual((out / "summary.json").read_bytes(), (self.path / "O/summary.json").read_bytes())
        for directory in (out, self.path / "O"):
            self.assertEqual(isolaw.load(directory).summary, made.summary)
        with self.assertRaisesRegex(isolaw.Error, "the campaign there differs: .*seed"):
            isolaw.calibrate(self.files, LAWS, runs=2, seed=8, replicates=0, out=out)
        made.write(self.path / "W")
        self.assertEqual((self.path / "W/summary.json").read_bytes(), (out / "summary.json").read_bytes())

    def test_arrays_of_a_campaign(self):
        for law in LAWS:
            runs = self.made.runs(law, "a")
            best = runs["objective"].argmin()
            self.assertEqual(runs["parameters"][best].tolist(), list(self.made.parameters(law, "a").values()))
            seen = self.made.fit_record("a")
            force = self.made.force(law, "a")
            self.assertEqual(len(force), len(seen["disp_mm"]))
            self.assertTrue(np.shares_memory(force, self.made.force(law, "a")))
            model = isolaw.Model(law, self.made.record("a"))
            np.testing.assert_array_equal(model.force(self.made.parameters(law, "a")), force)
            self.assertEqual(model.objective(self.made.parameters(law, "a")), runs["objective"].min())
            # the one law of the lot
            of_lot = next(one["lot"] for one in self.printed["laws"] if one["id"] == law)
            self.assertEqual(list(self.made.parameters(law, "lot").values()), list(of_lot["parameters"].values())
                             if isinstance(of_lot["parameters"], dict) else of_lot["parameters"])  # fmt: skip
        self.assertEqual(self.made.devices, ["a", "b"])
        self.assertEqual(self.made.laws, LAWS)
        for kind, accuracy in (("runs", "mean"), ("converged", None), ("loo", None)):
            rows = self.made.front(kind)
            self.assertEqual([row["law"] for row in rows], LAWS)
            self.assertTrue(any(row["on_front"] for row in rows))
            if accuracy:
                self.assertEqual(rows[0]["accuracy"], self.printed["laws"][0]["objective"][accuracy])

    def test_what_is_not_there_is_said(self):
        for wrong in (lambda: self.made.force("abe", "a"), lambda: self.made.runs("bilinear", "c"),
                      lambda: self.made.record("c"), lambda: self.made.parameters("bilinear", "c"),
                      lambda: isolaw.load(self.path / "nowhere"), lambda: self.made.front("best")):  # fmt: skip
            with self.assertRaises(isolaw.Error):
                wrong()

    def test_wrong_settings_are_errors(self):
        record = isolaw.read_record(self.files[0])
        for how, said in (
            ({"laws": "abx"}, "no such law"),
            ({"runs": 0}, "runs"),
            ({"method": "newton"}, "newton"),
            ({"population": 20}, "method='ga'"),
            ({"set": "bilinear.K9=1"}, "K9"),
            ({"jobs": -1}, "jobs"),
            ({"samples_per_cycle": 3}, "samples"),
        ):
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.calibrate(record, **({"laws": "bilinear"} | how))
        with self.assertRaisesRegex(isolaw.Error, "is there twice"):
            isolaw.calibrate([record, record], "bilinear")
        with self.assertRaisesRegex(isolaw.Error, "a lot file; allowed: records"):
            isolaw.calibrate("lot.toml")
        with self.assertRaisesRegex(isolaw.Error, "there are none"):
            isolaw.calibrate([], "bilinear")

    def test_progress_comes_in_the_callers_thread_and_its_exception_ends_the_search(self):
        seen = []

        def note(done, total, analysis, best):
            seen.append((done, total, analysis, dict(best), threading.get_ident()))

        isolaw.calibrate(self.files, "bouc-wen", runs=4, analysis=False, progress=note, jobs=2)
        self.assertGreater(len(seen), 0)
        self.assertEqual({one[4] for one in seen}, {threading.get_ident()})
        self.assertEqual([one[0] for one in seen], sorted(one[0] for one in seen))
        self.assertTrue(all(one[1] == 8 and "bouc-wen" in one[3] for one in seen))

        class Enough(Exception):
            pass

        def refuse(*_):
            raise Enough

        with self.assertRaises(Enough):
            isolaw.calibrate(self.files, "all", runs=50, progress=refuse, jobs=2)


if __name__ == "__main__":
    unittest.main()
