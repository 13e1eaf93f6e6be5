"""Uses isolaw's laws themselves in OpenSeesPy from PyPI: no material is fitted to them, and nothing is compiled.

>>> import openseespy.opensees as ops, isolaw, isolaw.opensees
>>> isolaw.opensees.attach(ops)
>>> isolaw.opensees.material(7, "power-masing", isolaw.load("out/lot"), bound="upper", units=("kN", "mm"))

A material has a tag like those of ``ops.uniaxialMaterial``, and elements use it in the same way. OpenSees owns it:
``ops.wipe()`` removes it. docs/opensees.md says which versions of OpenSees work, and what is not possible.
"""

import ctypes as _ctypes
import math as _math
import operator as _operator
import os as _os
import pathlib as _pathlib
import sys as _sys
import warnings as _warnings

from . import Campaign as _Campaign
from . import _core
from ._error import Error

__all__ = ["attach", "material", "section"]

_attached = None  # file of the OpenSees module that attach() found and checked; None before attach()
_warned = set()  # warnings given so far, so that further materials do not repeat them


class _Law(_ctypes.Structure):  # IsolawLaw in opensees/law.hpp
    _fields_ = [
        ("id", _ctypes.c_char_p),
        ("parameters", _ctypes.POINTER(_ctypes.c_double)),
        ("count", _ctypes.c_size_t),
        ("dead_band", _ctypes.c_double),
        ("parts", _ctypes.c_int),
        ("length_to_law", _ctypes.c_double),
        ("force_from_law", _ctypes.c_double),
        ("factor", _ctypes.c_double),
        ("lower", _ctypes.c_double),
        ("upper", _ctypes.c_double),
        ("springs", _ctypes.c_int),
        ("axes", (_ctypes.c_double * 3) * 2),
    ]


def _library():
    file = _pathlib.Path(__file__).parent / "_opensees.so"
    if not file.exists():
        raise Error(
            f"isolaw.opensees: this build has no library for OpenSees ({_sys.platform}); "
            "allowed: Linux and macOS; try: isolaw export --to openseespy, a script with a re-fitted material"
        )
    # PyDLL keeps Python's global lock during calls, because OpenSees writes its messages through Python.
    return _ctypes.PyDLL(_os.fspath(file))


def _call(name, *arguments):
    reason = _ctypes.create_string_buffer(4000)
    function = getattr(_library(), name)
    function.restype = _ctypes.c_bool
    if not function(*arguments, reason, _ctypes.c_size_t(len(reason))):
        raise Error(reason.value.decode())


def attach(ops=None):
    """Finds the OpenSees that runs in this Python, and checks that its classes have the layout that isolaw expects.

    ops: the module of OpenSees; by default ``openseespy.opensees``, which is then imported. material() and section()
    call attach() if nobody has, so it is only needed for another module than that of PyPI. Raises Error if the program
    is another one, such as xara, or if its classes differ; nothing has then been changed.
    """
    global _attached
    if ops is None:
        try:
            import openseespy.opensees as ops
        except ImportError as error:
            raise Error(f"isolaw.opensees: {error}; allowed: a Python with OpenSeesPy; try: pip install openseespy") from None
    name = ops.__name__ if isinstance(ops, type(_sys)) else getattr(ops, "__module__", "")
    if name.split(".")[0] == "xara" or name.startswith("opensees.") or (name == "opensees" and hasattr(ops, "__path__")):
        raise Error(
            f"isolaw.opensees: {ops!r} belongs to xara, whose classes change from version to version; allowed: openseespy.opensees; "
            "try: isolaw export --to opensees, a Tcl script with a re-fitted material, which xara reads"
        )
    try:
        file = _sys.modules[ops.node.__module__].__file__
    except (AttributeError, KeyError):
        raise Error(f"isolaw.opensees: {ops!r} is no module of OpenSees; allowed: openseespy.opensees") from None
    _call("isolaw_attach", _os.fsencode(file))
    _attached = _os.fsencode(file)


def _factor(bound, found):
    if isinstance(bound, str):
        factor = {"nominal": 1.0, "lower": found["lower"], "upper": found["upper"]}.get(bound)
        if factor is None:
            there = [name for name in ("lower", "upper") if found[name] is not None]
            raise Error(
                f"bound: {bound!r}; allowed: {', '.join(['nominal', *there])} or a factor on the force above 0 ({found['bounds']})"
            )
        return factor
    allowed = "nominal, lower, upper or a factor on the force above 0"
    factor = _number("bound", bound, float, allowed)
    if isinstance(bound, bool) or not (_math.isfinite(factor) and factor > 0.0):
        raise Error(f"bound: {bound!r}; allowed: {allowed}")
    return factor


def _number(name, value, convert, kind):
    try:
        return convert(value)
    except (TypeError, ValueError, OverflowError):
        raise Error(f"{name}: {value!r}; allowed: {kind}") from None


def _add(call, tag, law, source, device, bound, units, anyway, dead_band_mm, refinement, axes=None):
    tag = _number("tag", tag, _operator.index, "a whole number")
    for name, value in (("law", law), ("device", device)):
        if not isinstance(value, str):
            raise Error(f"{name}: {value!r}; allowed: a name")
    if hasattr(source, "keys") and not isinstance(source, _Campaign):
        source = dict(source)
    if not isinstance(source, (_Campaign, dict)):
        raise Error(f"source: {source!r}; allowed: a campaign, or a dict of parameters by name; try: isolaw.load(directory)")
    if isinstance(source, dict) and device != "lot":
        raise Error(f"device: {device!r} is given with parameters; allowed: only with a campaign")
    if not -(2**31) <= tag < 2**31:
        raise Error(f"tag: {tag}; allowed: whole numbers from -2**31 to 2**31 - 1")
    if not isinstance(units, (tuple, list)) or len(units) != 2 or not all(isinstance(unit, str) for unit in units):
        raise Error(f'units: {units!r}; allowed: a unit of force and one of length, such as ("kN", "mm")')
    if _attached is None:
        attach()
    if isinstance(source, _Campaign) and (dead_band_mm != 0.0 or refinement != 1):
        raise Error("dead_band_mm, refinement: the campaign has its own; allowed: only with parameters")
    given = source._core if isinstance(source, _Campaign) else source
    found = _core.law_for_opensees(
        law,
        given,
        device,
        tuple(units),
        call == "isolaw_section",
        bool(anyway),
        _number("dead_band_mm", dead_band_mm, float, "a length in mm, 0 or more"),
        _number("refinement", refinement, _operator.index, "a whole number, 1 or more"),
    )
    said = list(found["warnings"])
    if not found["rate_independent"]:
        said.append(
            f"the force of {law} depends on velocity, which is 0 in a static analysis: there it gives the force of an endlessly slow motion. "
            "It is also 0 in a Series material and in a section Aggregator, and wrong in a CoupledZeroLength, which pass no velocity on"
        )
    said = [sentence for sentence in said if sentence not in _warned]
    if said:
        _warned.update(said)
        _warnings.warn(" ".join(sentence.rstrip(".") + "." for sentence in said), stacklevel=3)
    parameters = (_ctypes.c_double * len(found["parameters"]))(*found["parameters"])
    none = float("nan")
    arguments = _Law(
        law.encode(),
        parameters,
        len(parameters),
        found["dead_band"],
        found["parts"],
        found["length_to_law"],
        found["force_from_law"],
        _factor(bound, found),
        none if found["lower"] is None else found["lower"],
        none if found["upper"] is None else found["upper"],
        found["springs"],
    )
    if axes is not None:
        for row, axis in enumerate(axes):
            arguments.axes[row][:] = axis
    _call(call, _attached, _ctypes.c_int(tag), _ctypes.byref(arguments))


def material(
    tag, law, source, *, device="lot", bound="nominal", units=("kN", "mm"), anyway=False, dead_band_mm=0.0, refinement=1
):
    """Adds a law to the running OpenSees as a uniaxial material with this tag: force over displacement.

    law: an id of isolaw.laws(). source: a Campaign that fitted the law, or the law's parameters as a dict by name, in
    the law's units. device: the name of a device of the campaign, or "lot" for the law of all devices together. bound:
    "nominal", "lower", "upper" (by the campaign's rule set, or else by the tested devices), or a factor on the force.
    units: units of force and length of the model. anyway: accepts a law whose prediction is unusable. If source is a
    dict: dead_band_mm, the size of reversals that a law with a memory ignores; refinement, the number of equal parts
    into which each step is divided.

    ``ops.parameter`` can change the factor on the force during an analysis. Its parameters are "factor", "lower" and
    "upper"; the value 1 for "upper" makes the upper bound, 0 the nominal law. Recorders and responses: force,
    deformation, tangent, energy and state (docs/opensees.md lists its numbers). A law that depends on velocity uses the
    velocity that the element passes to the material.

    If the campaign has doubts about the law, warnings.warn gives them. Raises Error for an unknown law, device, bound
    or unit, for a law that should not be used, and for a tag that exists.
    """
    _add("isolaw_material", tag, law, source, device, bound, units, anyway, dead_band_mm, refinement)


def section(
    tag, law, source, *, device="lot", bound="nominal", units=("kN", "mm"), orient=None, anyway=False, dead_band_mm=0.0, refinement=1
):
    """Adds a law in two directions to the running OpenSees, as a section with the forces VY and VZ.

    It is meant for ``zeroLengthSection`` in three dimensions with six degrees of freedom. Like ``isolaw.building``, the
    section uses the law's coupled form for two directions if there is one, and otherwise springs around a circle.
    Arguments are those of material(). orient: the six numbers of the element's ``-orient``, which laws that depend on
    velocity need (default 1, 0, 0, 0, 1, 0). With such a law, a step fails if the element has another orientation or
    type.

    Raises Error as material() does, and if a law that needs springs has a force that differs from side to side.
    """
    axes = _axes([1.0, 0.0, 0.0, 0.0, 1.0, 0.0] if orient is None else [float(value) for value in orient])
    _add("isolaw_section", tag, law, source, device, bound, units, anyway, dead_band_mm, refinement, axes)


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _axes(orient):
    """Returns the local axes y and z of an element. orient: the local x axis, then a vector in the plane of x and y."""
    if len(orient) != 6:
        raise Error(f"orient: {len(orient)} numbers; allowed: six, those of the element's -orient")
    z = _cross(orient[:3], orient[3:])
    y = _cross(z, orient[:3])
    lengths = [_math.hypot(*axis) for axis in (y, z)]
    if not all(length > 0.0 and _math.isfinite(length) for length in lengths):
        raise Error(f"orient: {orient}; allowed: two finite directions that are not parallel")
    return [[value / length for value in axis] for axis, length in zip((y, z), lengths)]
