#!/usr/bin/env python3
"""Runs the blocks of the tutorials (docs/tutorial/*.md) and writes below each what it prints and draws.

    tools/tutorials.py [--check] [PAGE...]    with isolaw in PATH, and its Python package in PYTHONPATH

The blocks of a page, ```python and ```sh, run one after another in a new folder that has `examples` in it. What a block
prints stands below it in a block ```text; as in a notebook, this includes the value of a last line of Python. There the
line `...` stands for lines that are left out, and `...` at the end of a line for the rest of the line. The picture
below a block, ![...](NAME.svg), is what the block draws.

With --check nothing is written. The exit code is 1 if a page would change; the content of pictures is not compared.
"""

import ast
import contextlib
import difflib
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
try:
    import matplotlib.pyplot as plt
    import pandas  # noqa: F401
    import scipy  # noqa: F401
except ImportError as missing:
    sys.exit(f"skipped: {missing}")
plt.switch_backend("svg")
plt.rcParams.update({"svg.hashsalt": "isolaw", "svg.fonttype": "none", "figure.figsize": (6.0, 4.0)})

# Matches a block, which may be followed by what it prints and by its picture.
BLOCK = re.compile(
    r"^```(python|sh)\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?(?:\n(!\[[^\]]*\]\(([^)]*\.svg)\)\n))?", re.M | re.S
)


def run_python(code, names):
    """Runs a block and returns what it prints, with the value of its last line as a notebook shows it."""
    printed = io.StringIO()
    lines = ast.parse(code).body
    last = lines.pop() if isinstance(lines[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(lines, []), "block", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "block", "eval"), names) if last else None
        if value is not None and not plt.get_fignums():
            print(repr(value))
    return printed.getvalue()


def run_shell(code):
    """Runs a block and returns its standard output. Exit code 1 is accepted: isolaw has it if a limit is not kept."""
    done = subprocess.run(["bash", "-c", code], capture_output=True, text=True)
    if done.returncode > 1:
        sys.exit(f"{code}ended with {done.returncode}: {done.stderr}")
    return done.stdout


def still_true(shown, printed):
    """Returns whether the text `shown` on the page agrees with what was printed; `...` may stand for any text."""
    pattern = ""
    for line in shown.splitlines(True):
        start = line.removesuffix("...\n")
        pattern += "(?:.*\n)*?" if not start else re.escape(start) + (".*\n" if start != line else "")
    return re.fullmatch(pattern, printed) is not None


def run_page(page, pictures):
    """Returns the text of a page with what its blocks print now, and writes what they draw into a folder."""
    names = {"__name__": "__main__"}

    def run(found):
        language, code, shown, picture, file = found.groups()
        printed = run_python(code, names) if language == "python" else run_shell(code)
        printed = re.sub(r"[ \t]+$", "", printed, flags=re.M)
        if bool(plt.get_fignums()) != bool(picture):
            fault = "draws nothing" if picture else "needs a line ![...](NAME.svg) below it"
            sys.exit(f"{page}: this block {fault}:\n{code}")
        if picture:
            plt.savefig(pictures / file, metadata={"Date": None}, bbox_inches="tight")
            plt.close("all")
        if shown and still_true(shown, printed):
            printed = shown
        below = f"\n```text\n{printed}```\n" if printed else ""
        return f"```{language}\n{code}```\n{below}" + (f"\n{picture}" if picture else "")

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pathlib.Path("examples").symlink_to(ROOT / "examples")
        return BLOCK.sub(run, page.read_text())


arguments = sys.argv[1:]
check = "--check" in arguments
given = [pathlib.Path(one).resolve() for one in arguments if one != "--check"]
changed = False
os.environ["LC_ALL"] = "C.UTF-8"
for page in given or sorted(ROOT.glob("docs/tutorial/*.md")):
    with tempfile.TemporaryDirectory() as scratch:
        text = run_page(page, pathlib.Path(scratch) if check else page.parent)
    if text != page.read_text():
        changed = True
        lines = (page.read_text().splitlines(), text.splitlines())
        print(*difflib.unified_diff(*lines, page.name, "what it prints", lineterm=""), sep="\n")
        if not check:
            page.write_text(text)
if check and changed:
    sys.exit("run ./isolaw.sh docs, look at the page, and commit")
