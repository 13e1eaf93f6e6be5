import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

LONG = """
import sys, threading, time, pathlib
import isolaw
from devices import arrays
t, x, f = arrays()
beats = []
def beat():
    while True:
        beats.append(time.monotonic())
        time.sleep(0.01)
threading.Thread(target=beat, daemon=True).start()
def told(*_):
    print("running", flush=True)
try:
    # Hours of work.
    isolaw.calibrate(isolaw.record(x, f, t), "hwang-wu", method="ga", runs=100000, population=400, generations=2000, jobs=2,
                     out=sys.argv[1], analysis=False, progress=told)
except KeyboardInterrupt:
    print("interrupted", len(beats), flush=True)
"""


class Interrupt(unittest.TestCase):
    def test_ctrl_c_raises_KeyboardInterrupt_and_other_threads_have_run(self):
        with tempfile.TemporaryDirectory() as folder:
            child = subprocess.Popen([sys.executable, "-c", LONG, folder + "/out"], stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE, text=True, cwd=os.path.dirname(__file__))  # fmt: skip
            try:
                # isolaw creates the store campaign.sqlite when the search starts, so the test waits for this file.
                limit = time.monotonic() + 60
                while not os.path.exists(folder + "/out/campaign.sqlite") and time.monotonic() < limit:
                    time.sleep(0.05)
                time.sleep(1.0)
                self.assertIsNone(child.poll())
                child.send_signal(signal.SIGINT)
                out, errors = child.communicate(timeout=60)
            finally:
                if child.poll() is None:
                    child.kill()
                    child.communicate()
        self.assertEqual(child.returncode, 0, errors)
        word, beats = out.split()[-2:]
        self.assertEqual(word, "interrupted", errors)
        # The search had run for a second when it was interrupted. Another Python thread could run meanwhile, because
        # the search does not hold Python's global lock.
        self.assertGreater(int(beats), 10)

    def test_an_interrupted_campaign_is_continued_by_the_same_call(self):
        import isolaw
        from devices import arrays

        t, x, f = arrays()
        record = isolaw.record(x, f, t)
        how = {"runs": 12, "analysis": False, "jobs": 1}

        class Stopped(Exception):
            pass

        def some(done, *_):
            if done >= 2:
                raise Stopped

        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(Stopped):
                isolaw.calibrate(record, "menegotto-pinto", out=folder, progress=some, **how)
            kept = isolaw.load(folder)
            there = len(kept.runs("menegotto-pinto", "record")["number"])
            self.assertFalse(kept.complete)
            self.assertGreaterEqual(there, 2)
            campaign = isolaw.calibrate(record, "menegotto-pinto", out=folder, **how)
        self.assertTrue(campaign.complete)
        self.assertEqual(campaign.summary, isolaw.calibrate(record, "menegotto-pinto", **how).summary)


if __name__ == "__main__":
    unittest.main()
