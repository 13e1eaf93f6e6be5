"""Runs the Dask example with local processes.

The merged campaign must have the bytes of one from a single machine, even if a worker is lost while it computes a part.
"""

import functools
import importlib.util
import os
import signal
import subprocess
import sys
import unittest

from devices import SOURCE, InFolder, files_in

import isolaw

if importlib.util.find_spec("distributed") is None:
    print("skipped: python3-distributed is not installed")
    sys.exit(0)

import distributed

sys.path.insert(0, str(SOURCE / "examples/python"))  # the worker processes find this path too
import parts_with_dask

LAWS = "bilinear,vaiana"


def share_of_a_worker_that_is_lost(mark, files, settings, number, of, there=None):
    """Computes a part. The first worker that computes part 2 is killed; the file `mark` records that this happened."""

    def lose(*told):
        try:
            open(mark, "x").close()
        except FileExistsError:
            return
        os.kill(os.getpid(), signal.SIGKILL)

    return parts_with_dask.share(files, settings | {"progress": lose} if number == 2 else settings, number, of, there)


class Dask(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.files = files_in(cls.path)
        isolaw.calibrate(cls.files, LAWS, runs=2, out=cls.path / "one")

    def expect_one_machines(self, out):
        for name in ("campaign.sqlite", "summary.json", "report.html"):
            self.assertEqual((out / name).read_bytes(), (self.path / "one" / name).read_bytes(), name)

    def run_example(self, out, runs=2, refused=""):
        process = subprocess.run(
            [sys.executable, SOURCE / "examples/python/parts_with_dask.py", *self.files, "--parts", "3", "--laws", LAWS,
             "--runs", str(runs), "--out", out],
            capture_output=True, text=True, timeout=300, cwd=self.path,
        )  # fmt: skip
        self.assertEqual(process.returncode, 1 if refused else 0, process.stderr)
        self.assertIn(refused, process.stderr)
        return process.stdout

    def test_the_example_ends_as_one_machine_and_goes_on_after_a_loss(self):
        out = self.path / "parts"
        said = self.run_example(out)
        self.expect_one_machines(out)
        self.assertEqual(sorted(line for line in said.splitlines() if line.startswith("part ")),
                         [f"part {number} of 3 is here" for number in (1, 2, 3)])  # fmt: skip
        lost = self.path / "parts.parts/2/campaign.sqlite"
        lost.unlink()
        (out / "campaign.sqlite").unlink()
        said = self.run_example(out)
        self.assertEqual([line for line in said.splitlines() if line.startswith("part ")], ["part 2 of 3 is here"])
        self.expect_one_machines(out)
        # An earlier run left parts with the same names that were computed with 2 runs. The example now asks for 3 runs
        # and must refuse these parts.
        self.run_example(out, runs=3, refused="of a campaign that is now larger, by 3 runs instead of 2")
        self.expect_one_machines(out)

    def test_the_part_of_a_lost_worker_is_computed_again(self):
        out, lost = self.path / "lossy", self.path / "lost"
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None,
                                      local_directory=str(self.path)) as cluster:  # fmt: skip
            with distributed.Client(cluster) as client:
                lossy = functools.partial(share_of_a_worker_that_is_lost, str(lost))
                campaign = parts_with_dask.campaign(client, self.files, {"laws": LAWS, "runs": 2}, 3, out, lossy)
        self.assertTrue(lost.exists())  # the worker that was killed wrote this file
        self.assertTrue(campaign.complete)
        self.expect_one_machines(out)


if __name__ == "__main__":
    unittest.main()
