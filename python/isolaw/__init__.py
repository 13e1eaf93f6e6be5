"""Hysteretic laws of seismic isolators, fitted to cyclic tests: the library behind the program ``isolaw``, for NumPy.

>>> import isolaw
>>> record = isolaw.read_record("device-01.csv")
>>> campaign = isolaw.calibrate([record], laws=["bilinear", "bouc-wen"])
>>> campaign.summary["laws"][0]["objective"]["best"]

Units are kN, mm and s; the parameters of a law have the law's own (``isolaw.laws()``). Wrong input raises ``isolaw.Error``.
Arrays of records and results are read-only views of what the library holds, without a copy. Nothing is printed. Long
calls release the interpreter's lock; ``calibrate`` can be interrupted by Ctrl-C.
"""

import functools as _functools
import inspect as _inspect
import json as _json
import operator as _operator
import os as _os
from collections.abc import Mapping as _Mapping

import numpy as _np

from . import _core
from ._error import Error
from ._core import Record, __version__

__all__ = [
    "Building",
    "Campaign",
    "Error",
    "Model",
    "Record",
    "__version__",
    "box",
    "building",
    "calibrate",
    "force",
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
    "settings",
]

Record.__module__ = "isolaw"

_OPTIONS = _json.loads(_core.options_json())


def _takes(options, in_place=False):
    """Keywords of a table in place of a function's own ``**`` parameter: its signature has them, with their defaults.

    in_place: of a value that is elsewhere; None leaves that.
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
            signature.bind(*args, **kwargs)
            return function(*args, **kwargs)

        checked.__signature__ = signature
        return checked

    return decorate


def _settings(*names):
    return {name: _OPTIONS["settings"][name] for name in names}


def _of_motion():
    return {name: option for name, option in _OPTIONS["reading"].items() if not option["of_test"]}


def settings():
    """What calibrate can be told: a dict by keyword.

    Each value holds the option of the command line, help, default, the words it may be one of, the limits of a number
    (least, most; None without), and the method that alone has it (None: both).
    """
    return {
        name: {key: value for key, value in one.items() if key != "stored_only"}
        for name, one in _OPTIONS["settings"].items()
        if not one["stored_only"]
    }


# --- records ----------------------------------------------------------------------------------------------------------


@_takes(_OPTIONS["reading"])
def read_record(path, *, name=None, **reading):
    """Reads a test record: delimited text, Excel, MATLAB or JSON; dialect, columns and units are recognised.

    path: the file. name: of the device, by default the file's without its ending.
    columns, units: what the file does not say, as a dict or as the text of the option of the same name:
    ``columns={"disp": 2, "force": "F"}``, ``units="disp=cm,force=tonf"``. Channels are time, disp, force and load;
    ``columns={"force": "loadcell.csv:F"}`` takes one from another file.
    dt: sampling interval in s of a file without time. sheet, test: which part of a file that holds several.
    rows: ``"101:700"``, rows of numbers counted from 1. from_s, to_s: seconds of the file's own time. footer: ``"skip"``,
    without the text below the rows. thousands: the mark that groups digits. date_order: ``"dmy"`` or ``"mdy"``.
    flip_force, repair, skew_ms, rig_friction_kN, rig_friction_coefficient, moving_mass_kg, force_factor: corrections, as the
    options of ``isolaw inspect``.

    Returns a Record; ``record.recognised`` says what was recognised and why. Raises Error with every problem found.
    """
    return _core.read(path, False, name, reading)


@_takes(_of_motion())
def read_motion(path, *, name=None, **reading):
    """Reads a displacement history, cyclic or seismic, from a file as read_record does; it needs no force.

    from_s, to_s: the part of its time that is read.

    Returns a Record whose ``force_kN`` is None. Raises Error, also for a record of acceleration.
    """
    return _core.read(path, True, name, reading)


def record(disp_mm, force_kN, time_s=None, load_kN=None, *, name="record"):
    """A Record of arrays of equal length, checked as a file's values are.

    disp_mm, force_kN, time_s, load_kN: shape (samples,), in mm, kN, s and kN; time and load may be missing.
    Raises Error: values that are not finite, time that does not increase, displacement and force exchanged, and so on.
    """
    return _core.record(name, disp_mm, force_kN, time_s, load_kN)


def _vertical(test):
    if isinstance(test, _os.PathLike):
        return _os.fspath(test)
    return {k: _os.fspath(v) if k == "file" else v for k, v in test.items()} if isinstance(test, dict) else test


def motion(disp_mm, time_s=None, *, name="motion"):
    """A displacement history of arrays, shape (samples,), in mm and s: a Record whose ``force_kN`` is None.

    Raises Error as record does.
    """
    return _core.record(name, disp_mm, None, time_s, None)


def properties(record, *, vertical=None):
    """Properties of a test cycle by cycle, from raw values: the dict that ``isolaw inspect --json`` prints.

    ``blocks`` lists the blocks of cycles of one amplitude and frequency with ``cycles``, each with K_eff in kN/mm,
    damping in percent of critical, energy per cycle in kN mm and more (docs/inspection-json.md, with formulas and their
    sources in docs/properties.md). vertical: the device's compression test, as in calibrate; ``vertical`` of the result
    has what it gives, or why it gives nothing. Raises Error for a motion without force.
    """
    return _json.loads(record._inspection_json(_vertical(vertical)))


# --- laws -------------------------------------------------------------------------------------------------------------


def laws():
    """The catalogue of laws: a dict by id.

    Each value holds title, source, units (force, length, time), whether it is rate_independent, a note on how the source
    was read, and parameters: name, unit, meaning, physical limits, the paper's search box (published), and the value of
    one that is not fitted unless freed (fixed). Bounds that are None do not exist.
    """
    return {law["id"]: law for law in _json.loads(_core.catalogue_json())}


def box(law, record, *, kind="auto", method="best"):
    """Where a law's parameters are searched on a record: a dict by parameter, in the law's order.

    kind: "auto", scaled from the record, or "published", Table 4 of Cucuzza et al. 2025. method as in calibrate.
    Each value holds unit, free, value (of one that is not free, else None), lower, upper and scale. Raises Error.
    """
    return _core.box(law, record, {"box": kind, "method": method})


@_takes(_settings("integration", "turning_points"))
def force(law, parameters, motion, *, refinement=1, out=None, **how):
    """Force of a law under a displacement history, in kN: a float64 array of shape (samples,).

    law: an id. parameters: a dict by name or the values in the law's order, in its units.
    motion: a Record (its force is not looked at), or an array of displacements in mm for laws that need no time.
    integration: "converged", or "paper" (one Runge-Kutta step per sample). turning_points: "sampled" or "interpolated".
    refinement: integration steps per sample. out: a contiguous float64 array that the forces are written into.

    Values are not finite where the law gives no force. Raises Error: an unknown law, parameters that are missing,
    unknown or outside their physical limits (all said at once), a rate-dependent law without time.
    """
    if not isinstance(motion, Record):
        motion = _core.record("motion", motion, None, None, None)
    return _core.force(law, parameters, motion, how, refinement, out)


class Model:
    """A law on a record as calibrate sees it, for optimisers and studies of one's own.

    law: an id. record: a Record with force. The record is cleaned as calibrate cleans it: thinned to
    ``samples_per_cycle`` (None: not at all), averaged over ``smooth`` samples, centred where ``center`` says so; the
    objective is that of ``fit_blocks`` and ``fit_cycles``. integration, turning_points, refinement as in force. Raises
    Error.
    """

    @_takes(
        _settings("integration", "turning_points", "samples_per_cycle", "smooth", "center", "dead_band", "fit_blocks", "fit_cycles")
    )
    def __init__(self, law, record, *, refinement=1, **how):
        self._core = _core.Model(law, record, _all_samples(how), refinement)
        self._law = law
        self._names = [p["name"] for p in laws()[law]["parameters"]]

    @property
    def law(self):
        """Id of the law."""
        return self._law

    @property
    def parameter_names(self):
        """Names of the parameters in the law's order, which is that of a population's columns."""
        return list(self._names)

    @property
    def time_s(self):
        """Times of the cleaned record in s (sample numbers where it has no time): a read-only view."""
        return self._core.time_s

    @property
    def disp_mm(self):
        """Displacements of the cleaned record in mm: a read-only view."""
        return self._core.disp_mm

    @property
    def force_kN(self):
        """Measured forces of the cleaned record in kN: a read-only view."""
        return self._core.force_kN

    def objective(self, parameters):
        """Eq. (27) of Cucuzza et al. 2025 for one set of parameters (dict or values in order), without a unit.

        Mean over time of |measured - computed force| over the standard deviation of the measured force; infinity where
        a force is not finite. From the scalar path, as every number of a report. Raises Error as force does.
        """
        return self._core.objective(parameters)

    def objectives(self, population, out=None):
        """Objectives of many candidates at once, by the vector kernels: a float64 array of shape (candidates,).

        population: float64 of shape (candidates, parameters) in the law's order and units; read without a copy where it
        is contiguous. Agrees with objective() to about 1e-11; infinity for candidates without a finite force. No limits
        are checked. out: a contiguous float64 array that the values are written into. Raises Error for other shapes.
        """
        return self._core.objectives(population, out)

    def force(self, parameters, out=None):
        """Computed force in kN at the samples of the cleaned record, shape (samples,). Raises Error as force does."""
        return self._core.force(parameters, out)


def objective(law, parameters, record, **how):
    """Objective of one set of parameters on a record: Model(law, record, **how).objective(parameters)."""
    return Model(law, record, **how).objective(parameters)


def objectives(law, population, record, **how):
    """Objectives of many candidates on a record: Model(law, record, **how).objectives(population)."""
    return Model(law, record, **how).objectives(population)


# --- campaigns --------------------------------------------------------------------------------------------------------


class Campaign:
    """Laws fitted to the devices of a lot; made by calibrate and load.

    ``summary`` is the content of summary.json (docs/summary-json.md). Arrays are read-only views, or new where they are
    gathered from the runs.
    """

    def __init__(self, core):
        self._core = core
        self._summary = None

    @property
    def summary(self):
        """All numbers of the campaign: the same dict that summary.json holds."""
        if self._summary is None:
            self._summary = _json.loads(self._core._summary_json())
        return self._summary

    @property
    def complete(self):
        """Whether every run and analysis that was asked for is there."""
        return self._core.complete

    @property
    def devices(self):
        """Names of the devices, refused ones included."""
        return [device["name"] for device in self.summary["devices"]]

    @property
    def laws(self):
        """Ids of the laws, in the order of the campaign."""
        return [law["id"] for law in self.summary["laws"]]

    def record(self, device):
        """The raw Record of a device. Raises Error for one that was refused, with the reason."""
        return self._core.record(device)

    def fit_record(self, device):
        """What the laws were fitted to: a dict of views time_s, disp_mm and force_kN (cleaned and thinned)."""
        return {name: self._core.fit_channel(device, name) for name in ("time_s", "disp_mm", "force_kN")}

    def force(self, law, device):
        """Force in kN that the best run computes at the samples of fit_record(device): a read-only view."""
        return self._core.force(law, device)

    def parameters(self, law, device):
        """Parameters of the best run on a device, or of the one law of all with device="lot": a dict in the law's units.

        Raises Error where there is none.
        """
        return self._core.parameters(law, device)

    def runs(self, law, device):
        """Every run: a dict of arrays number, objective (both of shape (runs,)), parameters (runs, parameters; in the
        law's order; NaN for a run that failed), and lists outcome (text) and history (an array for each run: the best
        objective after each generation or start)."""
        return self._core.runs(law, device)

    def front(self, kind="runs"):
        """Accuracy against robustness: a list of dicts law, accuracy, robustness, on_front, in the order of the laws.

        kind: "runs", mean objective over the runs against beta, Eq. (31) of Cucuzza et al. 2025 (its Fig. 14);
        "converged", the same of the least objectives; "loo", least objectives against those on devices left out. The
        latter two need analysis. Smaller is better in both; None is undefined.
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

    def write(self, directory):
        """Writes summary.json, the tables and report.html into a directory. Raises Error where that cannot be done."""
        self._core.write(_os.fspath(directory))


def _as_it_takes(progress):
    """A function that is told everything, and tells `progress` what it takes."""
    try:
        takes = list(_inspect.signature(progress).parameters.values())
    except (TypeError, ValueError):  # of a built-in function
        takes = []
    everything = any(one.kind is one.VAR_KEYWORD for one in takes)
    by_position = [one for one in takes if one.kind in (one.POSITIONAL_ONLY, one.POSITIONAL_OR_KEYWORD)]
    by_name = {one.name for one in takes if one not in by_position[:4] and one.kind is not one.POSITIONAL_ONLY}
    wanted = [name for name in ("share", "left_s") if everything or name in by_name]

    def told(done, total, analysis, best, share, left_s):
        progress(done, total, analysis, best, **{name: {"share": share, "left_s": left_s}[name] for name in wanted})

    return told


def _all_samples(how):
    """None samples per cycle, which would otherwise mean the default, as the option has it."""
    return how | {"samples_per_cycle": "all"} if how.get("samples_per_cycle", 0) is None else how


@_takes(settings() | _OPTIONS["acceptance"])
def calibrate(
    records, laws="usual", *, vertical=None, jobs=0, out=None, fresh=False, title="", part=None, progress=None, **given
):
    """Fits laws to records, as ``isolaw calibrate`` does: with the same settings and seed the numbers are the same.

    records: a Record or a path, or a list of them; each is a device of the lot, under its name.
    laws: "paper", "usual", "all", an id, or a list of them. method: "best", to the least objective there is, or "ga", the paper's.
    runs: independent runs per law and device (3; ga: 20). seed: 0 to 2**64 - 1. set: texts "law.parameter=value",
    "=lower:upper", "=free" or "=other parameter". population, generations, stagnation_tolerance: of "ga", which they
    choose where no method is given. samples_per_cycle (None: all), smooth, center: how records are cleaned. fit_blocks,
    fit_cycles, score_blocks: which part of the tests laws are judged by and tried on, as texts: "2", "1-3", "2-".
    analysis: what the tests determine, intervals, one law for the lot; takes longer than the fits. replicates: of its
    bootstrap. bidirectional: "springs" fits laws without a coupled form in the plane as springs around the circle too. settings() lists all of these with their limits.
    rules: a rule set the tests are held to, by name or a file. design: design values, as a dict or as text:
    ``{"K_eff": 1.2, "damping": 15}``. lot_size: devices of the production lot, tested or not.
    vertical: compression tests, a dict by device name: a file, K_v in kN/mm, or a dict with ``file``, ``loads``
    (``"300:1000"``, in kN) and keywords of read_motion. One that gives no stiffness says why in the summary.
    jobs: threads, 0 for one per core; the numbers do not depend on it. out: a directory for store and reports, where an
    interrupted campaign is continued by the same call; fresh starts over there. title: of the lot.
    part: ``(3, 40)``, only the third of 40 even shares of the runs, into ``out``; merge makes one campaign of all of them.
    progress: called as progress(done, total, analysis, best) from the calling thread, of runs, then of analyses; best is
    a dict of the least objective so far by law. Where it takes keywords ``share`` or ``left_s``: the share of all work
    that is done, and the seconds left. An exception it raises ends the search and is raised here.

    Returns a Campaign. Ctrl-C ends the search with KeyboardInterrupt, and what has finished is kept in ``out``. A device
    that cannot be used is refused in the summary, the others go on. Raises Error for wrong input and where no device is
    usable.
    """
    records = [records] if isinstance(records, (Record, str, _os.PathLike)) else list(records)
    for one in records:
        if isinstance(one, (str, _os.PathLike)) and _os.fspath(one).endswith(".toml"):
            raise Error(f"{one}: a lot file; allowed: records; try: isolaw calibrate {one} --out DIR, then isolaw.load(DIR)")
    devices = [one if isinstance(one, Record) else read_record(one) for one in records]
    given = _all_samples(given) | {"laws": laws if isinstance(laws, str) else list(laws)}
    if not isinstance(given.get("set", ""), str):
        given["set"] = list(given["set"])
    tests = {name: _vertical(test) for name, test in (vertical or {}).items()}
    told = None if progress is None else _as_it_takes(progress)
    return Campaign(_core.calibrate(devices, given, tests, jobs, out, fresh, title, part and _part(part), told))


def _part(part):
    try:
        number, of = map(_operator.index, part)
    except (TypeError, ValueError):
        raise Error(f"part: {part!r}; allowed: (K, N), part K of N as whole numbers") from None
    return number, of


def merge(out, parts, *, jobs=0, fresh=False, progress=None):
    """One campaign of parts, as ``isolaw merge`` makes it: what ends in ``out`` is, byte by byte, one machine's.

    out: the directory of the whole campaign. parts: directories that ``calibrate(..., part=(K, N), out=DIR)`` filled, or the
    campaign.sqlite of each, in any order; further ones may follow by another call, and none finishes what is there.
    jobs, fresh, progress: as of calibrate; analyses are made here.

    Returns a Campaign. Raises Error for parts that are damaged, or of another campaign, build or instruction set, and
    where runs are missing, which it counts by parts; what is there has then been copied.
    """
    parts = [parts] if isinstance(parts, (str, _os.PathLike)) else list(parts)
    told = None if progress is None else _as_it_takes(progress)
    return Campaign(_core.merge(_os.fspath(out), [_os.fspath(one) for one in parts], jobs, fresh, told))


def load(directory):
    """A Campaign from the directory of a finished or interrupted one, made here or by ``isolaw calibrate --out``.

    Raises Error where there is none, or where it is not as isolaw writes it.
    """
    return Campaign(_core.load(_os.fspath(directory)))


# --- the isolated building --------------------------------------------------------------------------------------------


class Building:
    """A building whose bearings are devices drawn of a lot, shaken; made by building.

    ``results`` is the content of building.json (docs/building-json.md). Of the draws there are arrays: NaN where a run gave
    no finite numbers.
    """

    def __init__(self, core):
        self._core = core
        self._results = None

    @property
    def results(self):
        """All that is answered: the same dict that building.json holds; ``results["verdict"]`` says whether bounds are enough."""
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
        """What is measured of a building: a dict of title, unit and meaning by key."""
        return {row["key"]: {k: v for k, v in row.items() if k != "key"} for row in self.results["quantities"]}

    def peaks(self, quantity="isolator_mm"):
        """A quantity of every draw under every motion: shape (laws, draws, motions), in its unit. Raises Error."""
        return self._core.quantity(quantity)

    @property
    def displacements_mm(self):
        """The largest displacement of every bearing: shape (laws, draws, motions, bearings), a read-only view."""
        return self._core.displacements()

    @property
    def drifts_mm(self):
        """The largest drift of every storey: shape (laws, draws, motions, storeys), a read-only view."""
        return self._core.drifts()

    @property
    def accelerations_mm_s2(self):
        """The largest acceleration in space of the base and every floor: shape (laws, draws, motions, 1 + floors), a
        read-only view."""
        return self._core.accelerations()

    @property
    def coverage(self):
        """Share of the draws between the bounds: a dict by quantity of arrays inside, lower and upper (of its 95 %
        interval), each of shape (laws,)."""
        laws = [law["coverage"]["of"] for law in self.results["laws"]]
        return {
            quantity: {key: _np.array([law[quantity][key] for law in laws]) for key in ("inside", "lower", "upper")}
            for quantity in laws[0]
        }

    def history(self, law=0, motion=0):
        """The nominal building over time, by the implicit path: a dict of outcome (text) and arrays.

        law, motion: ids and names, or numbers from 0. time_s (steps,); base and velocity (steps, 3), of the base relative to
        the ground along x and y in mm and mm/s and its rotation in rad and rad/s; shear_kN (steps, 2), of all bearings;
        acceleration_mm_s2 (steps, 1 + floors, 2), in space.
        """
        return self._core.history(_place(law, self.laws, "law"), _place(motion, self.motions, "motion"))

    def write(self, directory):
        """Writes building.json, the tables and building.html into a directory. Raises Error where that cannot be done."""
        self._core.write(_os.fspath(directory))


def _place(wanted, names, what):
    if isinstance(wanted, str):
        if wanted in names:
            return names.index(wanted)
    else:
        place = _operator.index(wanted)
        if 0 <= place < len(names):
            return place
    raise Error(f"{what}: {wanted!r}; allowed: {', '.join(names)}, or 0 to {len(names) - 1}")


def _shaken(motion):
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


@_takes(_OPTIONS["building"], in_place=True)
def building(building, campaign, motions=None, *, jobs=0, out=None, fresh=False, progress=None, **given):
    """What a lot's scatter makes of an isolated building, and whether bound analyses cover it, as ``isolaw building``.

    building: a building file (``isolaw building --template``), or its tables as a dict. campaign: a Campaign, or the directory
    of one with analysis. motions: in place of the building's; a list of files ("x.AT2"), of pairs of files, or of
    tuples (step in s, accelerations along x in m/s2) with those along y where there are two.
    laws, draws, seed, lower, upper and the other keys of ``[building]``: in place of the building's own.
    jobs: threads, 0 for one per core; the numbers do not depend on it. out: a directory for runs and reports, where an
    interrupted study is continued by the same call; fresh starts over there. progress: called as progress(done, total)
    of analyses from the calling thread; an exception it raises ends them and is raised here.

    Returns a Building. Ctrl-C ends it with KeyboardInterrupt; what has finished is kept in ``out``. Raises Error with everything
    wrong in the building.
    """
    file = dict(building) if isinstance(building, _Mapping) else _os.fspath(building)
    source = campaign._core if isinstance(campaign, Campaign) else _os.fspath(campaign)
    if isinstance(motions, (str, _os.PathLike)):
        motions = [motions]
    shaken = [_shaken(motion) for motion in motions or ()]
    return Building(_core.building(file, source, shaken, given, jobs, out, fresh, progress))
