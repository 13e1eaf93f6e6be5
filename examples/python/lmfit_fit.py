"""Fits a law to a record with lmfit, which reports a standard error and correlations of the parameters.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/lmfit_fit.py [RECORD]
"""

import pathlib
import sys

import lmfit

import isolaw

LAW = "bilinear"

lot = pathlib.Path(__file__).resolve().parents[1] / "published-lot"
record = isolaw.read_record(sys.argv[1] if len(sys.argv) > 1 else lot / "device-01.csv")
model = isolaw.Model(LAW, record)
own = isolaw.calibrate([record], LAW, analysis=False)[LAW][record.name]
parameters = lmfit.Parameters()
for name, lower, upper in zip(model.free_names, *model.bounds):
    parameters.add(name, value=own.parameters[name], min=lower, max=upper)
fit = lmfit.minimize(model.residual, parameters)  # least squares, started from isolaw's best fit
print(lmfit.fit_report(fit))
print(f"objective {model.objective(fit.params):.5f} with lmfit, {own.objective:.5f} with isolaw")
