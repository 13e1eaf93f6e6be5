"""Makes records of devices with constant stiffness and friction, as arrays and files, and runs the program."""

import importlib.util
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

SOURCE = pathlib.Path(os.environ["ISOLAW_SOURCE_DIR"])
BINARY = os.environ["ISOLAW_BINARY"]


def needs(package):
    """Skips a test if a package that isolaw does not need itself is not installed."""
    return unittest.skipIf(importlib.util.find_spec(package) is None, f"not installed: {package}")


def arrays(strength_kN=20.0, cycles=3, per_cycle=200):
    """Returns time in s, displacement in mm and force in kN of a bilinear device."""
    i = np.arange(cycles * per_cycle + 1)
    x = 100.0 * np.sin(2.0 * np.pi * i / per_cycle)
    z = np.zeros(len(x))
    for k in range(1, len(x)):
        z[k] = np.clip(z[k - 1] + (x[k] - x[k - 1]) / 10.0, -1.0, 1.0)
    return 0.01 * i, x, 0.5 * x + strength_kN * z


def write_csv(path, *columns, header="time [s],displacement [mm],force [kN]"):
    rows = (",".join(repr(float(value)) for value in row) for row in zip(*columns))
    pathlib.Path(path).write_text("\n".join([header, *rows]) + "\n")


def files_in(folder, strengths_kN=(20.0, 24.0)):
    """Creates the folder and writes the devices' records a.csv, b.csv, ... to it."""
    pathlib.Path(folder).mkdir(exist_ok=True)
    files = [pathlib.Path(folder) / f"{name}.csv" for name, _ in zip("abcdefgh", strengths_kN)]
    for file, strength_kN in zip(files, strengths_kN):
        write_csv(file, *arrays(strength_kN))
    return files


class InFolder(unittest.TestCase):
    """A test class with a folder of its own, `path`."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)


def program(*words, cwd=None):
    """Runs isolaw and returns its standard output."""
    process = subprocess.run([BINARY, *map(str, words)], cwd=cwd, capture_output=True, text=True, timeout=300)
    assert process.returncode in (0, 1), process.stderr
    return process.stdout
