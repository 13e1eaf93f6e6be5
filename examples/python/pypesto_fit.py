"""Fits a law to a record with pyPESTO, from several starts, by the objective that isolaw itself uses.

    PYTHONPATH=build/release/python python3 examples/python/pypesto_fit.py [RECORD]
"""

import pathlib
import sys

import pypesto
import pypesto.optimize

import isolaw

LAW = "bilinear"
STARTS = 5

lot = pathlib.Path(__file__).resolve().parents[1] / "published-lot"
record = isolaw.read_record(sys.argv[1] if len(sys.argv) > 1 else lot / "device-01.csv")
model = isolaw.Model(LAW, record)
lower, upper = model.bounds
problem = pypesto.Problem(pypesto.Objective(fun=model), lb=lower, ub=upper, x_names=model.free_names)
optimizer = pypesto.optimize.ScipyOptimizer("Nelder-Mead")
result = pypesto.optimize.minimize(problem, optimizer, n_starts=STARTS, progress_bar=False)
best = result.optimize_result[0]
print("\n".join(f"{name:8} {value:.6g}" for name, value in zip(model.free_names, best.x)))
own = isolaw.calibrate([record], LAW, analysis=False)[LAW][record.name]
print(f"objective {best.fval:.5f} with pyPESTO, {own.objective:.5f} with isolaw")
