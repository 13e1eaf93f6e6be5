#!/usr/bin/env python3
"""Measures the cost of isolaw's materials in OpenSeesPy and compares it with the cost of OpenSees' own materials.

A thousand zeroLength elements of one material follow cycles of a rising amplitude, in a static and in a transient
analysis. The time of the same model with the material Elastic is subtracted, and the rest is divided by the number of
elements and steps. The result is also divided by those of the materials BoucWen and Steel02. Each time is the shortest
of several repetitions.

    PYTHONPATH=build/release/python:build/opensees/openseespy/lib/python3.11/site-packages /usr/bin/python3 bench/opensees.py
"""

import argparse
import math
import time
import warnings

import isolaw
import openseespy.opensees as ops
import isolaw.opensees

ELEMENTS, STEPS = 1000, 300
PATH = [100.0 * math.sin(2.0 * math.pi * i / 100.0) * (0.3 + 0.7 * i / STEPS) for i in range(1, STEPS + 1)]
K, F = 2.0, 20.0  # kN/mm, kN

PROGRAMS = {
    "Elastic": lambda: ops.uniaxialMaterial("Elastic", 7, K),
    "Steel01": lambda: ops.uniaxialMaterial("Steel01", 7, F, K, 0.3),
    "Steel02": lambda: ops.uniaxialMaterial("Steel02", 7, F, K, 0.3, 18.0, 0.925, 0.15),
    "BoucWen": lambda: ops.uniaxialMaterial("BoucWen", 7, 0.3, K, 1.0, 0.05, 0.05, 1.0, 0.0, 0.0, 0.0),
    "KikuchiAikenHDR": lambda: ops.uniaxialMaterial("KikuchiAikenHDR", 7, "X0.6", 1e5, 200.0),
}


def middle_parameters(law):
    path = [0.0, *PATH]
    record = isolaw.record(path, [K * x + F * math.copysign(1.0, x) for x in path], [0.01 * i for i in range(len(path))])
    middle = {}
    for name, p in isolaw.box(law, record).items():
        if not p["free"]:
            middle[name] = p["value"]
        elif p["scale"] == "linear" or p["lower"] <= 0.0:
            middle[name] = 0.5 * (p["lower"] + p["upper"])
        else:
            middle[name] = math.sqrt(p["lower"] * p["upper"])
    return middle


def seconds(make, transient):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0, "-mass", 1.0)
    ops.fix(1, 1)
    make()
    for tag in range(1, ELEMENTS + 1):
        ops.element("zeroLength", tag, 1, 2, "-mat", 7, "-dir", 1)
    ops.constraints("Transformation" if transient else "Lagrange")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.algorithm("Linear")
    if transient:
        # The mass is so large that the springs cannot move it: their displacement is that of the ground.
        ops.mass(2, 1e12)
        ops.timeSeries("Path", 1, "-dt", 0.01, "-values", 0.0, *PATH)
        ops.pattern("Plain", 1, 1)
        ops.load(2, 1e12 * (2.0 * math.pi) ** 2)
        ops.integrator("Newmark", 0.5, 0.25)
        ops.analysis("Transient")
    else:
        ops.timeSeries("Path", 1, "-dt", 1.0, "-values", 0.0, *PATH)
        ops.pattern("Plain", 1, 1)
        ops.sp(2, 1, 1.0)
        ops.integrator("LoadControl", 1.0)
        ops.analysis("Static")
    began = time.perf_counter()
    code = ops.analyze(STEPS, 0.01) if transient else ops.analyze(STEPS)
    taken = time.perf_counter() - began
    return taken if code == 0 else math.nan


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--runs", type=int, default=5)
    asked = options.parse_args()
    warnings.simplefilter("ignore")
    isolaw.opensees.attach(ops)
    makers = dict(PROGRAMS)
    for law in isolaw.laws():
        parameters = middle_parameters(law)
        makers["isolaw " + law] = lambda law=law, parameters=parameters: isolaw.opensees.material(7, law, parameters)
    for transient in (False, True):
        best = dict.fromkeys(makers, math.inf)
        for _ in range(asked.runs):
            for name, make in makers.items():
                best[name] = min(best[name], seconds(make, transient))
        above = {name: (value - best["Elastic"]) / ELEMENTS / STEPS * 1e9 for name, value in best.items()}
        print(f"{'transient' if transient else 'static'}; above Elastic   ns a step  of BoucWen  of Steel02")
        for name, cost in above.items():
            if name != "Elastic":
                print(f"  {name:30} {cost:8.0f} {cost / above['BoucWen']:11.2f} {cost / above['Steel02']:11.2f}")


if __name__ == "__main__":
    main()
