"""Tests that parts of a campaign and their merge give the same results as the program."""

import pathlib
import shutil
import tempfile
import unittest

import isolaw
from devices import program, files_in

LAWS = ["bilinear", "vaiana"]


class Parts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.files = files_in(self.path / "r")

    def part(self, number, of=3, **more):
        how = {"runs": 2, "replicates": 0, "title": "r", "out": self.path / f"P{number}"} | more
        return isolaw.calibrate(self.files, LAWS, part=(number, of), **how)

    def test_a_merge_ends_as_one_machine_and_as_the_program(self):
        parts = [self.part(number) for number in (3, 1)]
        self.assertFalse((self.path / "P1/summary.json").exists())
        self.assertEqual((parts[0].summary["part"], parts[0].summary["parts"]), (3, 3))
        program("calibrate", "r", "--laws", ",".join(LAWS), "--runs", "2", "--replicates", "0", "--part", "2/3", "--out", "P2",
                cwd=self.path)  # fmt: skip
        directories = [self.path / "P2", self.path / "P3/campaign.sqlite", self.path / "P1", self.path / "P1"]
        told = []
        merged = isolaw.merge(self.path / "O", directories, progress=lambda done, total, *more: told.append(total))
        self.assertTrue(merged.complete and told)
        isolaw.calibrate(self.files, LAWS, runs=2, replicates=0, title="r", out=self.path / "W")
        for name in ("campaign.sqlite", "summary.json", "report.html"):
            self.assertEqual((self.path / "O" / name).read_bytes(), (self.path / "W" / name).read_bytes(), name)
        self.assertEqual(isolaw.load(self.path / "O").summary, merged.summary)

    def test_what_is_missing_is_named_and_what_is_there_kept(self):
        self.part(1)
        self.part(3)
        directories = [self.path / f"P{number}" for number in (1, 2, 3)]
        with self.assertRaisesRegex(isolaw.Error, r"3 runs are missing, of part 2/3 \(3 runs\); the first: run . of .* on device "
                                                  r".*; not there: .*P2"):  # fmt: skip
            isolaw.merge(self.path / "O", directories)
        self.assertFalse((self.path / "O/summary.json").exists())
        self.part(2)
        self.assertTrue(isolaw.merge(self.path / "O", self.path / "P2").complete)

    def test_wrong_parts_are_errors(self):
        for part, said in (((0, 3), "^part: '0/3'; allowed: K/N"), ((4, 3), "part=.1, 4."), ((1, 100001), "^part: "),
                           ("1/3", "^part: '1/3'"), ((1.0, 3), "^part: "), (3, "^part: 3")):  # fmt: skip
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.calibrate(self.files, LAWS, part=part, out=self.path / "X")
        with self.assertRaisesRegex(isolaw.Error, "part 1/3: no directory"):
            isolaw.calibrate(self.files, LAWS, part=(1, 3))
        self.assertFalse((self.path / "X").exists())
        self.part(1)
        self.part(2, seed=9)
        with self.assertRaisesRegex(isolaw.Error, "of another campaign than .*seed: 1 in .*, 9 in "):
            isolaw.merge(self.path / "O", [self.path / "P1", self.path / "P2"])
        with self.assertRaisesRegex(isolaw.Error, "is the directory that is merged into"):
            isolaw.merge(self.path / "P1", [self.path / "P1"])
        with self.assertRaisesRegex(isolaw.Error, "no part is there"):
            isolaw.merge(self.path / "O", [self.path / "nowhere"])
        # The campaign has fewer than 100 runs, so part 100 of 100 has none. This is no error.
        self.assertTrue(self.part(100, 100, out=self.path / "E").complete)
        shutil.copy(self.path / "P1/campaign.sqlite", self.path / "cut.sqlite")
        with open(self.path / "cut.sqlite", "r+b") as file:
            file.truncate(9000)
        with self.assertRaisesRegex(isolaw.Error, "cut.sqlite"):
            isolaw.merge(self.path / "O", [self.path / "cut.sqlite"])


if __name__ == "__main__":
    unittest.main()
