"""The command of the Python package must do what the program does, with the same output and exit codes."""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from devices import BINARY

COMMAND = [sys.executable, "-m", "isolaw"]


def both(*words, **how):
    """Runs the program and the command; returns exit code, output and errors of each."""
    for start in ([BINARY], COMMAND):
        process = subprocess.run([*start, *words], capture_output=True, timeout=600, **how)
        yield process.returncode, process.stdout, process.stderr


class Command(unittest.TestCase):
    def test_output_and_exit_codes_are_those_of_the_program(self):
        for words, code in (["laws", "--json"], 0), (["no-such-command"], 2), ([b"inspect", b"\xff.csv"], 2):
            with self.subTest(words):
                of_program, of_command = both(*words)
                self.assertEqual(of_program[0], code)
                self.assertEqual(of_command, of_program)

    def test_the_example_lot_has_the_same_summary(self):
        with tempfile.TemporaryDirectory() as folder:
            lot = pathlib.Path(folder, "ex")
            list(both("example", lot))
            summaries = []
            for result in both("calibrate", "lot.toml", "--laws", "bilinear,bouc-wen", "--replicates", "40", "--figures", "none",
                               "--out", "out", "--fresh", cwd=lot):  # fmt: skip
                self.assertEqual(result[0], 0, result[2])
                summaries.append((lot / "out/summary.json").read_bytes())
                for file in (lot / "out").glob("campaign.sqlite*"):
                    file.unlink()
        self.assertGreater(len(summaries[0]), 10000)
        self.assertEqual(*summaries)

    def test_ctrl_c_ends_a_command_that_python_would_let_run(self):
        child = subprocess.Popen([*COMMAND, "bench"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(1.0)
        self.assertIsNone(child.poll())
        child.send_signal(signal.SIGINT)
        errors = child.communicate(timeout=600)[1]
        self.assertEqual((child.returncode, errors), (-signal.SIGINT, b""))

    def test_a_closed_pipe_ends_it_without_a_message(self):
        child = subprocess.Popen([*COMMAND, "laws", "--markdown"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        child.stdout.close()
        self.assertEqual((child.stderr.read(), child.wait(timeout=600)), (b"", -signal.SIGPIPE))
        child.stderr.close()


if __name__ == "__main__":
    unittest.main()
