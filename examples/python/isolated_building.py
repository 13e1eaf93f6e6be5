#!/usr/bin/env python3
"""Checks whether bound analyses cover the effect of a lot's scatter, for a building on bearings drawn from the lot.

Fits a law to three devices of the lot, draws bearings from their population for a building of three floors, shakes it
with artificial motions, and prints the answer and, for each motion, the range of the draws. Run it after
./isolaw.sh run:

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/isolated_building.py
"""

import argparse
import pathlib
import sys

import isolaw
import numpy as np

LOT = pathlib.Path(__file__).resolve().parent.parent / "published-lot"
SLAB = {"mass_Mg": 300.0, "gyration_m": 5.0}
PLAN = {
    "building": {"lower": 0.9, "upper": 1.1},  # factors of the bound analyses
    "base": SLAB,
    "floors": {"count": 3, **SLAB, "period_x_s": 0.4, "period_y_s": 0.4},
    "grid": {"along": 3, "across": 2, "spacing_x_m": 6.0, "spacing_y_m": 6.0},
}


def swinging(number):
    """Returns (step in s, accelerations along x and y in m/s2): growing and fading sines; `number` sets the periods."""
    t = np.arange(0.0, 10.0, 0.01)
    grown = np.sin(np.pi * t / t[-1])
    return 0.01, 2.0 * grown * np.sin((2.0 + 0.4 * number) * t), grown * np.cos((2.5 + 0.3 * number) * t)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--law", default="bilinear")
    options.add_argument("--draws", type=int, default=200)
    options.add_argument("--out", type=pathlib.Path, help="directory of runs and reports; building.html is the report")
    asked = options.parse_args()

    def show(done, total):
        print(f"\r{done} of {total} analyses ", end="" if done < total else "\n", file=sys.stderr, flush=True)

    lot = isolaw.calibrate(sorted(LOT.glob("device-*"))[:3], asked.law, runs=1, replicates=40)
    motions = [swinging(number) for number in range(1, 8)]
    building = isolaw.building(PLAN, lot, motions, laws=asked.law, draws=asked.draws, out=asked.out, progress=show)
    print(building.results["verdict"])
    for name, peaks in zip(building.motions, building.peaks()[0].T):
        low, middle, high = np.quantile(peaks, (0.05, 0.5, 0.95))
        print(f"{name}: a bearing moves {middle:.1f} mm ({low:.1f} to {high:.1f} mm, 90 % of the draws)")


if __name__ == "__main__":
    main()
