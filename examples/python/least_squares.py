"""Fits a law to a record with SciPy's least squares, from several starts, and compares the fit with isolaw's own.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/least_squares.py [RECORD]
"""

import pathlib
import sys

import numpy as np
from scipy.optimize import least_squares

import isolaw

LAW = "bouc-wen"
STARTS = 8

lot = pathlib.Path(__file__).resolve().parents[1] / "published-lot"
record = isolaw.read_record(sys.argv[1] if len(sys.argv) > 1 else lot / "device-01.csv")
model = isolaw.Model(LAW, record)
lower, upper = model.bounds
starts = lower + (upper - lower) * np.random.default_rng(1).uniform(size=(STARTS, len(lower)))
fits = [least_squares(model.residual, start, bounds=model.bounds, x_scale=upper - lower) for start in starts]
best = min(fits, key=lambda fit: fit.cost)
print("\n".join(f"{name:8} {value:.6g}" for name, value in zip(model.free_names, best.x)))
own = isolaw.calibrate([record], LAW, analysis=False)[LAW][record.name]
print(f"objective {model.objective(best.x):.5f} with SciPy, {own.objective:.5f} with isolaw")
