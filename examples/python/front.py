#!/usr/bin/env python3
"""Compares accuracy and robustness of laws on the example lot: Fig. 14 of Cucuzza et al., Structures 73 (2025) 108355.

Fits the laws to every device as the paper did (genetic algorithm in the published boxes), prints the table, and writes
front.csv and, if matplotlib is installed, front.png. Run it after ./isolaw.sh run:

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/front.py
"""

import argparse
import csv
import pathlib
import sys

import isolaw

HERE = pathlib.Path(__file__).resolve().parent
LOT = HERE.parent / "published-lot"


def fitted(laws, runs, generations, show):
    """Runs the campaign of examples/published-lot/study.toml. Its records are computed from published parameters."""
    files = sorted(LOT.glob("device-*"))
    records = [isolaw.read_record(file, name=f"D{file.stem[-2:]}") for file in files]
    return isolaw.calibrate(
        records, laws, method="ga", box="published", runs=runs, generations=generations, smooth=5, analysis=False,
        progress=show,
    )  # fmt: skip


def draw(campaign, file):
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    campaign.plot_front().figure.savefig(file, dpi=150)
    return True


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--laws", default="all")
    options.add_argument("--runs", type=int, default=20)
    options.add_argument("--generations", type=int, default=50)
    options.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/front"))
    asked = options.parse_args()

    def show(done, total, analysis, best, share, left_s):
        told = f"\r{done} of {total} runs, {share:.0%}, {left_s:.0f} s left "
        print(told, end="" if done < total else "\n", file=sys.stderr, flush=True)

    campaign = fitted(asked.laws, asked.runs, asked.generations, show)
    rows = campaign.front()
    print(f"{'law':<12}{'accuracy':>12}{'robustness':>12}  front")
    for row in sorted(rows, key=lambda row: row["accuracy"]):
        robustness = "-" if row["robustness"] is None else f"{row['robustness']:.4f}"
        print(f"{row['law']:<12}{row['accuracy']:>12.4f}{robustness:>12}  {'*' if row['on_front'] else ''}")
    asked.out.mkdir(parents=True, exist_ok=True)
    with open(asked.out / "front.csv", "w", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys())
        table.writeheader()
        table.writerows(rows)
    drawn = draw(campaign, asked.out / "front.png")
    print(f"written: {asked.out}/front.csv" + (" and front.png" if drawn else " (front.png needs python3-matplotlib)"))


if __name__ == "__main__":
    main()
