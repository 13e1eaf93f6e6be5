import json
import os
import pathlib
import threading
import unittest

import numpy as np

import isolaw
from devices import InFolder, arrays, files_in, program, write_csv

LAWS = ["bilinear", "menegotto-pinto"]


class Campaigns(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.files = files_in(cls.path / "r")
        program("calibrate", "r", "--laws", ",".join(LAWS), "--runs", "2", "--seed", "7", "--replicates", "0", "--out", "O",
                cwd=cls.path)  # fmt: skip
        cls.printed = json.loads((cls.path / "O/summary.json").read_text())
        cls.campaign = isolaw.calibrate(cls.files, LAWS, runs=2, seed=7, replicates=0, title="r", jobs=3)

    def test_numbers_are_those_of_the_program_bit_by_bit(self):
        self.assertTrue(self.campaign.complete)
        self.assertEqual(self.campaign.summary, self.printed)

    def test_blocks_and_cycles_may_be_numbers(self):
        how = {"runs": 1, "analysis": False}
        fits = [isolaw.calibrate(self.files[0], "bilinear", fit_cycles=cycles, **how) for cycles in ("2-3", (2, 3), range(2, 4))]
        self.assertEqual(fits[0], fits[1])
        self.assertEqual(fits[0], fits[2])
        with self.assertRaisesRegex(isolaw.Error, "numbers that follow one another"):
            isolaw.calibrate(self.files[0], "bilinear", fit_cycles=[1, 3], **how)
        with self.assertRaisesRegex(isolaw.Error, "^laws: there are none"):
            isolaw.calibrate(self.files[0], [], **how)
        with self.assertRaisesRegex(isolaw.Error, "^record: int; allowed: a Record or a file"):
            isolaw.calibrate([5], "bilinear", **how)

    def test_the_genetic_algorithm_too(self):
        how = {"method": "ga", "runs": 2, "population": 20, "generations": 5, "box": "published", "smooth": 3}
        campaign = isolaw.calibrate(self.files, "bouc-wen", analysis=False, title="r", set=["bouc-wen.A=1:2"], **how)
        program("calibrate", "r", "--laws", "bouc-wen", "--method", "ga", "--runs", "2", "--population", "20", "--generations", "5",
                "--box", "published", "--smooth", "3", "--set", "bouc-wen.A=1:2", "--analysis", "none", "--out", "G",
                cwd=self.path)  # fmt: skip
        self.assertEqual(campaign.summary, json.loads((self.path / "G/summary.json").read_text()))

    def test_compression_tests_are_those_of_the_program(self):
        loads = [500.0 * (1.0 - np.cos(2.0 * np.pi * i / 100.0)) for i in range(300)]
        lines = [f"{load / 1200.0:.6f},{load:.3f}" for load in loads]
        (self.path / "v.csv").write_text("\n".join(["Vertical displacement [mm],Vertical load [kN]", *lines]) + "\n")
        vertical = {"a": self.path / "v.csv", "b": {"file": self.path / "v.csv", "loads": "400:900"}}
        campaign = isolaw.calibrate(self.files, "bilinear", runs=1, analysis=False, vertical=vertical)
        campaign.write(self.path / "V")
        table = (self.path / "V/tables/vertical.csv").read_text()
        self.assertRegex(table, "\na,1[12][0-9][0-9]")
        self.assertRegex(table, "\nb,1[12][0-9][0-9].*,400,")
        self.assertTrue("hold the same compression test" in str(campaign.summary["warnings"]))
        self.assertAlmostEqual(campaign.properties("b")["vertical"]["K_v_kN_per_mm"], 1200.0, delta=100.0)
        properties = isolaw.properties(isolaw.read_record(self.files[0]), vertical=1100.0)
        self.assertEqual(properties["vertical"]["K_v_kN_per_mm"], 1100.0)
        absent = isolaw.properties(isolaw.read_record(self.files[0]), vertical="nothere.csv")
        self.assertIn("no such file", absent["vertical"]["refusal"])
        for wrong, said in (({"c": "v.csv"}, "'c': no such device"), ({"a": {"loads": "1:2"}}, "without a file"),
                            ({"a": {"file": "v.csv", "skew": 1}}, "unknown keyword 'skew'"), ({"a": -1.0}, "above 0")):  # fmt: skip
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.calibrate(self.files, "bilinear", vertical=wrong)

    def test_records_of_arrays_give_the_numbers_of_files(self):
        records = [isolaw.record(x, f, t, name=name) for name, (t, x, f) in (("a", arrays(20.0)), ("b", arrays(24.0)))]
        campaign = isolaw.calibrate(records, LAWS, runs=2, seed=7, analysis=False)
        for law, printed in zip(campaign.summary["laws"], self.printed["laws"]):
            self.assertEqual(law["objective"], printed["objective"])
            self.assertEqual(law["beta"], printed["beta"])

    def test_the_temperature_in_the_header_of_a_record_is_known(self):
        header = "Temperature: {}\ntime [s],displacement [mm],force [kN]"
        for name, temperature, strength_kN in (("cold.csv", "-10 C", 24.0), ("warm.csv", "20 C", 20.0)):
            write_csv(self.path / name, *arrays(strength_kN), header=header.format(temperature))
        records = [isolaw.read_record(self.path / name) for name in ("cold.csv", "warm.csv")]
        campaign = isolaw.calibrate(records, "bilinear", runs=1, analysis=False)
        self.assertIn("temperature -10 to 20", str(campaign.summary["warnings"]))

    def test_corrections_are_known_with_the_campaign(self):
        how = {"rules": "ntc-2018", "design": {"K_eff": 0.8, "damping": 16.0, "disp": 100.0}, "lot_size": 2}
        records = [isolaw.read_record(file, skew_ms=20.0) for file in self.files]
        warned = str(isolaw.calibrate(records, "bilinear", runs=1, analysis=False, **how).summary["warnings"])
        self.assertRegex(warned, "corrections by hand of a and b[. ]")
        one = isolaw.read_record(self.files[0], skew_ms=20.0)
        two = isolaw.same_device([one, isolaw.read_record(self.files[1])], name="both")
        warned = str(isolaw.calibrate([two], "bilinear", runs=1, analysis=False, **how).summary["warnings"])
        self.assertRegex(warned, "corrections by hand of both[. ]")

    def test_a_directory_is_written_and_loaded(self):
        out = self.path / "P"
        campaign = isolaw.calibrate(self.files, LAWS, runs=2, seed=7, replicates=0, title="r", out=out)
        self.assertEqual((out / "summary.json").read_bytes(), (self.path / "O/summary.json").read_bytes())
        for directory in (out, self.path / "O"):
            self.assertEqual(isolaw.load(directory).summary, campaign.summary)
        with self.assertRaisesRegex(isolaw.Error, "the campaign there differs: .*seed"):
            isolaw.calibrate(self.files, LAWS, runs=2, seed=8, replicates=0, out=out)
        campaign.write(self.path / "W")
        self.assertEqual((self.path / "W/summary.json").read_bytes(), (out / "summary.json").read_bytes())

    def test_arrays_of_a_campaign(self):
        for law in LAWS:
            runs = self.campaign.runs(law, "a")
            best = runs["objective"].argmin()
            self.assertEqual(runs["parameters"][best].tolist(), list(self.campaign.parameters(law, "a").values()))
            seen = self.campaign.fit_record("a")
            force = self.campaign.force(law, "a")
            self.assertEqual(len(force), len(seen["disp_mm"]))
            self.assertTrue(np.shares_memory(force, self.campaign.force(law, "a")))
            model = isolaw.Model(law, self.campaign.record("a"))
            np.testing.assert_array_equal(model.force(self.campaign.parameters(law, "a")), force)
            self.assertEqual(model.objective(self.campaign.parameters(law, "a")), runs["objective"].min())
            of_lot = next(one["lot"] for one in self.printed["laws"] if one["id"] == law)
            self.assertEqual(list(self.campaign.parameters(law, "lot").values()), list(of_lot["parameters"].values())
                             if isinstance(of_lot["parameters"], dict) else of_lot["parameters"])  # fmt: skip
        self.assertEqual(self.campaign.devices, ["a", "b"])
        self.assertEqual(self.campaign.laws, LAWS)
        for kind, accuracy in (("runs", "mean"), ("converged", None), ("loo", None)):
            rows = self.campaign.front(kind)
            self.assertEqual([row["law"] for row in rows], LAWS)
            self.assertTrue(any(row["on_front"] for row in rows))
            if accuracy:
                self.assertEqual(rows[0]["accuracy"], self.printed["laws"][0]["objective"][accuracy])

    def test_a_model_has_the_weights_of_a_campaign(self):
        t, x, _ = arrays()
        x[:201] *= 0.2  # a small cycle before two large ones
        force = isolaw.force("bilinear", {"K1": 2.5, "K2": 0.5, "xy": 10.0}, x) + 1e-4 * x**2
        record = isolaw.record(x, force, t, name="a")
        campaign = isolaw.calibrate(record, "bilinear", runs=1, analysis=False, weights="swing")
        parameters = campaign.parameters("bilinear", "a")
        weighed = isolaw.objective("bilinear", parameters, record, weights="swing")
        self.assertEqual(weighed, campaign.runs("bilinear", "a")["objective"].min())
        by_time = isolaw.objective("bilinear", parameters, record, weights="time")
        self.assertGreater(abs(weighed - by_time), 0.01 * by_time)
        self.assertAlmostEqual(by_time, campaign.summary["laws"][0]["devices"][0]["objective_by_time"], places=12)

    def test_what_is_not_there_is_said(self):
        for wrong in (lambda: self.campaign.force("abe", "a"), lambda: self.campaign.runs("bilinear", "c"),
                      lambda: self.campaign.record("c"), lambda: self.campaign.parameters("bilinear", "c"),
                      lambda: isolaw.load(self.path / "nowhere"), lambda: self.campaign.front("best")):  # fmt: skip
            with self.assertRaises(isolaw.Error):
                wrong()

    def test_wrong_settings_are_errors(self):
        record = isolaw.read_record(self.files[0])
        for how, said in (
            ({"laws": "abx"}, "no such law"),
            ({"runs": 0}, "runs"),
            ({"method": "newton"}, "newton"),
            ({"population": 20, "method": "best"}, "population: belongs to method ga, but the method is best"),
            ({"fit_blocks": "two"}, "^fit_blocks: 'two'"),
            ({"score_blocks": "2"}, "^score_blocks: '2'; allowed: together with"),
            ({"rules": "nowhere.toml"}, "nowhere.toml"),
            ({"design": {"K_eff": "soft"}}, "^design: design.K_eff is not a number"),
            ({"lot_size": 0}, "^lot_size: 0"),
            ({"set": "bilinear.K9=1"}, "K9"),
            ({"jobs": -1}, "jobs"),
            ({"samples_per_cycle": 3}, "samples"),
        ):
            with self.assertRaisesRegex(isolaw.Error, said):
                isolaw.calibrate(record, **({"laws": "bilinear"} | how))
        with self.assertRaisesRegex(isolaw.Error, "is there twice"):
            isolaw.calibrate([record, record], "bilinear")
        with self.assertRaisesRegex(isolaw.Error, "a lot file; allowed: records"):
            isolaw.calibrate("lot.toml")
        with self.assertRaisesRegex(isolaw.Error, "there are none"):
            isolaw.calibrate([], "bilinear")

    # Valid values of the settings that are neither numbers nor flags and have no list of allowed words.
    TEXTS = json.loads((pathlib.Path(os.environ["ISOLAW_SOURCE_DIR"]) / "tests/setting_samples.json").read_text())

    def another(self, name, setting):
        """Returns a valid value of the setting that is not its default."""
        if setting["words"]:
            return next(word for word in setting["words"] if word != setting["default"])
        if isinstance(setting["default"], bool):
            return not setting["default"]
        if setting["limits"]:
            least = setting["limits"][0]
            return 0.25 if isinstance(setting["default"], float) else int(least) + 2
        return self.TEXTS[setting["option"]]

    def test_every_setting_is_a_keyword_that_is_stored_and_refused_by_its_name(self):
        t, x, f = arrays()
        t, x, f = np.append(t, t[-1] + t[1:]), np.append(x, 0.6 * x[1:]), np.append(f, 0.7 * f[1:])
        given = {name: self.another(name, setting) for name, setting in isolaw.settings().items()}
        summary = isolaw.calibrate(isolaw.record(x, f, t, name="one"), **given).summary
        self.assertEqual(summary["seed"], given["seed"])
        for name, setting in isolaw.settings().items():
            key = next((k for k in summary["settings"] if k.replace("-", "_") == name), None)
            self.assertEqual(summary["settings"][key] if key else summary["seed"], given[name], name)
            wrong = ["?"] + ([setting["limits"][0] - 1] if setting["limits"] else [])
            for value in wrong:
                with self.assertRaisesRegex(isolaw.Error, f"^{name}[: ]"):
                    isolaw.calibrate(self.files[0], **{name: value})
        with self.assertRaisesRegex(TypeError, "populaton"):
            isolaw.calibrate(self.files[0], populaton=20)

    def test_tests_are_held_to_rules_as_by_the_program(self):
        how = {"runs": 1, "analysis": False, "title": "r"}
        design = {"K_eff": 0.7, "damping": 15}
        campaign = isolaw.calibrate(self.files, "bilinear", rules="ntc-2018", design=design, lot_size=28, **how)
        program("calibrate", "r", "--laws", "bilinear", "--runs", "1", "--analysis", "none", "--rules", "ntc-2018",
                "--design", "K_eff=0.7,damping=15", "--lot-size", "28", "--out", "R", cwd=self.path)  # fmt: skip
        campaign.write(self.path / "V")
        for table in ("tests.csv", "lot.csv", "lambda.csv"):
            self.assertEqual((self.path / "V/tables" / table).read_bytes(), (self.path / "R/tables" / table).read_bytes())

    def test_progress_comes_in_the_callers_thread_and_its_exception_ends_the_search(self):
        seen = []

        def note(done, total, analysis, best):
            seen.append((done, total, analysis, dict(best), threading.get_ident()))

        isolaw.calibrate(self.files, "menegotto-pinto", runs=4, analysis=False, progress=note, jobs=2)
        self.assertGreater(len(seen), 0)
        self.assertEqual({one[4] for one in seen}, {threading.get_ident()})
        self.assertEqual([one[0] for one in seen], sorted(one[0] for one in seen))
        self.assertTrue(all(one[1] == 8 and "menegotto-pinto" in one[3] for one in seen))

        shares = []

        def of_all_work(done, total, analysis, best, *, share, left_s):
            shares.append((share, left_s))

        isolaw.calibrate(self.files, "bilinear", runs=2, replicates=0, progress=of_all_work, jobs=2)
        self.assertEqual(shares[-1], (1.0, 0.0))
        isolaw.calibrate(self.files, "bilinear", runs=1, analysis=False, progress=lambda *told, **more: shares.append(more))
        self.assertEqual(shares[-1], {"share": 1.0, "left_s": 0.0})

        class Stopped(Exception):
            pass

        def refuse(*_):
            raise Stopped

        with self.assertRaises(Stopped):
            isolaw.calibrate(self.files, "all", runs=50, progress=refuse, jobs=2)


if __name__ == "__main__":
    unittest.main()
