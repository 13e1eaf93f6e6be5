#!/usr/bin/env python3
"""Makes fuzz/corpus/store again, after a change of the store's schema: python3 fuzz/store_corpus.py ISOLAW [--all FOLDER]

Each file is a tiny campaign. It is as the program wrote it, or it has one change that isolaw itself never makes.
"""
import math
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import sys
import tempfile

ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)"


def view(table, body):
    """Returns SQL that replaces a table by a view of the same name."""
    return f"ALTER TABLE {table} RENAME TO kept; CREATE VIEW {table} AS {body}"


def series(value):
    return f"UPDATE series SET \"values\" = {value}"


FAULTS = {
    "sound": "",
    "device-far": "UPDATE search SET device = 9223372036854775807",
    "device-negative": "UPDATE search SET device = -1; UPDATE run SET device = -1",
    "law-unknown": "UPDATE search SET law = 'x'; UPDATE run SET law = 'x'",
    "run-number-huge": "UPDATE run SET number = number + 4294967296",
    "evaluations-huge": "UPDATE run SET evaluations = 9223372036854775807, failed_evaluations = -9223372036854775808",
    "objective-infinite": "UPDATE run SET objective = 9e999",
    "objective-text": "UPDATE run SET objective = 'many', evaluations = 'x', number = 'y' || number",
    "parameters-huge": "UPDATE run_parameter SET value = 1e308",
    "parameters-infinite": "UPDATE run_parameter SET value = -9e999",
    "box-empty": "DELETE FROM search_parameter",
    "box-null": "UPDATE search_parameter SET value = NULL, lower = NULL, upper = NULL, scale = 'x'",
    "history-odd": "UPDATE run SET history = zeroblob(7)",
    "history-text": "UPDATE run SET history = 'abcdefghijkl'",
    "series-short": series("zeroblob(16)"),
    "series-empty": series("zeroblob(0)"),
    "series-zero": series("zeroblob(96)"),
    "series-nan": series("x'" + "000000000000f87f" * 12 + "'"),
    "series-infinite": series("x'" + "000000000000f07f" * 12 + "'"),
    "series-huge": series("x'" + "ffffffffffffef7f" * 12 + "'"),
    "series-one-nan": series("with_nan(\"values\") WHERE kind = 'raw' AND channel = 'disp_mm'"),
    "series-one-empty": "UPDATE series SET \"values\" = x'' WHERE channel = 'time_s'",
    "setting-gone": "DELETE FROM setting WHERE key = 'runs'",
    "setting-no-json": "UPDATE setting SET json = '{' WHERE key = 'runs'",
    "setting-type": "UPDATE setting SET json = '\"x\"' WHERE key = 'runs'",
    "setting-range": "UPDATE setting SET json = '1e300' WHERE key IN ('runs', 'population')",
    "setting-deep": "UPDATE setting SET json = replace(hex(zeroblob(1500)), '0', '[') WHERE key = 'laws'",
    "laws-twice": "UPDATE setting SET json = '[\"bilinear\",\"bilinear\"]' WHERE key = 'laws'",
    "laws-none": "UPDATE setting SET json = '[]' WHERE key = 'laws'",
    "set-odd": "UPDATE setting SET json = '[\"bilinear.K1=nan\", \"x\"]' WHERE key = 'set'",
    "warnings-no-json": "UPDATE device SET warnings = '[1]', recognised = 'x'",
    "name-control": "UPDATE device SET name = 'a' || char(27) || '[31m' || char(10), file = char(7)",
    "name-no-utf8": "UPDATE device SET name = CAST(x'ff9b' AS TEXT), serial = CAST(x'c3' AS TEXT)",
    "name-blob": "UPDATE device SET name = x'00ff00', message = x'00'",
    "title-html": "UPDATE meta SET value = '</script><script>{{data}}' WHERE key = 'title'",
    "faults-elsewhere": "UPDATE meta SET value = '[{\"device\":7,\"corrected\":true,\"samples\":[0],\"finding\":[]}]' WHERE key = 'faults'",
    "device-id-gap": "UPDATE device SET id = 7",
    "device-refused": "UPDATE device SET status = 'refused', message = ''",
    "devices-none": "DELETE FROM device",
    "numbers-infinite": "UPDATE device SET temperature_C = 9e999, rubber_area_mm2 = -9e999, rubber_thickness_mm = 0",
    "schema-next": "UPDATE meta SET value = '99' WHERE key = 'schema'",
    "view-endless-runs": view("run", f"{ENDLESS} SELECT device, law, i AS number, outcome, objective, integration_shift, "
                                     "evaluations, failed_evaluations, message, history FROM n JOIN kept"),
    "view-endless-setting": view("setting", f"{ENDLESS} SELECT i AS position, 'k' || i AS key, '1' AS json FROM n"),
    "view-endless-meta": view("meta", f"{ENDLESS} SELECT 'x' AS key, 'y' AS value FROM n"),
    "view-large-values": view("series", "SELECT device, kind, channel, count, zeroblob(900000000) AS \"values\" FROM kept"),
    "generated-column": "ALTER TABLE device RENAME TO kept; CREATE TABLE device AS SELECT * FROM kept; "
                        "ALTER TABLE device DROP COLUMN message; ALTER TABLE device ADD COLUMN message TEXT "
                        "GENERATED ALWAYS AS (hex(zeroblob(400000000))) VIRTUAL",
}

# Only these files are committed: "sound", which is valid; files that a careless reader would accept or never finish
# reading; and files that isolaw reads nearly to their end before it refuses them. --all writes all files, as a start
# for a longer fuzz run.
KEPT = {"sound", "view-endless-runs", "view-endless-setting", "view-large-values", "generated-column", "setting-range",
        "run-number-huge", "parameters-infinite", "box-null", "name-control", "series-one-nan", "history-odd"}


def main():
    isolaw = str(pathlib.Path(sys.argv[1]).resolve())
    everything = sys.argv[2:3] == ["--all"]
    target = pathlib.Path(sys.argv[3]) if everything else pathlib.Path(__file__).parent / "corpus" / "store"
    target.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        rows = [(0.1 * i, 100 * math.sin(i * math.pi / 5), 50 * math.sin(i * math.pi / 5 + 0.3)) for i in range(12)]
        (folder / "a.csv").write_text("t [s],disp [mm],force [kN]\n" + "".join("%g,%.3f,%.3f\n" % r for r in rows))
        subprocess.run([isolaw, "calibrate", "a.csv", "--laws", "bilinear", "--runs", "2", "--population", "4",
                        "--generations", "2", "--samples-per-cycle", "all", "--out", "O"],
                       cwd=folder, check=True, capture_output=True)
        for name, sql in FAULTS.items():
            if name not in KEPT and not everything:
                continue
            file = target / (name + ".sqlite")
            shutil.copy(folder / "O" / "campaign.sqlite", file)
            store = sqlite3.connect(file)
            store.create_function("with_nan", 1, lambda blob: blob[:72] + struct.pack("<d", math.nan) + blob[80:])
            store.executescript("PRAGMA page_size = 512; VACUUM; PRAGMA ignore_check_constraints = ON; "
                                "PRAGMA legacy_alter_table = ON;")
            store.executescript(sql)
            store.commit()
            store.execute("VACUUM")
            store.close()


main()
