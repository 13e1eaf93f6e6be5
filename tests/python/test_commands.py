"""Tests that Python gives the bytes of the other commands, and that pickle keeps records and campaigns."""

import csv
import io
import json
import multiprocessing
import pickle
import shutil
import sqlite3
import subprocess
import unittest
import warnings

import numpy as np

import isolaw
from devices import BINARY, InFolder, arrays, files_in, program, write_csv


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def summary_of(record):
    return isolaw.calibrate(record, "bilinear", runs=1, analysis=False).summary


class OfALot(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.files = files_in(cls.path / "r")
        cls.out = cls.path / "out"
        cls.campaign = isolaw.calibrate(cls.files, "bilinear", runs=2, replicates=40, out=cls.out)


class Commands(OfALot):
    def test_export_gives_the_file_of_the_command(self):
        for words in (
            {"to": "opensees", "device": "lot"},
            {"to": "cpp", "device": "a", "units": "N-m", "name": "mine"},
            {"to": "json", "device": "b", "rules": "ntc-2018", "design": {"K_eff": 0.7, "damping": 15}},
        ):
            options = dict(words)
            if "design" in options:
                options["design"] = "K_eff=0.7,damping=15"
            given = [word for key, value in options.items() for word in ("--" + key, value)]
            self.assertEqual(
                str(self.campaign.export("bilinear", **words)), program("export", self.out, "--law", "bilinear", *given)
            )
        exported = self.campaign.export("bilinear", to="abaqus", out=self.path / "law.f")
        self.assertEqual((self.path / "law.f").read_text(), exported.text)

    def test_export_returns_what_its_user_has_to_read(self):
        done = subprocess.run(
            [BINARY, "export", self.out, "--law", "bilinear", "--device", "lot", "--to", "opensees"],
            capture_output=True,
            text=True,
        )
        self.assertEqual(self.campaign.export("bilinear", to="opensees").warnings, done.stderr.splitlines())

    def test_export_refuses_in_keywords(self):
        with self.assertRaisesRegex(isolaw.Error, "^to: excel; allowed: opensees, openseespy"):
            self.campaign.export("bilinear", to="excel")
        with self.assertRaisesRegex(TypeError, "no keyword 'unit'; try 'units'"):
            self.campaign.export("bilinear", to="cpp", unit="N-m")
        with self.assertRaisesRegex(isolaw.Error, "campaign"):  # the store, which an export must not replace
            self.campaign.export("bilinear", to="cpp", out=self.out / "campaign.sqlite")

    def test_sample_draws_the_devices_of_the_command(self):
        with warnings.catch_warnings(record=True):
            warnings.simplefilter("always")
            drawn = self.campaign.sample("bilinear", 7, seed=3)
        rows = list(csv.reader(io.StringIO(program("sample", self.out, "--law", "bilinear", "--count", 7, "--seed", 3))))
        self.assertEqual([name.split(" [")[0] for name in rows[0][1:]], list(drawn))
        np.testing.assert_array_equal(
            np.array([[float(cell) for cell in row[1:]] for row in rows[1:]]), np.column_stack(list(drawn.values()))
        )
        with self.assertRaisesRegex(isolaw.Error, "^count: 0; allowed: 1 to 10000000"):
            self.campaign.sample("bilinear", 0)

    def test_check_finds_a_changed_file(self):
        found = isolaw.check(self.out)
        self.assertTrue(found["sound"])
        self.assertEqual((found["campaign"]["runs"], found["campaign"]["faults"], found["building"]), (4, [], None))
        summary = self.out / "summary.json"
        kept = summary.read_bytes()
        summary.write_bytes(kept.replace(b"bilinear", b"trilinea", 1))
        try:
            found = isolaw.check(self.out)
            self.assertFalse(found["sound"])
            self.assertIn("summary.json", found["campaign"]["faults"][0])
        finally:
            summary.write_bytes(kept)
        with self.assertRaises(isolaw.Error):
            isolaw.check(self.path / "r")

    def test_inspect_gives_what_the_command_prints(self):
        isolaw.example(self.path / "tests", "tests")
        lot = self.path / "tests" / "lot.toml"
        self.assertEqual(isolaw.inspect(lot), json.loads(program("inspect", lot, "--json")))
        asked = {"rules": "ntc-2018", "design": "K_eff=0.62,damping=19.5,disp=208", "lot_size": 40}
        options = [word for key, value in asked.items() for word in ("--" + key.replace("_", "-"), value)]
        self.assertEqual(isolaw.inspect(lot, **asked), json.loads(program("inspect", lot, "--json", *options)))
        asked["design"] = {"K_eff": 0.62, "damping": 19.5, "disp": 208.0}  # replaces the design values of the lot file
        self.assertEqual(isolaw.inspect(lot, **asked), json.loads(program("inspect", lot, "--json", *options)))
        # The records alone have no title and no facts of a lot file; their values are the same.
        mine = isolaw.inspect(self.files, rules="ntc-2018", design={"K_eff": 0.7})
        printed = json.loads(program("inspect", *self.files, "--json", "--rules", "ntc-2018", "--design", "K_eff=0.7"))
        self.assertEqual(mine["devices"], printed["devices"])
        self.assertEqual((mine["result"], mine["assessment"]), (printed["result"], printed["assessment"]))

    def test_inspect_takes_the_tables_of_a_lot_file(self):
        tables = {"device": [{"name": "A", "file": "a.csv"}]}
        found = isolaw.inspect(tables, folder=self.path / "r")
        self.assertEqual((found["name"], found["status"]), ("A", "ok"))

    def test_a_design_value_that_is_hardly_meant_warns(self):
        with self.assertWarnsRegex(UserWarning, "^design damping=0.15: damping is in percent.*; try: damping=15$") as told:
            isolaw.inspect(self.files, rules="ntc-2018", design={"damping": 0.15})
        self.assertEqual(told.filename, __file__)
        with self.assertWarnsRegex(UserWarning, "; try: rules NAME, one of .*, or rules FILE$") as told:
            isolaw.calibrate(self.files[:1], "bilinear", runs=1, analysis=False, design={"K_eff": 0.7})
        self.assertEqual(told.filename, __file__)

    def test_rules_are_those_of_the_command(self):
        self.assertEqual(isolaw.rules(), json.loads(program("rules", "--json")))
        self.assertEqual(isolaw.rules("template"), program("rules", "template"))
        self.assertEqual(isolaw.rules("ntc-2018"), program("rules", "ntc-2018"))
        with self.assertRaisesRegex(isolaw.Error, "ntc-2018"):
            isolaw.rules("ntc")

    def test_examples_are_those_of_the_command(self):
        for kind, option in (("lot", []), ("conditions", ["--conditions"]), ("building", ["--building"])):
            mine, theirs = self.path / "mine" / kind, self.path / "theirs" / kind
            isolaw.example(mine, kind)
            program("example", theirs, *option)
            names = {file.relative_to(theirs) for file in theirs.rglob("*") if file.is_file()}
            self.assertEqual(names, {file.relative_to(mine) for file in mine.rglob("*") if file.is_file()})
            for name in names:
                self.assertEqual((mine / name).read_bytes(), (theirs / name).read_bytes(), name)
        with self.assertRaisesRegex(isolaw.Error, "lot, tests, conditions, building"):
            isolaw.example(self.path / "none", "buildings")


class Pickled(OfALot):
    def test_a_record_comes_back_with_all_that_was_read(self):
        t, x, f = arrays()
        spiked = f.copy()
        spiked[100] += 500.0
        several = isolaw.same_device([isolaw.record(x, f, t, name="one"), isolaw.record(0.5 * x, f, t, name="two")])
        for record in (
            isolaw.read_record(self.files[0]),
            isolaw.read_record(self.files[0], force_factor=0.5, skew_ms=4.0, units={"disp": "mm"}),
            isolaw.record(x, spiked, t, name="spiked"),
            several,
            isolaw.motion(x, t),
        ):
            copy = again(record)
            self.assertEqual(copy, record)
            self.assertEqual(hash(copy), hash(record))
            self.assertEqual((copy.recognised, copy.warnings), (record.recognised, record.warnings))
            np.testing.assert_array_equal(copy.disp_mm, record.disp_mm)
            if record.force_kN is not None:
                self.assertEqual(isolaw.properties(copy), isolaw.properties(record))
        self.assertNotEqual(isolaw.record(x, f, t), isolaw.record(x, 1.001 * f, t))
        self.assertNotEqual(isolaw.record(x, f, t), "a record")

    def test_a_pickled_record_is_fitted_as_the_record(self):
        record = isolaw.read_record(self.files[0], force_factor=0.5, skew_ms=4.0)
        fits = [isolaw.calibrate(one, "bilinear", runs=1, replicates=40) for one in (record, again(record))]
        self.assertEqual(fits[0].summary, fits[1].summary)

    def test_a_campaign_comes_back_with_its_runs_and_analyses(self):
        copy = again(self.campaign)
        self.assertEqual(copy, self.campaign)
        np.testing.assert_array_equal(
            copy.runs("bilinear", "b")["parameters"], self.campaign.runs("bilinear", "b")["parameters"]
        )
        self.assertEqual(str(copy.export("bilinear", to="cpp")), str(self.campaign.export("bilinear", to="cpp")))
        fit = again(self.campaign["bilinear"]["a"])
        self.assertEqual(fit.parameters, self.campaign["bilinear"]["a"].parameters)
        self.assertEqual(fit, self.campaign["bilinear"]["a"])
        self.assertNotEqual(fit, self.campaign["bilinear"]["b"])
        self.assertEqual({fit: 1}[self.campaign["bilinear"]["a"]], 1)
        self.assertEqual(again(self.campaign["bilinear"]), self.campaign["bilinear"])

    def test_a_model_comes_back_with_its_keywords(self):
        record = isolaw.read_record(self.files[0])
        model = isolaw.Model("bilinear", record, samples_per_cycle=None, weights="travel", refinement=2)
        copy = again(model)
        self.assertEqual(copy, model)
        self.assertEqual(isolaw.Model("bilinear", record), isolaw.Model("bilinear", self.files[0], smooth=1, fit_blocks="all"))
        self.assertEqual(len(copy.disp_mm), len(record))
        values = self.campaign.parameters("bilinear", "a")
        self.assertEqual(copy.objective(values), model.objective(values))

    def test_processes_fit_the_records_of_another(self):
        records = [isolaw.read_record(file) for file in self.files]
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            found = pool.map(summary_of, records)
        self.assertEqual(found, [summary_of(record) for record in records])


class ForceOfAFit(InFolder):
    def test_is_that_of_simulate_with_the_dead_band_of_the_fit(self):
        rng = np.random.default_rng(1)
        files = []
        for name, strength in (("a", 20.0), ("b", 24.0)):
            t, x, f = arrays(strength)
            files.append(self.path / f"{name}.csv")
            write_csv(files[-1], t, x + rng.normal(0.0, 0.05, len(x)), f)
        out = self.path / "out"
        campaign = isolaw.calibrate(files, "power-masing", runs=1, replicates=0, out=out)
        t, x, _ = arrays()
        noisy = 1.5 * x + rng.normal(0.0, 0.05, len(x))
        write_csv(self.path / "m.csv", t, noisy, header="time [s],displacement [mm]")
        motion = isolaw.read_motion(self.path / "m.csv")
        for device in ("lot", "a"):
            words = ("simulate", "power-masing", "--from", out, "--device", device, "--motion", self.path / "m.csv")
            lines = [line for line in program(*words).splitlines() if line and (line[0].isdigit() or line[0] == "-")]
            expected = [float(line.split(",")[-1]) for line in lines]
            with self.assertWarnsRegex(UserWarning, "beyond it nothing was measured"):
                found = campaign.force("power-masing", device, motion)
            np.testing.assert_array_equal(found, expected)
        without = isolaw.force("power-masing", campaign.parameters("power-masing", "a"), motion)
        self.assertGreater(np.abs(without - found).max(), 0.01)
        record = campaign.fit_record("a")
        again = campaign["power-masing"]["a"].force(isolaw.motion(record["disp_mm"], record["time_s"]))
        np.testing.assert_allclose(again, campaign.force("power-masing", "a"), rtol=0.0, atol=1e-9)


class ForceOfABadLaw(InFolder):
    def test_is_refused_as_simulate_refuses_it(self):
        t, x, _ = arrays(cycles=6)
        x = np.where(t < 6.0, 0.3, 1.0) * x
        force = 0.5 * x + 4e-5 * x**3  # hardening, which the first three cycles do not show and a bilinear law cannot have
        record = isolaw.record(x, np.where(np.abs(x) > 40.0, 6.0 * force, force) + 5.0 * np.sign(np.gradient(x)), t)
        campaign = isolaw.calibrate(record, "bilinear", runs=1, analysis=False, fit_blocks="1")
        motion = isolaw.motion(x, t)
        with self.assertRaisesRegex(isolaw.Error, "its prediction is unusable"):
            campaign["bilinear"]["record"].force(motion)
        with self.assertWarnsRegex(UserWarning, "its prediction is unusable"):
            campaign.force("bilinear", "record", motion, anyway=True)


class Parts(OfALot):
    def test_a_motion_has_no_model_and_no_box(self):
        t, x, _ = arrays()
        for function in (isolaw.Model, isolaw.box):
            with self.assertRaisesRegex(isolaw.Error, "a motion without force"):
                function("bilinear", isolaw.motion(x, t))

    def test_numbers_of_numpy_are_numbers(self):
        found = isolaw.inspect(self.files[0], rules="ntc-2018", design={"K_eff": np.float32(0.5)})
        self.assertEqual(found["assessment"]["design"][0]["value"], 0.5)

    def test_a_law_without_a_fit_has_no_plot(self):
        t, x, f = arrays()
        record = isolaw.record(x, f, name="timeless")
        fit = isolaw.calibrate(record, ["bilinear", "jankowski"], runs=1, analysis=False)["jankowski"]["timeless"]
        with self.assertRaisesRegex(isolaw.Error, "no usable run"):
            fit.plot()

    def test_damaged_bytes_of_a_store_are_faults(self):
        for table, column in (("device", "recognised"), ("device", "tests"), ("run", "message"), ("setting", "json")):
            copy = self.path / f"{table}-{column}"
            shutil.copytree(self.out, copy)
            with sqlite3.connect(copy / "campaign.sqlite") as store:
                store.execute(f"UPDATE {table} SET {column} = CAST(X'BAFF' AS TEXT)")
            with self.subTest(f"{table}.{column}"):
                with self.assertRaises(isolaw.Error):
                    isolaw.load(copy)
                try:
                    self.assertFalse(isolaw.check(copy)["sound"])
                except isolaw.Error as error:
                    self.assertTrue(error.complaints)

    def test_intervals_and_statistics_are_those_of_the_summary(self):
        fit = self.campaign["bilinear"]["a"]
        one = self.campaign.summary["laws"][0]["devices"][0]["parameters"]["K1"]
        self.assertEqual(fit.statistics["K1"], one)
        self.assertEqual(fit.intervals["K1"], tuple(one["bootstrap_interval"]))
        self.assertEqual(self.campaign["bilinear"].statistics, self.campaign.summary["laws"][0]["population"])
        record = isolaw.read_record(self.files[0])
        self.assertEqual(self.campaign.properties("a")["blocks"], isolaw.properties(record)["blocks"])
        without = isolaw.calibrate(self.files[0], "bilinear", runs=1, analysis=False)
        self.assertEqual(set(without["bilinear"]["a"].intervals.values()), {None})


if __name__ == "__main__":
    unittest.main()
