#!/usr/bin/env python3
"""Goes from a test record to the response of an isolated frame in OpenSeesPy, with isolaw's law as the material.

Fits a law to one test of the example lot, puts a plane frame of three storeys on three such bearings in OpenSees, and
shakes it with and without them. Prints the peaks and writes frame.csv and, if matplotlib is installed, frame.png.
Needs `pip install openseespy`; units are kN, mm and s. Run it after ./isolaw.sh run, with a record of the ground's
acceleration in PEER's format, or without one for an artificial motion:

    PYTHONPATH=build/release/python python3 examples/python/isolated_frame.py --motion elcentro.AT2
"""

import argparse
import csv
import math
import pathlib
import re

import isolaw
import isolaw.opensees
import openseespy.opensees as ops

TEST = pathlib.Path(__file__).resolve().parent.parent / "published-lot/device-01.csv"
STOREYS, COLUMNS = 3, 3
HEIGHT, BAY = 3200.0, 6000.0
E = 30.0  # kN/mm2
COLUMN, BEAM = (400.0 * 400.0, 400.0**4 / 12.0), (300.0 * 500.0, 300.0 * 500.0**3 / 12.0)  # area, moment of inertia
GRAVITY = 9806.65
LOAD = 1600.0  # kN on each bearing, as in the test


def ground_motion(file):
    """Returns step in s and accelerations in mm/s2, from a file in PEER's format or of a sine that grows and fades."""
    if file is None:
        step, count = 0.01, 2500
        grown = [math.sin(math.pi * i / count) for i in range(count)]
        return step, [0.25 * GRAVITY * a * math.sin(2.0 * math.pi * 0.45 * i * step) for i, a in enumerate(grown)]
    text = file.read_text()
    step = float(re.search(r"DT=\s*([.\d]+)", text).group(1))
    return step, [GRAVITY * float(word) for line in text.splitlines()[4:] for word in line.split()]


def node(level, column):
    return 10 * level + column + 1


def build(law, campaign):
    """Makes the frame, on bearings that follow the law. If `law` is None, the feet of the columns are fixed."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    mass = COLUMNS * LOAD / GRAVITY / (STOREYS + 1) / COLUMNS
    for level in range(STOREYS + 1):
        for column in range(COLUMNS):
            ops.node(node(level, column), column * BAY, level * HEIGHT, "-mass", mass, mass, 0.0)
    ops.geomTransf("Linear", 1)
    tag = 0
    for level in range(STOREYS + 1):
        for column in range(COLUMNS):
            sides = [(node(level, column + 1), BEAM)] if column + 1 < COLUMNS else []
            sides += [(node(level + 1, column), COLUMN)] if level < STOREYS else []
            for end, (area, inertia) in sides:
                tag += 1
                ops.element("elasticBeamColumn", tag, node(level, column), end, area, E, inertia, 1)
    if law is None:
        for column in range(COLUMNS):
            ops.fix(node(0, column), 1, 1, 1)
    else:
        isolaw.opensees.material(1, law, campaign, device="bearing")
        ops.uniaxialMaterial("Elastic", 2, 1500.0)  # vertical stiffness of a bearing, kN/mm
        for column in range(COLUMNS):
            below = 100 + column
            ops.node(below, column * BAY, 0.0)
            ops.fix(below, 1, 1, 1)
            ops.element("zeroLength", below, below, node(0, column), "-mat", 1, 2, "-dir", 1, 2)
    ops.rayleigh(0.0, 0.0, 0.002, 0.0)  # damping of the frame; the bearings dissipate energy by their law


def shaken(step, accelerations):
    """Returns, over time: displacement of base, roof relative to base, and force and displacement of a bearing."""
    ops.timeSeries("Path", 1, "-dt", step, "-values", *accelerations)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-6, 30)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    rows = []
    for _ in accelerations:
        if ops.analyze(1, step) != 0:
            raise SystemExit(f"the analysis stops at {ops.getTime():.2f} s")
        base = ops.nodeDisp(node(0, 0), 1)
        force = ops.eleResponse(100, "force")[3] if 100 in ops.getEleTags() else 0.0
        rows.append((ops.getTime(), base, ops.nodeDisp(node(STOREYS, 0), 1) - base, force))
    return rows


def draw(isolated, fixed, law, file):
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 3.6), width_ratios=(2, 1), layout="constrained")
    left.plot(*zip(*((t, roof) for t, _, roof, _ in fixed)), color="0.6", label="fixed")
    left.plot(*zip(*((t, roof) for t, _, roof, _ in isolated)), color="C0", label="on bearings")
    left.set(xlabel="time [s]", ylabel="roof against base [mm]")
    left.legend(frameon=False, ncols=2)
    right.plot(*zip(*((base, force) for _, base, _, force in isolated)), color="C0", linewidth=0.9)
    right.set(xlabel="bearing [mm]", ylabel="force [kN]", title=law)
    figure.savefig(file, dpi=110)
    return True


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--test", type=pathlib.Path, default=TEST, help="a laboratory's file")
    options.add_argument("--law", default="power-masing")
    options.add_argument("--motion", type=pathlib.Path, help="accelerations of the ground, .AT2")
    options.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/frame"))
    asked = options.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    campaign = isolaw.calibrate([isolaw.read_record(asked.test, name="bearing")], asked.law, analysis=False)
    motion = ground_motion(asked.motion)
    build(None, None)
    fixed = shaken(*motion)
    build(asked.law, campaign)
    isolated = shaken(*motion)
    for name, rows in (("fixed", fixed), ("on bearings", isolated)):
        _, base, roof, force = (max(map(abs, values)) for values in zip(*rows))
        print(f"{name}: roof against base {roof:.1f} mm, bearing {base:.1f} mm, {force:.1f} kN")
    with open(asked.out / "frame.csv", "w", newline="") as file:
        written = csv.writer(file)
        written.writerow(["time_s", "bearing_mm", "bearing_kN", "roof_on_bearings_mm", "roof_fixed_mm"])
        written.writerows((t, base, force, roof, other[2]) for (t, base, roof, force), other in zip(isolated, fixed))
    drawn = draw(isolated, fixed, asked.law, asked.out / "frame.png")
    print(f"{asked.out / 'frame.csv'}" + (f", {asked.out / 'frame.png'}" if drawn else ""))


if __name__ == "__main__":
    main()
