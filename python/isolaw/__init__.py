"""Hysteretic laws of seismic isolators, fitted to cyclic tests: the library behind the program ``isolaw``, for NumPy.

>>> import isolaw
>>> record = isolaw.read_record("device-01.csv")
>>> campaign = isolaw.calibrate([record], laws=["bilinear", "bouc-wen"])
>>> campaign.summary["laws"][0]["objective"]["best"]

Units are kN, mm and s; a law's parameters have the law's own units (``isolaw.laws()``). Wrong input raises
``isolaw.Error``. Arrays of records and results are read-only views of the library's memory, without a copy. No
function prints, unless ``progress=True`` asks for it. Long calls release the interpreter's lock; Ctrl-C interrupts
``calibrate``. Records, campaigns and fits show themselves in notebooks; their plots need Matplotlib, tables pandas.
"""

import contextlib as _contextlib
import difflib as _difflib
import functools as _functools
import inspect as _inspect
import json as _json
import operator as _operator
import os as _os
import warnings as _warnings
from collections.abc import Mapping as _Mapping

import numpy as _np

from . import _core, _show
from ._error import Error
from ._core import Record, __version__

__all__ = [
    "Building",
    "Campaign",
    "Conditions",
    "Error",
    "Export",
    "Fit",
    "LawFits",
    "Model",
    "Record",
    "Test",
    "__version__",
    "box",
    "building",
    "calibrate",
    "check",
    "conditions",
    "example",
    "force",
    "inspect",
    "laws",
    "load",
    "merge",
    "motion",
    "objective",
    "objectives",
    "properties",
    "read_motion",
    "read_record",
    "record",
    "rules",
    "same_device",
    "settings",
]


def _record_rows(self):
    rows = [("samples", len(self))]
    if self.time_s is not None:
        rows.append(("duration, s", float(self.time_s[-1] - self.time_s[0])))
    channels = (("displacement, mm", self.disp_mm), ("force, kN", self.force_kN), ("vertical load, kN", self.load_kN))
    return rows + [
        (title, f"{values.min():.4g} to {values.max():.4g}") for title, values in channels if values is not None
    ]


def _record_repr(self):
    facts = ", ".join(f"{name} {value:.6g}" if isinstance(value, float) else f"{name} {value}" for name, value in _record_rows(self))
    return f"<isolaw.Record {self.name}: {facts}>"


def _record_html(self):
    if self.force_kN is not None:
        picture = _show.loop_picture(self.disp_mm, self.force_kN)
    else:
        time_s = _np.arange(len(self)) if self.time_s is None else self.time_s
        picture = _show.time_picture(time_s, self.disp_mm)
    return _show.page(self.name, _record_rows(self), picture)


def _record_to_frame(self):
    """The samples as a pandas DataFrame: columns time_s, disp_mm, force_kN and load_kN, as far as the record has them."""
    channels = {name: getattr(self, name) for name in ("time_s", "disp_mm", "force_kN", "load_kN")}
    return _show.frame({name: values for name, values in channels.items() if values is not None})


def _record_plot(self, ax=None):
    """Draws the loop, or a motion over time, with Matplotlib. ax: axes to draw into. Returns the axes."""
    if self.force_kN is not None:
        return _show.draw_loop(ax, self.disp_mm, [("", self.force_kN)])
    ax = _show.axes(ax)
    ax.plot(_np.arange(len(self)) if self.time_s is None else self.time_s, self.disp_mm, linewidth=1.0)
    ax.set_xlabel("Sample" if self.time_s is None else "Time, s")
    ax.set_ylabel("Displacement, mm")
    return ax


def _record_eq(self, other):
    if not isinstance(other, Record):
        return NotImplemented
    return self is other or self.__getstate__() == other.__getstate__()


def _record_hash(self):
    return hash((self.name, self.file, len(self)))


Record.__module__ = "isolaw"
Record.__eq__, Record.__hash__ = _record_eq, _record_hash
Record.__repr__, Record._repr_html_ = _record_repr, _record_html
Record.plot, Record.to_frame = _record_plot, _record_to_frame


class _Unchanging:
    """Base of classes whose objects never change, so that copy.copy and copy.deepcopy return the object itself."""

    def __copy__(self):
        return self

    def __deepcopy__(self, memo):
        return self


Record.__copy__, Record.__deepcopy__ = _Unchanging.__copy__, _Unchanging.__deepcopy__

_OPTIONS = _json.loads(_core.options_json())


def _with_keywords(options, in_place=False):
    """Decorator: replaces the ``**`` parameter in a function's signature by the keywords of ``options``, with defaults.

    in_place: the keywords replace values that another argument holds, for example a building file. Every default is
    then None, which leaves the value as it is.
    """

    def default(option):
        if in_place:
            return None
        value, limits = option["default"], option["limits"]
        left_to_others = limits is not None and value == 0 and value < limits[0]
        return None if left_to_others else tuple(value) if isinstance(value, list) else value

    def decorate(function):
        own = _inspect.signature(function)
        kept = [p for p in own.parameters.values() if p.kind is not p.VAR_KEYWORD]
        added = [
            _inspect.Parameter(name, _inspect.Parameter.KEYWORD_ONLY, default=default(option))
            for name, option in options.items()
            if name not in own.parameters
        ]
        signature = own.replace(parameters=kept + added)

        @_functools.wraps(function)
        def checked(*args, **kwargs):
            for keyword in kwargs.keys() - signature.parameters.keys():
                near = _difflib.get_close_matches(keyword, signature.parameters, n=1)
                raise TypeError(
                    f"{function.__qualname__}() has no keyword {keyword!r}" + (f"; try {near[0]!r}" if near else "")
                )
            signature.bind(*args, **kwargs)
            return function(*args, **kwargs)

        checked.__signature__ = signature
        return checked

    return decorate


_EXPORT_OPTIONS = {
    name: option
    for name, option in (_OPTIONS["acceptance"] | _OPTIONS["motion"] | _OPTIONS["model"]).items()
    if name not in ("report_units", "letterhead")  # these keywords are only for reports
}


def _settings(*names):
    return {name: _OPTIONS["settings"][name] for name in names}


def _motion_reading():
    return {name: option for name, option in _OPTIONS["reading"].items() if not option["of_test"]}


def settings():
    """The settings of calibrate: a dict by keyword.

    Each value is a dict of option (of the command line), help, default, words (the texts that are allowed), limits
    (least and most of a number, or None), and method (the only method that has the setting, or None).
    """
    return {
        name: {key: value for key, value in one.items() if key != "stored_only"}
        for name, one in _OPTIONS["settings"].items()
        if not one["stored_only"]
    }


@_with_keywords(_OPTIONS["reading"])
def read_record(path, *, name=None, **reading):
    """Reads a test record from delimited text, Excel, MATLAB or JSON, and recognises format, columns and units.

    path: the file. name: the device's name; by default the file's name without its ending.
    columns, units: columns and units of the channels, if the file does not state them, as a dict or as the text of the
    command-line option: ``columns={"disp": 2, "force": "F"}``, ``units="disp=cm,force=tonf"``. Channels are time, disp,
    force, load and cycle. ``columns={"force": "loadcell.csv:F"}`` takes the force from another file. channel_scale: a
    dict by channel; it gives the size, in the channel's unit, of the value 1 in the file. missing: what to do with rows
    in which a channel has no value, ``"leave-out"`` or ``"interpolate"``.
    dt: sampling interval in s of a file without time. sheet, test: which sheet or test to read if the file has several.
    rows: ``"101:700"``, rows of numbers counted from 1. from_s, to_s: the part to read, in seconds of the file's own
    time. footer: ``"skip"`` ignores text below the rows. thousands: the mark that groups digits. date_order: ``"dmy"``
    or ``"mdy"``. half_cycles: True counts each swing that belongs to no full cycle as a half cycle.
    flip_force, repair, skew_ms, rig_friction_kN, rig_friction_coefficient, moving_mass_kg, force_factor: corrections,
    like the options of ``isolaw inspect``.

    Returns a Record; ``record.recognised`` says what was recognised and why. Raises one Error with all problems.
    """
    return _core.read(_os.fspath(path), False, name, reading)


@_with_keywords(_motion_reading())
def read_motion(path, *, name=None, **reading):
    """Reads a displacement history, cyclic or seismic, from a file. The file needs no force.

    The keywords are those of read_record, without its corrections. Returns a Record whose ``force_kN`` is None. Raises
    Error as read_record does, and for a record of acceleration.
    """
    return _core.read(_os.fspath(path), True, name, reading)


def record(disp_mm, force_kN, time_s=None, load_kN=None, *, name="record"):
    """Makes a Record from arrays, which are checked like the values of a file.

    disp_mm, force_kN, time_s, load_kN: shape (samples,), in mm, kN, s and kN; time and load may be None. Raises Error
    for values that are not finite, time that does not increase, displacement and force in the wrong order, and so on.
    """
    return _core.record(name, disp_mm, force_kN, time_s, load_kN)


def same_device(records, *, name=None):
    """Makes one Record of several tests of a device, which share the parameters of each law.

    records: Records of the tests, or their files; their names must differ. name: the device's name; by default it is made of the tests'
    names. A law starts at rest in each test, and its objective is the mean over the tests. In the arrays of the result
    the tests follow one another. Raises Error if only some of the tests have time, or if two have the same name.
    """
    return _core.same_device([_a_record(one) for one in records], name)


def _vertical(test):
    if isinstance(test, _os.PathLike):
        return _os.fspath(test)
    return {k: _os.fspath(v) if k == "file" else v for k, v in test.items()} if isinstance(test, dict) else test


def motion(disp_mm, time_s=None, *, name="motion"):
    """Makes a displacement history from arrays of shape (samples,), in mm and s: a Record whose ``force_kN`` is None.

    Raises Error as record does.
    """
    return _core.record(name, disp_mm, None, time_s, None)


def properties(record, *, vertical=None):
    """Computes the properties of a test, cycle by cycle, from raw values, as ``isolaw inspect --json`` does.

    record: a Record or its file. Returns a dict. Its ``blocks`` are runs of cycles of one amplitude and frequency. Each of a block's ``cycles``
    has K_eff in kN/mm, damping in percent of critical, energy in kN mm and more (docs/inspection-json.md; formulas and
    their sources are in docs/properties.md). vertical: the device's compression test, as in calibrate; the result's
    ``vertical`` has its stiffness or the reason why there is none. Raises Error for a record that cannot be used, such
    as a motion without force.
    """
    record = _a_record(record)
    found = inspect(record, vertical=None if vertical is None else {record.name: vertical})
    if found["status"] == "refused":
        raise Error(found["message"])
    return found


def laws():
    """The catalogue of laws: a dict by id.

    Each value is a dict with, among others, name, title, source, units (force, length, time), rate_independent,
    formula, note (how the source was read), together (conditions between several parameters) and parameters. Each
    parameter has name, unit, meaning, physical (its limits), published (its interval in the search box of Cucuzza et
    al. 2025) and fixed (the value that it has unless ``set`` frees it). None in place of a bound means that there is no
    bound.
    """
    return {law["id"]: law for law in _json.loads(_core.catalogue_json())}


def box(law, record, *, kind="auto", method="best"):
    """The search box of a law's parameters on a record: a dict by parameter, in the law's order.

    record: a Record with force, or its file. kind: "auto" computes the box from the sizes in the record; "published"
    takes Table 4 of Cucuzza et al. 2025 for the laws that it lists. method: as in calibrate. Each value is a dict of
    unit, free, value (None if free), lower, upper and scale; numbers have the law's units. Raises Error for wrong input.
    """
    return _core.box(law, _a_record(record), {"box": kind, "method": method})


def _by_name(parameters):
    """Returns a dict if the parameters have names, as in a pandas Series or lmfit's Parameters, else what was given."""
    return dict(parameters) if hasattr(parameters, "keys") else parameters


@_with_keywords(_settings("integration", "turning_points"))
def force(law, parameters, motion, *, refinement=1, dead_band_mm=0.0, out=None, **how):
    """Force of a law under a displacement history, in kN: a float64 array of shape (samples,).

    law: an id. parameters: a dict by name, or the values in the law's order; in the law's units.
    motion: a Record, whose force is ignored, or an array of displacements in mm for a law that needs no time.
    integration: "converged", or "paper" (one Runge-Kutta step per sample). turning_points: "sampled" or "interpolated".
    refinement: integration steps per sample. dead_band_mm: reversals of motion that are smaller have no effect on the
    law. out: a contiguous float64 array that receives the forces.

    A fit uses a dead band and a refinement of its own, so Campaign.force() computes the force of a fitted law. A value is not finite if the law gives no force. Raises Error for an unknown law, for parameters that are
    missing, unknown or outside their physical limits (all in one message), and for a rate-dependent law without time.
    """
    return _core.force(law, _by_name(parameters), _a_motion(motion), how, refinement, dead_band_mm, out)


def _a_motion(motion):
    """Makes a motion of displacements, which need no time."""
    return motion if isinstance(motion, Record) else _core.record("motion", motion, None, None, None)


class Model(_Unchanging):
    """A law on a record, with the same objective as in calibrate, for your own optimisers and studies.

    law: an id. record: a Record with force, or its file. The record is cleaned as in calibrate: thinned to
    ``samples_per_cycle`` (None: not at all), averaged over ``smooth`` samples, and centred if ``center``. The objective
    is taken over ``fit_blocks`` and ``fit_cycles``, and ``weights`` decides how much a sample counts in it.
    integration, turning_points, refinement: as in force. Raises Error for wrong input, as calibrate does.
    """

    @_with_keywords(
        _settings("integration", "turning_points", "samples_per_cycle", "smooth", "center", "dead_band", "weights")
        | _settings("fit_blocks", "fit_cycles")
    )
    def __init__(self, law, record, *, refinement=1, **how):
        record = _a_record(record)
        self._core = _core.Model(law, record, _all_samples(how), refinement)
        stated = _inspect.signature(type(self).__init__).parameters.values()
        defaults = {one.name: one.default for one in stated if one.kind is one.KEYWORD_ONLY}
        self._given = law, record, defaults | {"refinement": refinement} | _numbered(how)
        self._law = law
        self._box = box(law, record)
        self._names = list(self._box)
        self._is_free = _np.array([entry["free"] for entry in self._box.values()])

    def __repr__(self):
        return f"<isolaw.Model of {self._law}: parameters {', '.join(self._names)}; {len(self.disp_mm)} samples>"

    def _repr_html_(self):
        rows = [
            (f"{name}, {entry['unit']}", f"{entry['lower']:.4g} to {entry['upper']:.4g}" if entry["free"] else entry["value"])
            for name, entry in self._box.items()
        ]
        return _show.page(f"{self._law}: limits of its parameters", rows, _show.loop_picture(self.disp_mm, self.force_kN))

    def __reduce__(self):
        law, record, how = self._given
        return _functools.partial(Model, **how), (law, record)

    def __eq__(self, other):
        return isinstance(other, Model) and self._given == other._given

    def __hash__(self):
        return hash(self._given[:2])

    def _whole(self, parameters):
        """Adds the values of the fixed parameters if only the free ones are given."""
        parameters = _by_name(parameters)
        if self._is_free.all() or isinstance(parameters, _Mapping) or _np.shape(parameters) != (self._is_free.sum(),):
            return parameters
        whole = _np.array([_np.nan if entry["free"] else entry["value"] for entry in self._box.values()])
        whole[self._is_free] = parameters
        return whole

    @property
    def law(self):
        """Id of the law."""
        return self._law

    @property
    def parameter_names(self):
        """Names of the parameters in the law's order, which is also the order of a population's columns."""
        return list(self._names)

    @property
    def free_names(self):
        """Names of the parameters that an optimiser may change, in the law's order; the others have usual values.

        objective, residual and force also take values of the free parameters alone.
        """
        return [name for name, is_free in zip(self._names, self._is_free) if is_free]

    @property
    def bounds(self):
        """Lower and upper limits of the free parameters, as SciPy takes them: two arrays of shape (free,).

        They are those of the search box, as box() gives it.
        """
        free = [entry for entry in self._box.values() if entry["free"]]
        return _np.array([entry["lower"] for entry in free]), _np.array([entry["upper"] for entry in free])

    @property
    def time_s(self):
        """Times of the cleaned record in s (sample numbers without time), shape (samples,): a read-only view."""
        return self._core.time_s

    @property
    def disp_mm(self):
        """Displacements of the cleaned record in mm, shape (samples,): a read-only view."""
        return self._core.disp_mm

    @property
    def force_kN(self):
        """Measured forces of the cleaned record in kN, shape (samples,): a read-only view."""
        return self._core.force_kN

    def objective(self, parameters):
        """The objective of one set of parameters (dict or values in order), Eq. (27) of Cucuzza et al. 2025; no unit.

        Mean over time, or with ``weights``, of |measured - computed force|, divided by the standard deviation of the
        measured force; infinity if a force is not finite. Computed by scalar code, like every number of a report.
        Raises Error as force does, except for conditions between parameters, which an optimiser may leave for a while.
        """
        return self._core.objective(self._whole(parameters))

    __call__ = objective

    def residual(self, parameters):
        """Deviations for least squares, shape (samples,): for SciPy's least_squares, lmfit and others; no unit.

        Computed - measured force, divided by the standard deviation of the measured force and times the square root of
        the sample's weight. The sum of the squares is the weighted mean of the squared deviations. Samples that the
        objective does not count are 0; others are not finite if the law gives no force. Raises Error as force does.
        """
        return self._core.residual(self._whole(parameters))

    def objectives(self, population, out=None):
        """Objectives of many candidates at once, from the vector kernels: a float64 array of shape (candidates,).

        population: float64 of shape (candidates, parameters) in the law's order and units, or a DataFrame with a column
        for each parameter; a contiguous array is read without a copy. No limits are checked. out: a contiguous float64
        array that receives the values. The values agree with objective() to about 1e-11; a candidate without a finite
        force gets infinity. Raises Error for other shapes.
        """
        if hasattr(population, "columns"):  # a pandas DataFrame, whose columns may be in any order
            if sorted(map(str, population.columns)) != sorted(self._names):
                found, allowed = ", ".join(map(str, population.columns)), ", ".join(self._names)
                raise Error(f"population: the columns {found}; allowed: {allowed}")
            population = population[self._names].to_numpy(float)
        return self._core.objectives(population, out)

    def force(self, parameters, out=None):
        """Computed force in kN at the samples of the cleaned record, shape (samples,). Raises Error as force does."""
        return self._core.force(self._whole(parameters), out)


def objective(law, parameters, record, **how):
    """Objective of one set of parameters on a record: Model(law, record, **how).objective(parameters)."""
    return Model(law, record, **how).objective(parameters)


def objectives(law, population, record, **how):
    """Objectives of many candidates on a record: Model(law, record, **how).objectives(population)."""
    return Model(law, record, **how).objectives(population)


class Fit:
    """A law fitted to a device: ``campaign["bouc-wen"]["D06"]``.

    ``results`` is the device's entry in summary.json; the properties below are the ones that most people need.
    """

    def __init__(self, campaign, law, results):
        self._campaign = campaign
        self._law = law
        self._results = results

    def __eq__(self, other):
        return isinstance(other, Fit) and (self.law, self.results) == (other.law, other.results)

    def __hash__(self):
        return hash((self.law, self.device))

    def __repr__(self):
        head = f"<isolaw.Fit of {self._law} to {self.device}: "
        if self.objective is None:
            return head + self._results["message"] + ">"
        values = ", ".join(f"{name} = {value:.4g}" for name, value in self.parameters.items())
        return head + f"objective {self.objective:.4g}; {values}>"

    def _repr_html_(self):
        rows = [("objective", self.objective), *self.parameters.items()]
        record = self._campaign.fit_record(self.device)
        picture = _show.loop_picture(record["disp_mm"], record["force_kN"], self.force_kN)
        return _show.page(f"{self._law} fitted to {self.device}: measured, and computed in red", rows, picture)

    @property
    def law(self):
        """Id of the law."""
        return self._law

    @property
    def device(self):
        """Name of the device."""
        return self._results["name"]

    @property
    def results(self):
        """The dict of the fit in summary.json (docs/summary-json.md)."""
        return self._results

    @property
    def objective(self):
        """The least objective over the runs, Eq. (27) of Cucuzza et al. 2025; no unit. None if no run has one."""
        return self._results["objective"]["best"]

    @property
    def parameters(self):
        """Parameters of the best run: a dict in the law's units. Raises Error if there are none."""
        return self._campaign.parameters(self._law, self.device)

    @property
    def statistics(self):
        """All that is known of each parameter: a dict by name of dicts, as in summary.json.

        Each has unit, best, mean and std over the runs and, with analysis, identifiability, linear_interval,
        bootstrap_interval and more.
        """
        return self._results["parameters"]

    @property
    def intervals(self):
        """Confidence intervals of the parameters, in the law's units: a dict by name of (lower, upper).

        They come from the bootstrap, or without one from linearisation; their level is ``results["intervals"]["level"]``.
        None stands for a parameter that has no interval: it is fixed, or there is no analysis.
        """

        def interval(one):
            found = (one.get(kind) or (None, None) for kind in ("bootstrap_interval", "linear_interval"))
            return next((tuple(ends) for ends in found if None not in ends), None)

        return {name: interval(one) for name, one in self.statistics.items()}

    @property
    def runs(self):
        """Every run, as Campaign.runs returns it."""
        return self._campaign.runs(self._law, self.device)

    def to_frame(self):
        """A pandas DataFrame with a row for each parameter: unit, best, mean, std, lower and upper end of its interval,
        and identifiability."""
        rows = []
        for name, one in self.statistics.items():
            lower, upper = self.intervals[name] or (None, None)
            facts = {key: one.get(key) for key in ("unit", "best", "mean", "std")}
            rows.append(
                {"parameter": name, **facts, "lower": lower, "upper": upper, "identifiability": one.get("identifiability")}
            )
        return _show.frame(rows, index="parameter")

    @property
    def force_kN(self):
        """Force in kN of the best run at the samples of the cleaned record, shape (samples,): a read-only view."""
        return self._campaign.force(self._law, self.device)

    def force(self, motion, *, anyway=False):
        """Force in kN of the best run under another motion, as Campaign.force() computes it."""
        return self._campaign._force_under(self._law, self.device, motion, anyway)

    def plot(self, ax=None):
        """Draws the measured and the computed loop with Matplotlib. ax: axes to draw into. Returns the axes.

        Raises Error if the law has no fit.
        """
        self._campaign.parameters(self._law, self.device)  # raises the Error
        record = self._campaign.fit_record(self.device)
        labelled = [(f"{self.device}, measured", record["force_kN"]), (self._law, self.force_kN)]
        return _show.draw_loop(ax, record["disp_mm"], labelled)


class LawFits(_Mapping):
    """The fits of a law, a Fit by name of device: ``campaign["bouc-wen"]``. Devices that were refused are not in it.

    ``results`` is the law's entry in summary.json.
    """

    def __init__(self, campaign, results):
        self._results = results
        fits = (Fit(campaign, results["id"], of_device) for of_device in results["devices"])
        self._fits = {fit.device: fit for fit in fits}

    def __getitem__(self, device):
        if device not in self._fits:
            raise KeyError(f"{device}; allowed: {', '.join(self._fits)}")
        return self._fits[device]

    def __iter__(self):
        return iter(self._fits)

    def __len__(self):
        return len(self._fits)

    def __eq__(self, other):
        return isinstance(other, LawFits) and self.results == other.results

    def __hash__(self):
        return hash((self.law, tuple(self._fits)))

    def __repr__(self):
        return f"<isolaw.LawFits of {self.law} to {', '.join(self._fits)}>"

    def _repr_html_(self):
        rows = [(device, "no fit" if fit.objective is None else fit.objective) for device, fit in self._fits.items()]
        return _show.page(f"{self.law}: least objective on each device", rows)

    @property
    def law(self):
        """Id of the law."""
        return self._results["id"]

    @property
    def results(self):
        """The dict of the law in summary.json (docs/summary-json.md)."""
        return self._results

    @property
    def statistics(self):
        """The scatter of each parameter over the devices: a dict as in summary.json. None without analysis."""
        return self._results["population"]

    def to_frame(self):
        """A pandas DataFrame with a row for each device: its objective, and the parameters of the best run."""
        rows = [
            {"device": fit.device, "objective": fit.objective, **(fit.parameters if fit.objective is not None else {})}
            for fit in self._fits.values()
        ]
        return _show.frame(rows, index="device")


class Campaign(_Unchanging, _Mapping):
    """Laws fitted to the devices of a lot, as calibrate, merge and load return them: LawFits by id of the law.

    ``campaign["bouc-wen"]["D06"]`` is the Fit of a law to a device. ``summary`` is the content of summary.json
    (docs/summary-json.md). Arrays are read-only views, except those of runs.
    """

    def __init__(self, core):
        self._core = core
        self._summary = None
        self._fits = None

    def _by_law(self):
        if self._fits is None:
            self._fits = {law["id"]: LawFits(self, law) for law in self.summary["laws"]}
        return self._fits

    def __getitem__(self, law):
        if law not in self._by_law():
            raise KeyError(f"{law}; allowed: {', '.join(self._fits)}")
        return self._fits[law]

    def __iter__(self):
        return iter(self._by_law())

    def __len__(self):
        return len(self._by_law())

    def __eq__(self, other):
        return isinstance(other, Campaign) and self.summary == other.summary

    def __hash__(self):
        return hash((tuple(self.laws), tuple(self.devices)))

    def __reduce__(self):
        return _campaign_of, (_core.campaign_state(self._core),)

    def _rows(self):
        best = {law: fits.results["objective"]["best"] for law, fits in self.items()}
        return [(law, "no fit" if value is None else f"{value:.4g}") for law, value in best.items()]

    def __repr__(self):
        state = "" if self.complete else ", not complete"
        objectives = ", ".join(f"{law} {value}" for law, value in self._rows())
        return f"<isolaw.Campaign of {_show.counted(len(self.devices), 'device')}{state}; least objectives: {objectives}>"

    def _repr_html_(self):
        title = f"{self.summary['title'] or 'Campaign'}: least objective of each law, {_show.counted(len(self.devices), 'device')}"
        return _show.page(title, self._rows())

    @property
    def summary(self):
        """All numbers of the campaign, as the dict that summary.json holds. It is made once: do not change it."""
        if self._summary is None:
            self._summary = _json.loads(self._core._summary_json())
        return self._summary

    @property
    def findings(self):
        """Warnings, doubts and notes: a list of dicts with kind, severity, sentence, law, devices and more."""
        return self.summary["warnings"]

    def to_frame(self):
        """A pandas DataFrame with a row for each law: least and mean objective, beta, and whether it is on the front."""
        rows = [
            {"law": law, **fits.results["objective"], "beta": fits.results["beta"], "on_front": fits.results["on_front"]}
            for law, fits in self.items()
        ]
        return _show.frame(rows, index="law")

    def plot_loop(self, law, device, ax=None):
        """Draws the measured loop of a device and that of a law with Matplotlib. Returns the axes."""
        return self[law][device].plot(ax)

    def plot_front(self, ax=None, *, kind="runs"):
        """Draws accuracy against robustness with Matplotlib: a point for each law, filled if it is on the front.

        kind: as in front(). ax: axes to draw into. Returns the axes.
        """
        ax = _show.axes(ax)
        for row in self.front(kind):
            if row["accuracy"] is None or row["robustness"] is None:
                continue
            at = row["robustness"], row["accuracy"]
            ax.plot(*at, "o", color="C0", fillstyle="full" if row["on_front"] else "none")
            ax.annotate(row["law"], at, xytext=(5, 5), textcoords="offset points")
        ax.margins(0.2)  # room for the names
        robustness = "Objective on devices that were left out" if kind == "loo" else "Robustness index beta, Eq. (31)"
        ax.set(xlabel=robustness, ylabel="Mean objective, Eq. (27)" if kind == "runs" else "Objective of the best fits")
        return ax

    @property
    def complete(self):
        """Whether every requested run and analysis has finished."""
        return self._core.complete

    @property
    def devices(self):
        """Names of the devices, including refused ones."""
        return [device["name"] for device in self.summary["devices"]]

    @property
    def laws(self):
        """Ids of the laws in the campaign's order."""
        return [law["id"] for law in self.summary["laws"]]

    def record(self, device):
        """The raw Record of a device. Raises Error for an unknown device, and with the reason for a refused one."""
        return self._core.record(device)

    def properties(self, device):
        """Stiffness, damping and more of a device, cycle by cycle: a dict, as properties() returns it.

        Its ``vertical`` is the compression test of the campaign. Raises Error as record() does.
        """
        self.record(device)
        found = _json.loads(self._core._inspection_json())
        return next(one for one in found.get("devices", [found]) if one["name"] == device)

    def fit_record(self, device):
        """The cleaned, thinned record of the fit: a dict of views time_s, disp_mm and force_kN of shape (samples,)."""
        return {name: self._core.fit_channel(device, name) for name in ("time_s", "disp_mm", "force_kN")}

    def force(self, law, device, motion=None, *, anyway=False):
        """Force in kN of the best run at the samples of fit_record(device), shape (samples,): a read-only view.

        motion: a Record, or displacements in mm for a law that needs no time. The result is then the force under this
        motion, as ``isolaw simulate --from`` computes it, and device may be "lot". Doubts about the law and a motion
        beyond the tests are Python warnings. Raises Error for a law that should not be used, unless anyway is true.
        """
        if motion is None:
            return self._core.force(law, device)
        return self._force_under(law, device, motion, anyway)

    def _force_under(self, law, device, motion, anyway):
        force_kN, doubts = self._core.force_under(law, device, _a_motion(motion), bool(anyway))
        _warn(doubts, frames=4)
        return force_kN

    def parameters(self, law, device):
        """Parameters of the best run on a device, or with device="lot" of the lot's law: a dict in the law's units.

        If a device has the name "lot", that is this device, here and wherever a device is named. Raises Error if the
        campaign has no parameters for the law and the device.
        """
        return self._core.parameters(law, device)

    def runs(self, law, device):
        """Every run of a law on a device, as a dict of arrays and lists.

        number and objective have the shape (runs,), parameters (runs, parameters) in the law's order and units, NaN for
        a failed run. outcome is a list of texts. history is a list with an array for each run: the best objective after
        each generation or start. Raises Error for an unknown law or device.
        """
        return self._core.runs(law, device)

    def front(self, kind="runs"):
        """Accuracy against robustness: a list of dicts law, accuracy, robustness, on_front, in the order of the laws.

        kind: "runs" sets the mean objective over the runs against beta, Eq. (31) of Cucuzza et al. 2025 (its Fig. 14);
        "converged" uses the best fits for both; "loo" sets the objectives of the best fits against those on devices
        that were left out. The last two need analysis. Smaller is better for both numbers; None means undefined. Raises
        Error for another kind.
        """
        columns = {
            "runs": lambda law: (law["objective"]["mean"], law["beta"], law["on_front"]),
            "converged": lambda law: (law["objective_converged"], law["beta_converged"], law["on_front_converged"]),
            "loo": lambda law: (law["objective_converged"], law["loo_objective"], law["on_front_loo"]),
        }
        if kind not in columns:
            raise Error(f"kind: '{kind}'; allowed: {', '.join(columns)}")
        rows = []
        for law in self.summary["laws"]:
            accuracy, robustness, on_front = columns[kind](law)
            rows.append({"law": law["id"], "accuracy": accuracy, "robustness": robustness, "on_front": on_front})
        return rows

    @_with_keywords(_EXPORT_OPTIONS, in_place=True)
    def export(
        self, law, device="lot", *, to, out=None, units=None, name=None, motions=(), seed=None, anyway=False, **given
    ):
        """Exports a fitted law for an analysis program, as ``isolaw export`` does. Returns an Export.

        device: a name, or "lot" for the law that was fitted to all devices together. to: the program, such as
        "opensees", "cpp", "abaqus" or "json"; Error names them all. units: "kN-mm", "N-m" or "kip-in", by default those
        of the reports. name: the name of what the file defines. motions: ground motions, as files, under which a
        re-fitted material is compared with the law; motion_dt and motion_unit state the step in s and the unit of
        acceleration of motions whose files do not. out: a file for the text, which is replaced. anyway: exports also a law that is not
        fit for use. rules, design, lot_size and the keywords that begin with alike: as in calibrate; they decide the
        bounds. layout, mass, gyration, axial, ground_motion, scale, draws and others are for the targets that write a
        whole building (docs/export.md); seed is the seed of the draws.

        Raises Error for what is unknown or does not go with the target, and for a law that is not fit for use.
        """
        if isinstance(motions, (str, _os.PathLike)):
            motions = [motions]
        given = _paths_as_text(given) | {"units": units, "name": name, "seed": seed}
        text, doubts = _core.export(self._core, law, device, to, [_os.fspath(m) for m in motions], given, bool(anyway))
        exported = Export(text, doubts)
        if out is not None:
            exported.write(out)
        return exported

    def sample(self, law, count=100, *, seed=None):
        """Draws devices from the lot's population, as ``isolaw sample`` does.

        Returns a dict by parameter of arrays of shape (count,), in the law's units; ``pandas.DataFrame(...)`` makes a
        table of it. Device i depends only on the seed, the law and i. seed: by default the campaign's. Raises Error if
        the law has no population, for example without analysis or for a single device.
        """
        names, values, remarks = _core.sample(self._core, law, count, {"seed": seed})
        _warn(remarks)
        return dict(zip(names, values.T))

    def write(self, directory):
        """Writes summary.json, the tables and report.html into a directory. Raises Error if this fails."""
        self._core.write(_os.fspath(directory))


def _campaign_of(state):
    return Campaign(_core.campaign_of(state))


class Export:
    """A law that was exported for an analysis program; Campaign.export() returns it."""

    def __init__(self, text, warnings):
        self._text = text
        self._warnings = warnings

    def __eq__(self, other):
        return isinstance(other, Export) and (self.text, self.warnings) == (other.text, other.warnings)

    def __hash__(self):
        return hash(self._text)

    def __str__(self):
        return self._text

    def __repr__(self):
        return f"<isolaw.Export of {self._text.count(chr(10))} lines; warnings: {len(self._warnings)}>"

    @property
    def text(self):
        """The text of the file."""
        return self._text

    @property
    def warnings(self):
        """Sentences about the law and its use that its user has to read: a list of texts."""
        return list(self._warnings)

    def write(self, file):
        """Writes the text into a file, which is replaced if it is there. Raises Error if it is a campaign's store."""
        _core.write_output(_os.fspath(file), self._text)


def _warn(sentences, frames=3):
    """Gives each sentence as a Python warning for the user's code, which is `frames` frames above this function."""
    for sentence in sentences:
        _warnings.warn(sentence, stacklevel=frames)


def _paths_as_text(given):
    return {key: _os.fspath(value) if isinstance(value, _os.PathLike) else value for key, value in given.items()}


@_contextlib.contextmanager
def _reporting(progress):
    """Yields the function that the compiled part calls: a progress bar for True, None for None, else `progress`."""
    if progress is not True:
        yield progress or None
        return
    bar = _show.Bar()
    try:
        yield lambda done, total, analysis=False, best=None, share=None: bar(done / total if share is None else share)
    finally:
        bar.close()


def _adapted(progress):
    """Wraps `progress`: the wrapper takes every argument and passes on those that `progress` accepts."""
    if progress is None:
        return None
    try:
        takes = list(_inspect.signature(progress).parameters.values())
    except (TypeError, ValueError):  # a built-in function may have no signature
        takes = []
    everything = any(one.kind is one.VAR_KEYWORD for one in takes)
    by_position = [one for one in takes if one.kind in (one.POSITIONAL_ONLY, one.POSITIONAL_OR_KEYWORD)]
    by_name = {one.name for one in takes if one not in by_position[:4] and one.kind is not one.POSITIONAL_ONLY}
    wanted = [name for name in ("share", "left_s") if everything or name in by_name]

    def report(done, total, analysis, best, share, left_s):
        progress(done, total, analysis, best, **{name: {"share": share, "left_s": left_s}[name] for name in wanted})

    return report


def _numbered(how):
    """Replaces numbers of blocks and cycles, 2 or (1, 2), by their texts, "2" or "1-2"."""

    def text(value):
        if value is None or isinstance(value, str):
            return value
        numbers = [_operator.index(one) for one in ([value] if hasattr(value, "__index__") else value)]
        if not numbers or numbers != list(range(numbers[0], numbers[-1] + 1)):
            raise Error(f"blocks or cycles: {value!r}; allowed: a number, numbers that follow one another, or text such as '2-'")
        return str(numbers[0]) if len(numbers) == 1 else f"{numbers[0]}-{numbers[-1]}"

    return {key: text(value) if key in ("fit_blocks", "fit_cycles", "score_blocks") else value for key, value in how.items()}


def _all_samples(how):
    """Replaces samples_per_cycle=None by "all". Otherwise the compiled part would take None as the default."""
    how = _numbered(how)
    return how | {"samples_per_cycle": "all"} if how.get("samples_per_cycle", 0) is None else how


@_with_keywords(settings() | _OPTIONS["acceptance"])
def calibrate(
    records, laws="usual", *, vertical=None, jobs=0, out=None, fresh=False, title="", part=None, progress=None, **given
):
    """Fits laws to records, as ``isolaw calibrate`` does. The same settings and seed give the same numbers.

    records: a Record or a path, or a list of them; each is a device of the lot, under its name.
    laws: "paper", "usual", "all", an id, or a list of them. method: "best" searches for the least objective; "ga" is
    the genetic algorithm of Cucuzza et al. 2025. runs: independent runs per law and device; by default 2 ("ga": 20).
    seed: 0 to 2**64 - 1. set: texts "law.parameter=value", "=lower:upper", "=free" or "=other parameter". population,
    generations, stagnation_tolerance: settings of "ga"; if one of them is given and method is not, the method is "ga".
    samples_per_cycle (None: all), smooth, center: how records are cleaned. weights: "time", "swing" or "travel" decides
    how much a sample counts; for "auto" see docs/method.md. fit_blocks, fit_cycles: the blocks and cycles that laws are
    fitted to. score_blocks: the blocks on which they are tested. Blocks and cycles are texts such as "2", "1-3", "2-".
    analysis: whether to compute which parameters the tests determine, their intervals, and one law for the lot; this
    takes longer than the fits. replicates: number of bootstrap samples of the analysis. bidirectional: "springs" also
    fits spring models for laws without a coupled two-dimensional form. settings() lists these keywords with limits.
    rules: the rule set to compare the tests with, by name or as a file. design: design values, as a dict or as text:
    ``{"K_eff": 1.2, "damping": 15}``. lot_size: number of devices of the production lot, tested or not.
    report_units: units of what reports show. letterhead: a file with the laboratory's letterhead for the certificate.
    vertical: compression tests, a dict by device name: a file, K_v in kN/mm, or a dict with ``file``, ``loads``
    (``"300:1000"``, in kN) and keywords of read_motion. If a test gives no stiffness, the summary says why.
    jobs: threads, 0 for one per core; the numbers do not depend on it. out: a directory for store and reports, where
    the same call continues an interrupted campaign; fresh starts over in it. title: the lot's title.
    part: ``(3, 40)`` computes only the third of 40 equal shares of the runs, into ``out``; merge joins all shares.
    progress: True shows a bar (with tqdm where it is installed, else a line on standard error). A function is called as
    progress(done, total, analysis, best) in the calling thread, for runs and then for analyses; best is a dict by law
    of the least objective so far. If the function takes keywords ``share`` or ``left_s``, it also gets the share of all
    work that is done and the seconds left. An exception that it raises ends the search and is raised here.

    Returns a Campaign. Ctrl-C ends the search with KeyboardInterrupt and keeps finished runs in ``out``. An unusable
    device is refused in the summary; the others are fitted. Raises Error for wrong input, and if no device is usable.
    """
    devices = _records(records)
    laws = laws if isinstance(laws, str) else list(laws)
    if not laws:
        raise Error("laws: there are none; allowed: ids of laws, 'paper', 'usual' or 'all'")
    given = _all_samples(given) | {"laws": laws}
    if not isinstance(given.get("set", ""), str):
        given["set"] = list(given["set"])
    tests = {name: _vertical(test) for name, test in (vertical or {}).items()}
    _warn(_core.remarks_on_design(given), frames=4)
    with _reporting(progress) as told:
        core = _core.calibrate(
            devices, given, tests, jobs, out, bool(fresh), title, part and _part(part), _adapted(told)
        )
    return Campaign(core)


def _records(records):
    records = [records] if isinstance(records, (Record, str, _os.PathLike)) else list(records)
    for one in records:
        if isinstance(one, (str, _os.PathLike)) and _os.fspath(one).endswith(".toml"):
            raise Error(f"{one}: a lot file; allowed: records; try: isolaw calibrate {one} --out DIR, then isolaw.load(DIR)")
    return [_a_record(one) for one in records]


def _a_record(one):
    """Reads a record from a file if it is not one already."""
    if isinstance(one, (Record, str, _os.PathLike)):
        return one if isinstance(one, Record) else read_record(one)
    raise Error(f"record: {type(one).__name__}; allowed: a Record or a file; try: isolaw.record(disp_mm, force_kN, time_s)")


def _part(part):
    try:
        number, of = map(_operator.index, part)
    except (TypeError, ValueError):
        raise Error(f"part: {part!r}; allowed: (K, N), part K of N as whole numbers") from None
    return number, of


def merge(out, parts, *, jobs=0, fresh=False, progress=None):
    """Merges parts into one campaign, as ``isolaw merge`` does. The files are those of a campaign without parts.

    out: the directory of the whole campaign. parts: the directories that ``calibrate(..., part=(K, N), out=DIR)``
    filled, or the campaign.sqlite of each, in any order. Another call may add further parts; a call without parts
    finishes the campaign in ``out``. jobs, fresh, progress: as in calibrate; merge computes the analyses.

    Returns a Campaign. Raises Error for parts that are damaged or belong to another campaign, build or instruction set.
    It also raises Error if runs are missing, with their number for each part, after it has copied the other runs.
    """
    parts = [parts] if isinstance(parts, (str, _os.PathLike)) else list(parts)
    with _reporting(progress) as told:
        core = _core.merge(_os.fspath(out), [_os.fspath(one) for one in parts], jobs, bool(fresh), _adapted(told))
    return Campaign(core)


def load(directory):
    """Reads the Campaign in a directory that calibrate or ``isolaw calibrate --out`` wrote, finished or interrupted.

    Raises Error if the directory has no campaign, or a store that isolaw did not write.
    """
    return Campaign(_core.load(_os.fspath(directory)))


class Building(_Unchanging):
    """A building on bearings drawn from a lot, after its analyses; building() returns it.

    ``results`` is the content of building.json (docs/building-json.md). Arrays over the draws are NaN if a run gave
    no finite numbers.
    """

    def __init__(self, core):
        self._core = core
        self._results = None

    def __repr__(self):
        return f"<isolaw.Building under {_show.counted(len(self.motions), 'motion')}, with {', '.join(self.laws)}>"

    def _repr_html_(self):
        law = self.results["laws"][0]
        rows = [
            (f"{row['title']}, {row['unit']}: nominal", law["quantities"][row["key"]]["nominal"])
            for row in self.results["quantities"]
        ]
        return _show.page(self.results["verdict"], rows)

    @property
    def results(self):
        """The dict that building.json holds. Its ``verdict`` says whether the building holds and how far it moves."""
        if self._results is None:
            self._results = _json.loads(self._core.json())
        return self._results

    @property
    def laws(self):
        """Ids of the laws, in the order of the arrays."""
        return [law["id"] for law in self.results["laws"]]

    @property
    def motions(self):
        """Names of the motions, in the order of the arrays."""
        return [motion["name"] for motion in self.results["motions"]]

    @property
    def quantities(self):
        """The quantities that peaks takes: a dict of title, unit and meaning by key."""
        return {row["key"]: {k: v for k, v in row.items() if k != "key"} for row in self.results["quantities"]}

    def peaks(self, quantity="isolator_mm"):
        """A quantity of every draw under every motion, in its unit: shape (laws, draws, motions).

        Raises Error for an unknown quantity.
        """
        return self._core.quantity(quantity)

    @property
    def displacements_mm(self):
        """The largest displacement of every bearing, shape (laws, draws, motions, bearings): a read-only view."""
        return self._core.displacements()

    @property
    def drifts_mm(self):
        """The largest drift of every storey, shape (laws, draws, motions, storeys): a read-only view."""
        return self._core.drifts()

    @property
    def accelerations_mm_s2(self):
        """The largest absolute acceleration of the base and every floor, shape (laws, draws, motions, 1 + floors): a
        read-only view."""
        return self._core.accelerations()

    @property
    def coverage(self):
        """Share of the draws whose value lies between those of the two bound analyses: a dict by quantity.

        Each value is a dict of inside (the share), lower and upper (the ends of its 95 % interval): arrays of shape
        (laws,). The dict is empty if no bearing is drawn.
        """
        laws = [(law["coverage"] or {"of": {}})["of"] for law in self.results["laws"]]
        return {
            quantity: {key: _np.array([law[quantity][key] for law in laws]) for key in ("inside", "lower", "upper")}
            for quantity in laws[0]
        }

    def history(self, law=0, motion=0):
        """The nominal building over time, by implicit integration: a dict of outcome (text) and arrays.

        law: an id, or a number from 0. motion: a name, or a number from 0. Arrays: time_s (steps,); base and velocity
        (steps, 3), of the base relative to the ground, x and y in mm and mm/s and rotation in rad and rad/s; shear_kN
        (steps, 2), the sum over all bearings; acceleration_mm_s2 (steps, 1 + floors, 2), absolute. Raises Error for an
        unknown law or motion.
        """
        return self._core.history(_index_of(law, self.laws, "law"), _index_of(motion, self.motions, "motion"))

    def write(self, directory):
        """Writes building.json, the tables and building.html into a directory. Raises Error if this fails."""
        self._core.write(_os.fspath(directory))


def _index_of(wanted, names, what):
    if isinstance(wanted, str):
        if wanted in names:
            return names.index(wanted)
    else:
        index = _operator.index(wanted)
        if 0 <= index < len(names):
            return index
    raise Error(f"{what}: {wanted!r}; allowed: {', '.join(names)}, or 0 to {len(names) - 1}")


def _motion_input(motion):
    if isinstance(motion, (str, _os.PathLike)):
        return _os.fspath(motion)
    try:
        parts = tuple(motion)
        if 1 <= len(parts) <= 2 and all(isinstance(part, (str, _os.PathLike)) for part in parts):
            return ",".join(map(_os.fspath, parts))
        if 2 <= len(parts) <= 3:
            return float(parts[0]), *parts[1:]
    except (TypeError, ValueError):
        pass
    raise Error("motions: neither a file, two files, nor (step in s, x in m/s2[, y])")


@_with_keywords(_OPTIONS["building"], in_place=True)
def building(building, campaign, motions=None, *, jobs=0, out=None, fresh=False, progress=None, **given):
    """Studies an isolated building on bearings drawn from a lot, and whether bound analyses cover the lot's scatter.

    This is the command ``isolaw building``. building: a building file (``isolaw building --template`` writes one), or
    its tables as a dict. campaign: a Campaign with analysis, or the directory of one. motions: if given, they replace
    the building's motions; a list of files ("x.AT2"), of pairs of files, or of tuples (step in s, accelerations along x
    in m/s2[, along y]). motion_dt and motion_unit state the step in s and the unit of acceleration of motions whose
    files do not. laws, draws, seed, lower, upper and the other keys of ``[building]`` replace those of the file.
    jobs: threads, 0 for one per core; the numbers do not depend on it. out: a directory for runs and reports, where the
    same call continues an interrupted study; fresh starts over in it. progress: True, or a function that is called as
    progress(done, total) with numbers of analyses, from the calling thread; an exception that it raises ends the study
    and is raised here.

    Returns a Building. Ctrl-C ends the study with KeyboardInterrupt and keeps finished runs in ``out``. Raises Error
    with everything that is wrong in the building.
    """
    file = dict(building) if isinstance(building, _Mapping) else _os.fspath(building)
    source = campaign._core if isinstance(campaign, Campaign) else _os.fspath(campaign)
    if isinstance(motions, (str, _os.PathLike)):
        motions = [motions]
    motions_given = [_motion_input(motion) for motion in motions or ()]
    of_files = [name for name in ("motion_dt", "motion_unit") if given.get(name) is not None]
    if of_files and motions_given and not any(isinstance(motion, str) for motion in motions_given):
        raise Error(f"{of_files[0]}: is given, and no motion is a file; allowed: arrays with the step in s, in m/s2")
    with _reporting(progress) as told:
        core = _core.building(file, source, motions_given, given, jobs, out, bool(fresh), told)
    return Building(core)


@_with_keywords(_OPTIONS["acceptance"], in_place=True)
def inspect(lot, *, vertical=None, folder=".", allow_outside=False, **given):
    """Shows the tests of a lot and their verdicts before any law is fitted, as ``isolaw inspect`` does.

    lot: a lot file, its tables as a dict, or records as calibrate() takes them. rules, design, lot_size and the other
    keywords replace what a lot file says; settings are as in calibrate. vertical: compression tests of records, as in
    calibrate. folder: where the files are that a dict names. allow_outside: also reads files that are not in this
    folder, or in that of the lot file, or below it.

    Returns the dict of inspection.json (docs/inspection-json.md). Several devices are in its ``devices``; a single one
    is the dict itself. ``assessment`` has the verdict on the lot. A device that cannot be used says why. Raises Error
    for wrong input.
    """
    if isinstance(lot, (str, _os.PathLike)) and _os.fspath(lot).endswith(".toml"):
        lot = _os.fspath(lot)
    elif isinstance(lot, _Mapping):
        lot = dict(lot)
    else:
        lot = _records(lot)
    if vertical and not isinstance(lot, list):
        raise Error("vertical: is given with a lot file; allowed: with records; try: the key vertical of the lot file")
    tests = {name: _vertical(test) for name, test in (vertical or {}).items()}
    text, remarks = _core.inspect(lot, _os.fspath(folder), bool(allow_outside), _paths_as_text(given), tests)
    _warn(remarks, frames=4)
    return _json.loads(text)


def rules(name=None):
    """The built-in rule sets: a list of dicts with id, title, edition, source and verified_by.

    name: a rule set, a rule file or "template"; its text is returned instead of the list. A rule file is checked first.
    "template" is a commented file to start from for the rules of a contract. Raises Error for an unknown name and for a
    faulty file.
    """
    return _json.loads(_core.rule_sets_json()) if name is None else _core.rule_text(_os.fspath(name))


def check(directory):
    """Checks that a directory of results is intact and computes its numbers again, as ``isolaw check`` does.

    Returns a dict: sound, campaign and building; the last two are None if the directory holds none. Each is a dict with
    sound, faults (a list of sentences), runs and expected_runs; that of a campaign also has devices, analyses,
    largest_difference (relative, between stored and recomputed objectives), differences (of values that another build
    computed), missing (what an incomplete campaign lacks), and how many reports beside it were compared. Raises Error
    if the directory holds neither.
    """
    return _core.check(_os.fspath(directory))


def example(directory, kind="lot"):
    """Writes a built-in example into a directory, as ``isolaw example`` does: files with computed records.

    kind: "lot", ten records in ten file formats; "tests", three amplitudes with faults; "conditions", tests at several
    temperatures, rates and loads; "building", a building file with motions. Raises Error rather than replace a file.
    """
    _core.example(_os.fspath(directory), kind)


class Conditions(_Unchanging):
    """How properties change with temperature, rate, load, ageing and history; conditions() returns it.

    ``results`` is the content of conditions.json (docs/conditions.md). print() shows what the command prints.
    """

    def __init__(self, core):
        self._core = core
        self._results = None

    def __repr__(self):
        tests = self.results["tests"]
        devices = len({test["device"] for test in tests})
        names = {(test["device"], test["test"]) for test in tests}
        return f"<isolaw.Conditions of {len(names)} tests of {devices} devices>"

    def _repr_html_(self):
        return f"<pre>{_show.escaped(str(self))}</pre>"

    def __str__(self):
        return self._core.text()

    @property
    def results(self):
        """The dict that conditions.json holds."""
        if self._results is None:
            self._results = _json.loads(self._core.json())
        return self._results

    @property
    def bounds(self):
        """The largest and the smallest factor of each property, all effects together: a dict by property."""
        return {row["quantity"]: row for row in self.results["bounds"]}

    @property
    def effects(self):
        """The largest and the smallest factor of each property and effect over the design: a list of dicts."""
        return self.results["design"]

    @property
    def levels(self):
        """The factor of each property at each tested condition: a list of dicts."""
        return self.results["levels"]

    @property
    def observations(self):
        """A dict for each block of each test, with conditions, properties and how it is used: a list for pandas."""
        return self.results["tests"]

    @property
    def findings(self):
        """Everything that the study says besides numbers: a list of dicts."""
        return self.results["findings"]

    @property
    def at_reference(self):
        """Values of acceptance tests not made at the reference, as measured and converted to it: a list of dicts."""
        return self.results["at_reference"]

    def plan(self, devices=None):
        """The tests still needed so that ``devices`` devices are tested at every extreme of the design: a list of dicts.

        devices: as in ``isolaw conditions --plan --devices``; the default is that of the command.
        """
        if devices is None:
            return self.results["plan"]
        return _json.loads(self._core.json_with_plan(_operator.index(devices)))["plan"]


class Test(dict):
    """A test of a device under a stated condition, as a ``[[device.test]]`` table of a lot file; for conditions().

    file: the record, or a list of files that are read one after another as one history. name: the test's name; by
    default the file's name without its ending. aged: ageing in an oven before the test, such as
    ``{"days": 14, "at-C": 70}``. The other keywords are the keys of the table with ``_`` in place of ``-``:
    docs/conditions.md explains those of the condition, read_record() those of reading. The Test is a dict with the
    keys of the table. conditions() checks the values.
    """

    @_with_keywords(_OPTIONS["reading"] | _OPTIONS["test"], in_place=True)
    def __init__(self, file, *, name=None, aged=None, **stated):
        several = not isinstance(file, (str, _os.PathLike))
        super().__init__({"files": [_os.fspath(one) for one in file]} if several else {"file": _os.fspath(file)})
        options = _OPTIONS["reading"] | _OPTIONS["test"]
        stated = {options[keyword]["option"]: value for keyword, value in stated.items()}
        self.update(
            (key, value) for key, value in {"name": name, "aged": aged, **stated}.items() if value is not None
        )


def conditions(lot, *, folder=".", allow_outside=False):
    """Studies how temperature, rate, load, ageing and history change properties, as ``isolaw conditions`` does.

    lot: a lot file with a table ``[conditions]``, the directory of a campaign that was made from one, or the tables of
    a lot file as a dict. folder: where the files are that such a dict names. allow_outside: also reads files that are
    not in this folder, or in that of the lot file, or below it. Returns Conditions. A test that cannot be used is in
    ``results["refused"]``. Raises Error with everything that is wrong in the lot file.

    >>> import isolaw
    >>> warm = isolaw.Test("p1-warm.csv", order=1, temperature_C=20)
    >>> cold = isolaw.Test("p1-cold.csv", order=2, temperature_C=-20, rest_h=24)
    >>> study = isolaw.conditions({
    ...     "conditions": {"reference": {"temperature-C": 20}, "design": {"temperature-C": [-15, 45]}},
    ...     "device": [{"name": "P1", "test": [warm, cold]}],
    ... })
    >>> study.bounds["K_eff"]["max"]["factor"]
    """
    lot = dict(lot) if isinstance(lot, _Mapping) else _os.fspath(lot)
    return Conditions(_core.conditions(lot, _os.fspath(folder), bool(allow_outside)))
