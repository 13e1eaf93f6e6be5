"""Tests how records, campaigns, fits and models are shown, and what SciPy's least_squares gets."""

import contextlib
import copy
import io
import sys
import unittest
from unittest import mock
from xml.etree import ElementTree

import numpy as np

import isolaw
from devices import InFolder, arrays, files_in, needs


def parsed(html):
    return ElementTree.fromstring(f"<div>{html}</div>")


class Shown(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.files = files_in(cls.path / "r")
        cls.campaign = isolaw.calibrate(cls.files, ["bilinear", "bouc-wen"], runs=2, seed=7, analysis=False)

    def test_a_record_says_what_it_holds(self):
        t, x, f = arrays()
        record = isolaw.record(x, f, t, name="<a>")
        self.assertEqual(
            repr(record),
            "<isolaw.Record <a>: samples 601, duration, s 6, displacement, mm -100 to 100, force, kN -70 to 70>",
        )
        page = parsed(record._repr_html_())
        self.assertEqual(page.find("b").text, "<a>")
        self.assertEqual(len(page.find("svg/polyline").get("points").split()), 601)
        motion = isolaw.motion(x, t)
        self.assertIn("Time, s", motion._repr_html_())
        self.assertNotIn("force", repr(motion))

    def test_fits_of_a_law_and_a_model_show_themselves(self):
        fits = self.campaign["bilinear"]
        cells = [cell.text for cell in parsed(fits._repr_html_()).iter("td")]
        self.assertEqual(cells, [text for device, fit in fits.items() for text in (device, f"{fit.objective:.4g}")])
        model = isolaw.Model("vaiana", self.campaign.record("a"))
        cells = [cell.text for cell in parsed(model._repr_html_()).iter("td")]
        self.assertEqual(len(cells), 2 * len(model.parameter_names))
        (lower, *_), (upper, *_) = model.bounds
        self.assertEqual(cells[:2], ["Kb+, N/m", f"{lower:.4g} to {upper:.4g}"])

    def test_copies_are_the_thing_itself(self):
        for thing in (self.campaign, self.campaign.record("a"), isolaw.Model("bilinear", self.campaign.record("a"))):
            self.assertIs(copy.deepcopy({"one": thing})["one"], thing)
            self.assertIs(copy.copy(thing), thing)

    def test_a_campaign_holds_fits_by_law_and_device(self):
        campaign = self.campaign
        self.assertEqual(list(campaign), ["bilinear", "bouc-wen"])
        self.assertEqual(list(campaign["bilinear"]), ["a", "b"])
        fit = campaign["bilinear"]["b"]
        self.assertEqual(fit.parameters, campaign.parameters("bilinear", "b"))
        self.assertEqual(fit.objective, fit.runs["objective"].min())
        np.testing.assert_array_equal(fit.force_kN, campaign.force("bilinear", "b"))
        with self.assertRaisesRegex(KeyError, "abe; allowed: bilinear, bouc-wen"):
            campaign["abe"]
        with self.assertRaisesRegex(KeyError, "c; allowed: a, b"):
            campaign["bilinear"]["c"]
        self.assertEqual(campaign.findings, campaign.summary["warnings"])
        self.assertEqual(campaign, campaign)
        self.assertNotEqual(campaign, isolaw.calibrate(self.files[0], "bilinear", runs=1, analysis=False))
        self.assertIn("<isolaw.Campaign of 2 devices; least objectives: bilinear ", repr(campaign))
        self.assertRegex(repr(fit), "^<isolaw.Fit of bilinear to b: objective [0-9.e-]+; K1 = ")
        self.assertEqual(len(parsed(campaign._repr_html_()).findall("table/tr")), 2)
        self.assertEqual(len(parsed(fit._repr_html_()).findall("svg/polyline")), 2)

    @needs("pandas")
    def test_tables_are_data_frames(self):
        table = self.campaign["bilinear"].to_frame()
        self.assertEqual(list(table.index), ["a", "b"])
        self.assertEqual(table.loc["a", "K1"], self.campaign.parameters("bilinear", "a")["K1"])
        laws = self.campaign.to_frame()
        self.assertEqual(laws.loc["bouc-wen", "mean"], self.campaign.summary["laws"][1]["objective"]["mean"])
        record = self.campaign.record("a").to_frame()
        self.assertEqual(list(record.columns), ["time_s", "disp_mm", "force_kN"])

    @needs("matplotlib")
    def test_plots_have_axes_with_units(self):
        import matplotlib

        matplotlib.use("svg")
        from matplotlib import pyplot

        own = pyplot.figure().gca()
        self.assertIs(self.campaign.plot_loop("bilinear", "a", own), own)
        self.assertEqual((own.get_xlabel(), own.get_ylabel(), len(own.lines)), ("Displacement, mm", "Force, kN", 2))
        np.testing.assert_array_equal(own.lines[1].get_ydata(), self.campaign.force("bilinear", "a"))
        pyplot.figure()
        self.assertEqual(len(self.campaign.record("a").plot().lines), 1)
        pyplot.figure()
        front = self.campaign.plot_front()
        self.assertEqual({text.get_text() for text in front.texts}, {"bilinear", "bouc-wen"})
        pyplot.close("all")

    def test_what_is_not_installed_is_named(self):
        with mock.patch.dict(sys.modules, {"pandas": None}):
            with self.assertRaisesRegex(isolaw.Error, "needs pandas.*try: pip install pandas"):
                self.campaign.to_frame()

    def test_progress_is_a_line_without_tqdm(self):
        shown = io.StringIO()
        with mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}), contextlib.redirect_stderr(shown):
            isolaw.calibrate(self.files, "bilinear", runs=1, analysis=False, progress=True)
        self.assertTrue(shown.getvalue().endswith("\r100 %\n"), shown.getvalue())


class Models(unittest.TestCase):
    def setUp(self):
        t, x, f = arrays()
        self.record = isolaw.record(x, f, t)

    def test_residuals_are_weighted_deviations(self):
        model = isolaw.Model("bilinear", self.record)
        at = {"K1": 3.0, "K2": 0.4, "xy": 8.0}
        self.assertEqual(model(at), model.objective(at))
        deviation = model.force(at) - model.force_kN
        weights = np.square(model.residual(at)[1:] / deviation[1:] * model.force_kN.std())  # the first deviation is 0
        self.assertAlmostEqual(weights.sum(), 1.0, delta=0.01)
        one_block = isolaw.Model("bilinear", self.record, fit_cycles="1").residual(at)
        self.assertTrue(np.any(one_block[1:190] != 0.0) and np.all(one_block[210:] == 0.0))

    def test_fixed_parameters_have_their_values(self):
        model = isolaw.Model("bwbn", self.record)
        lower, upper = model.bounds
        self.assertEqual(lower.shape, (len(model.free_names),))
        self.assertTrue(np.all(lower < upper))
        self.assertEqual(set(model.parameter_names) - set(model.free_names), {"A", "q", "lambda"})
        middle = 0.5 * (lower + upper)
        box = isolaw.box("bwbn", self.record)
        whole = dict(zip(model.free_names, middle)) | {k: v["value"] for k, v in box.items() if not v["free"]}
        np.testing.assert_array_equal(model.residual(middle), model.residual(whole))
        self.assertEqual(model(middle), model(whole))

    @needs("scipy")
    def test_least_squares_finds_the_device(self):
        from scipy.optimize import least_squares

        model = isolaw.Model("bilinear", self.record)
        lower, upper = model.bounds
        found = least_squares(model.residual, 0.5 * (lower + upper), bounds=model.bounds, x_scale=upper - lower)
        K1, K2, xy = found.x
        np.testing.assert_allclose([K2, (K1 - K2) * xy], [0.5, 20.0], rtol=0.01)


if __name__ == "__main__":
    unittest.main()
