#!/usr/bin/env python3
"""Measures the time, memory and bytes that a merge of 10, 100 and 1,000 synthetic parts takes.

bench/merge_sweep.py ISOLAW [RUNS_PER_PART] [PARTS,PARTS,...]; prints the table of docs/scale.md. Each part is a real part
of the built-in lot (ten devices, two laws), whose runs are copied under other numbers. Its rows have the form of a real
campaign's, but their results mean nothing.
"""
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time

isolaw = os.path.abspath(sys.argv[1])
per_part = int(sys.argv[2]) if len(sys.argv) > 2 else 200
sweep = [int(n) for n in sys.argv[3].split(",")] if len(sys.argv) > 3 else [10, 100, 1000]
searches = 20
each = per_part // searches  # number of runs that one part computes for each search


def parts_of(count, work):
    runs = each * count
    # Part 1 of `count` parts has the runs 1, 1 + count, 1 + 2 count and so on of every search. To save time, `isolaw
    # calibrate` computes only run 1 of each search, and SQL copies it under the other numbers.
    first = os.path.join(work, "real")
    subprocess.run(
        [isolaw, "calibrate", "lot/lot.toml", "--laws", "bilinear,bouc-wen", "--runs", str(count), "--method", "best",
         "--samples-per-cycle", "60", "--analysis", "none", "--part", f"1/{count}", "--out", first],
        cwd=work, check=True, capture_output=True)
    store = os.path.join(first, "campaign.sqlite")
    db = sqlite3.connect(store)
    db.execute("UPDATE setting SET json = ? WHERE key = 'runs'", (str(runs),))
    names = [row[1] for row in db.execute("PRAGMA table_info(run)")]
    numbered = ", ".join("number + :shift" if name == "number" else f'"{name}"' for name in names)
    for i in range(1, each):
        shift = {"shift": i * count}
        db.execute(f"INSERT INTO run SELECT {numbered} FROM run WHERE number <= {count}", shift)
        db.execute("INSERT INTO run_parameter SELECT device, law, number + :shift, position, value FROM run_parameter "
                   f"WHERE number <= {count}", shift)
    db.commit()
    db.close()
    folders = []
    for number in range(1, count + 1):
        folders.append(os.path.join(work, str(number)))
        os.mkdir(folders[-1])
        copy = os.path.join(folders[-1], "campaign.sqlite")
        shutil.copyfile(store, copy)
        db = sqlite3.connect(copy)
        db.execute("PRAGMA synchronous = OFF")
        db.execute("UPDATE meta SET value = ? WHERE key = 'part'", (f"{number}/{count}",))
        for table in ("run", "run_parameter"):
            db.execute(f"UPDATE {table} SET number = number + ?", (number - 1,))
        db.commit()
        db.close()
    return folders, os.path.getsize(store)


print("| parts | runs | bytes of a part | merged bytes | bytes a run | time [s] | ms a part | most memory [MiB] |")
print("|---|---|---|---|---|---|---|---|")
for count in sweep:
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([isolaw, "example", "lot"], cwd=work, check=True, capture_output=True)
        parts, part_bytes = parts_of(count, work)
        begin = time.monotonic()
        process = subprocess.Popen([isolaw, "merge", "whole", "--copy-only", *parts], cwd=work,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        said = process.stderr.read().decode()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - begin
        if process.returncode != 0:
            sys.exit(said)
        whole = os.path.getsize(os.path.join(work, "whole", "campaign.sqlite"))
        runs = count * each * searches
        print(f"| {count} | {runs} | {part_bytes} | {whole} | {whole / runs:.0f} | {seconds:.1f} | "
              f"{1e3 * seconds / count:.1f} | {used.ru_maxrss / 1024:.0f} |", flush=True)
