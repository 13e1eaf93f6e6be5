"""Runs the program and its scrambled twin (scrambled.cpp) on the same input and compares every result but the sentences.

Usage: compare.py PROGRAM SCRAMBLED EXAMPLE_LOT SCRATCH_FOLDER
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys

program, scrambled, example, scratch = sys.argv[1:]
scratch = pathlib.Path(scratch)
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)

# Members of the JSON output that contain only sentences.
SENTENCES = {
    "sentence", "why", "would_decide", "answer", "reason", "programs", "headline", "explanation", "warnings", "recognised", "notes",
    "corrections", "cleaning", "message", "verdict_text", "properties_refusal", "prediction", "objection", "verdict",
    "doubts", "not_monotonic", "refusal", "condition", "converged", "remark", "choice",
    "counting_block_choice",
}


def with_spike(source: pathlib.Path, target: pathlib.Path, sample: int) -> None:
    """Returns a copy of a record of the example lot in which the force of one sample is wrong by 60 kN."""
    lines = source.read_text(encoding="utf-8-sig").splitlines()
    first = next(i for i, line in enumerate(lines) if re.match(r"[-\d]", line))
    cells = lines[first + sample - 1].split(",")
    cells[2] = f"{float(cells[2]) + 60:.3f}"
    lines[first + sample - 1] = ",".join(cells)
    target.write_text("\n".join(lines) + "\n")


records = scratch / "records"
records.mkdir()
for number, sample in ((1, 151), (6, 421), (8, 301)):
    with_spike(pathlib.Path(example) / f"device-{number:02}.csv", records / f"spiked-{number:02}.csv", sample)
for number in (2, 9, 10):
    shutil.copy(pathlib.Path(example) / f"device-{number:02}.csv", records)

COMMANDS = (
    ("inspect", str(records), "--json"),
    ("calibrate", str(records), "--laws", "bilinear,bouc-wen,jankowski", "--runs", "2", "--replicates", "0", "--jobs", "2",
     "--out", "OUT/lot", "--figures", "none", "--json"),
    ("report", "OUT/lot", "--json", "--figures", "none"),
    ("export", "OUT/lot", "--law", "bouc-wen", "--device", "lot", "--to", "json"),
    ("export", "OUT/lot", "--law", "jankowski", "--device", "lot", "--to", "json", "--anyway"),
    ("check", "OUT/lot"),
)


def run(binary: str, out: pathlib.Path) -> list[tuple[int, str]]:
    results = []
    for words in COMMANDS:
        words = [word.replace("OUT", str(out)) for word in words]
        done = subprocess.run([binary, *words], capture_output=True, text=True, check=False)
        results.append((done.returncode, done.stdout))
    return results


def differences(one, other, path: str, found: list[str]) -> None:
    """Collects where two JSON values differ. Sentences are not compared, as some name the folder of the results."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in one.keys() | other.keys():
            if key not in SENTENCES and key not in ("profile", "isolaw", "build"):
                differences(one.get(key), other.get(key), f"{path}.{key}", found)
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for place, pair in enumerate(zip(one, other)):
            differences(*pair, f"{path}[{place}]", found)
    elif one != other:
        found.append(f"{path}: {one!r:.80} and {other!r:.80}")


ordinary, twisted = run(program, scratch / "ordinary"), run(scrambled, scratch / "scrambled")
problems: list[str] = []
said = 0
for words, (code, text), (other_code, other) in zip(COMMANDS, ordinary, twisted):
    if code != other_code:
        problems.append(f"{words[0]}: exit code {code} and {other_code}")
    if not text.lstrip().startswith("{"):
        continue
    said += "¿" in other
    differences(json.loads(text), json.loads(other), words[0], problems)
if said < 3:
    problems.append(f"only {said} commands printed a scrambled sentence: the comparison shows nothing")
if any(".calibrated_by:" in problem for problem in problems):
    problems.append("the two programs are of different builds: build the target scrambled_program")
print("\n".join(problems) or f"{len(COMMANDS)} commands give the same results with scrambled sentences")
sys.exit(1 if problems else 0)
