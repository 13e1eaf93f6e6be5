#!/usr/bin/env python3
"""Computes a campaign in parts with Dask and merges them. Each part is a future; its result is a file with its runs.

Workers need a common disk only for the records. A worker computes its part on its own disk and returns the store as
bytes. If a worker is lost, another one computes its part again. Parts that have arrived are kept, so the same command
continues after any loss; parts of other settings or records are refused. Needs python3-distributed. Run it after
./isolaw.sh run:

    PYTHONPATH=build/release/python /usr/bin/python3 examples/python/parts_with_dask.py examples/published-lot/*.csv

--scheduler ADDRESS uses an existing cluster (dask-jobqueue, Kubernetes); all of its workers need this isolaw and, if
their processors differ, the same ISOLAW_SIMD.
"""

import argparse
import os
import pathlib
import tempfile

import distributed

import isolaw

STORE = "campaign.sqlite"


def share(files, settings, number, of, there=None):
    """Runs on a worker. Computes part `number` of `of`, or continues it from the store `there`; returns its store."""
    with tempfile.TemporaryDirectory(dir=distributed.get_worker().local_directory) as folder:
        if there:
            (pathlib.Path(folder) / STORE).write_bytes(there)
        isolaw.calibrate(files, **settings, part=(number, of), jobs=1, out=folder)
        return (pathlib.Path(folder) / STORE).read_bytes()


def campaign(client, files, settings, of, out, compute=share):
    """Computes the campaign in parts. `out` gets the same bytes as by isolaw.calibrate(files, **settings, out=out)."""
    files = [str(pathlib.Path(file).resolve()) for file in files]
    parts = {number: pathlib.Path(f"{out}.parts") / str(number) for number in range(1, of + 1)}
    there = {number: (part / STORE).read_bytes() for number, part in parts.items() if (part / STORE).exists()}
    # Without pure=False, Dask would answer a repeated call with equal arguments by the old future, even if the
    # directory of the part was lost in the meantime.
    futures = {
        client.submit(compute, files, settings, number, of, there.get(number), pure=False): number for number in parts
    }
    for future, store in distributed.as_completed(futures, with_results=True):
        number = futures[future]
        future.release()
        if store == there.get(number):
            continue
        part = parts[number]
        part.mkdir(parents=True, exist_ok=True)
        (part / "arriving").write_bytes(store)
        os.replace(part / "arriving", part / STORE)  # replaces the store as a whole or not at all
        print(f"part {number} of {of} is here", flush=True)
    return isolaw.merge(out, parts.values())


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("records", nargs="+")
    options.add_argument("--parts", type=int, default=8, help="some two or three for each worker (8)")
    options.add_argument("--workers", type=int, default=2, help="processes on this machine (2)")
    options.add_argument("--scheduler", help="of a cluster that is there, in their place")
    options.add_argument("--laws", default="usual")
    options.add_argument("--runs", type=int)
    options.add_argument("--out", default="out/dask")
    asked = options.parse_args()
    settings = {"laws": asked.laws, "runs": asked.runs}
    here = {"n_workers": asked.workers, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    cluster = asked.scheduler or distributed.LocalCluster(**here)
    with distributed.Client(cluster) as client:
        result = campaign(client, asked.records, settings, asked.parts, asked.out)
    if not asked.scheduler:
        cluster.close()
    for row in result.front("converged"):
        print(f"{row['law']:<20} {row['accuracy']:.4f}")


if __name__ == "__main__":
    main()
