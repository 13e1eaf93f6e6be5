"""Looks for code outside the table of sentences that compares, cuts or searches words.

It reports each search, comparison or cut, in C++ and in the page's script, that has a literal of two words or more.
Usage: searched.py SOURCE_FOLDER. The exit code is 1 if it finds such a place that is not listed below.
"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
PHRASE = r"[^\"'`/\n]*[A-Za-z]{2,} [A-Za-z]{2,}[^\"'`/\n]*"
CPP = re.compile(
    r'(?:starts_with|ends_with|contains|r?find(?:_first_of)?|compare|erase|replace)\(\s*(?:[\w.>-]+,\s*)?"(' + PHRASE + r')"'
    r'|[!=]=\s*"(' + PHRASE + r')"'
)
SCRIPT = re.compile(
    r"(?:includes|startsWith|endsWith|indexOf|lastIndexOf|split|replace|match|search|test)\(\s*(?:['\"`](" + PHRASE + r")['\"`]|/(" + PHRASE + r")/)"
    r"|[!=]==?\s*['\"`](" + PHRASE + r")['\"`]"
    r"|/(" + PHRASE + r")/[a-z]*\.test\("
)
# The allowed literals are words of foreign files, names of JSON members and values of enumerations. None is a sentence
# of the program.
ALLOWED = {
    ("src/isolaw/data/channels/ground_motion.cpp", "1 UNCORRECTED ACCELEROGRAM"),  # written by an agency
    ("src/isolaw/data/channels/ground_motion.cpp", "2 CORRECTED ACCELEROGRAM"),  # written by an agency
    ("src/isolaw/data/channels/ground_motion.cpp", "uncorrected accelerogram data"),  # written by an agency
    ("src/isolaw/data/channels/ground_motion.cpp", "corrected acceleration    (format v01.20"),  # written by an agency
    ("src/isolaw/data/files/exporter.cpp", "Raw Data"),  # written by the program that recorded the file
    ("src/isolaw/data/files/mat_table.cpp", "table or object"),  # a class of MATLAB variables
    ("src/isolaw/programs/header_parts.cpp", "struct OpenBranches"),  # C++ code of an exported header
    ("src/isolaw/programs/header_parts.cpp", "using std::"),  # C++ code of an exported header
    ("src/isolaw/render/page/script/certificate/device_page.js", "not assessed"),  # value of an enumeration
    ("src/isolaw/render/page/script/certificate/verdict.js", "not assessed"),  # value of an enumeration
    ("src/isolaw/render/page/script/decision/laws.js", "ruled out"),  # value of an enumeration
    ("src/isolaw/render/page/script/icons.js", "not adequate"),  # value of an enumeration
    ("src/isolaw/render/page/script/laws.js", "not adequate"),  # value of an enumeration
}

found = []
for folder, suffixes, pattern in (
    ("src/isolaw", {".cpp", ".hpp"}, CPP), ("cli", {".cpp"}, CPP), ("python", {".cpp"}, CPP),
    ("src/isolaw/render/page", {".js"}, SCRIPT), ("page", {".js"}, SCRIPT),
):
    for path in sorted((root / folder).rglob("*")):
        name = path.relative_to(root).as_posix()
        if path.suffix not in suffixes or name.startswith("src/isolaw/wording/"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for match in pattern.finditer(line.split(" // ")[0]):
                words = next(group for group in match.groups() if group)
                if (name, words) not in ALLOWED:
                    found.append(f"{name}:{number}: '{words}'")
print("\n".join(found) or "no code compares, cuts or searches words outside the table")
sys.exit(1 if found else 0)
