from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, TypedDict, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

_Path = str | PathLike[str]
_Floats = NDArray[np.float64]
_Vertical = _Path | float | Mapping[str, Any]
_Parameters = Mapping[str, float] | ArrayLike

class Error(ValueError):
    complaints: list[dict[str, str]]

# This class is compiled code, so editors and the documentation site take its docstrings from this stub.
class Record:
    """A test record or a displacement history, in kN, mm and s, as read_record, read_motion, record and motion
    return it."""

    @property
    def name(self) -> str:
        """Name of the device."""
    @property
    def file(self) -> str:
        """The file that it was read from, or its name."""
    @property
    def disp_mm(self) -> _Floats:
        """Displacements in mm, shape (samples,): a read-only view."""
    @property
    def force_kN(self) -> _Floats | None:
        """Forces in kN, shape (samples,): a read-only view; None for a motion."""
    @property
    def time_s(self) -> _Floats | None:
        """Times in s, shape (samples,): a read-only view; None without time."""
    @property
    def load_kN(self) -> _Floats | None:
        """Vertical loads in kN, shape (samples,): a read-only view; None without."""
    @property
    def recognised(self) -> list[str]:
        """A sentence for each decision of the reader, with its reason."""
    @property
    def warnings(self) -> list[str]:
        """Sentences about doubtful things in the file."""
    def to_frame(self) -> Any:
        """The samples as a pandas DataFrame: columns time_s, disp_mm, force_kN and load_kN, as far as the record has them."""
    def plot(self, ax: Any = None) -> Any:
        """Draws the loop, or a motion over time, with Matplotlib. ax: axes to draw into. Returns the axes."""
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __len__(self) -> int: ...

def read_record(
    path: _Path,
    *,
    name: str | None = None,
    # isolaw keywords reading
    columns: str | Mapping[str, str | int] | None = None,
    units: str | Mapping[str, str | int] | None = None,
    channel_scale: str | Mapping[str, str | int] | None = None,
    dt: float | None = None,
    rows: str | None = None,
    from_s: float | None = None,
    to_s: float | None = None,
    footer: Literal["skip"] | None = None,
    missing: Literal["leave-out", "interpolate"] | None = None,
    thousands: Literal[",", ".", "'", "blank"] | None = None,
    date_order: Literal["dmy", "mdy"] | None = None,
    sheet: str | int | None = None,
    test: str | int | None = None,
    flip_force: bool = False,
    half_cycles: bool = False,
    repair: Literal["spikes"] | None = None,
    skew_ms: float | None = None,
    rig_friction_kN: float | None = None,
    rig_friction_coefficient: float | None = None,
    moving_mass_kg: float | None = None,
    force_factor: float | None = None,
    # end of the keywords that the command above wrote
) -> Record: ...
def read_motion(
    path: _Path,
    *,
    name: str | None = None,
    # isolaw keywords motion
    columns: str | Mapping[str, str | int] | None = None,
    units: str | Mapping[str, str | int] | None = None,
    channel_scale: str | Mapping[str, str | int] | None = None,
    dt: float | None = None,
    rows: str | None = None,
    from_s: float | None = None,
    to_s: float | None = None,
    footer: Literal["skip"] | None = None,
    missing: Literal["leave-out", "interpolate"] | None = None,
    thousands: Literal[",", ".", "'", "blank"] | None = None,
    date_order: Literal["dmy", "mdy"] | None = None,
    sheet: str | int | None = None,
    test: str | int | None = None,
    # end of the keywords that the command above wrote
) -> Record: ...
def record(
    disp_mm: ArrayLike,
    force_kN: ArrayLike,
    time_s: ArrayLike | None = None,
    load_kN: ArrayLike | None = None,
    *,
    name: str = "record",
) -> Record: ...
def same_device(records: Iterable[Record | _Path], *, name: str | None = None) -> Record: ...
def motion(disp_mm: ArrayLike, time_s: ArrayLike | None = None, *, name: str = "motion") -> Record: ...
def properties(record: Record | _Path, *, vertical: _Vertical | None = None) -> dict[str, Any]: ...
def settings() -> dict[str, dict[str, Any]]: ...
def laws() -> dict[str, dict[str, Any]]: ...
def box(
    law: str, record: Record | _Path, *, kind: Literal["auto", "published"] = "auto", method: Literal["best", "ga"] = "best"
) -> dict[str, dict[str, Any]]: ...
def force(
    law: str,
    parameters: _Parameters,
    motion: Record | ArrayLike,
    *,
    # isolaw keywords integration turning_points
    integration: Literal["converged", "paper"] = "converged",
    turning_points: Literal["sampled", "interpolated"] = "sampled",
    # end of the keywords that the command above wrote
    refinement: int = 1,
    dead_band_mm: float = 0.0,
    out: _Floats | None = None,
) -> _Floats: ...

class Model:
    def __init__(
        self,
        law: str,
        record: Record,
        *,
        refinement: int = 1,
        # isolaw keywords integration turning_points smooth samples_per_cycle center dead_band weights fit_blocks fit_cycles
        integration: Literal["converged", "paper"] = "converged",
        turning_points: Literal["sampled", "interpolated"] = "sampled",
        smooth: int = 1,
        samples_per_cycle: int | Literal["all"] | None = 200,
        center: bool = False,
        dead_band: float | Literal["auto"] = "auto",
        weights: Literal["auto", "time", "swing", "travel"] = "auto",
        fit_blocks: str = "all",
        fit_cycles: str = "all",
        # end of the keywords that the command above wrote
    ) -> None: ...
    @property
    def law(self) -> str: ...
    @property
    def parameter_names(self) -> list[str]: ...
    @property
    def free_names(self) -> list[str]: ...
    @property
    def bounds(self) -> tuple[_Floats, _Floats]: ...
    @property
    def time_s(self) -> _Floats: ...
    @property
    def disp_mm(self) -> _Floats: ...
    @property
    def force_kN(self) -> _Floats: ...
    def objective(self, parameters: _Parameters) -> float: ...
    def __call__(self, parameters: _Parameters) -> float: ...
    def residual(self, parameters: _Parameters) -> _Floats: ...
    def objectives(self, population: ArrayLike, out: _Floats | None = None) -> _Floats: ...
    def force(self, parameters: _Parameters, out: _Floats | None = None) -> _Floats: ...

def objective(law: str, parameters: _Parameters, record: Record, **how: Any) -> float: ...
def objectives(law: str, population: ArrayLike, record: Record, **how: Any) -> _Floats: ...

class _FrontRow(TypedDict):
    law: str
    accuracy: float | None
    robustness: float | None
    on_front: bool

class Fit:
    @property
    def law(self) -> str: ...
    @property
    def device(self) -> str: ...
    @property
    def results(self) -> dict[str, Any]: ...
    @property
    def objective(self) -> float | None: ...
    @property
    def parameters(self) -> dict[str, float]: ...
    @property
    def statistics(self) -> dict[str, dict[str, Any]]: ...
    @property
    def intervals(self) -> dict[str, tuple[float, float] | None]: ...
    @property
    def runs(self) -> dict[str, Any]: ...
    def to_frame(self) -> Any: ...
    @property
    def force_kN(self) -> _Floats: ...
    def force(self, motion: Record | ArrayLike, *, anyway: bool = False) -> _Floats: ...
    def plot(self, ax: Any = None) -> Any: ...

class LawFits(Mapping[str, Fit]):
    def __getitem__(self, device: str) -> Fit: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    @property
    def law(self) -> str: ...
    @property
    def results(self) -> dict[str, Any]: ...
    @property
    def statistics(self) -> dict[str, Any] | None: ...
    def to_frame(self) -> Any: ...

class Export:
    def __init__(self, text: str, warnings: Sequence[str]) -> None: ...
    @property
    def text(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    def write(self, file: _Path) -> None: ...

class Campaign(Mapping[str, LawFits]):
    def __getitem__(self, law: str) -> LawFits: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    @property
    def findings(self) -> list[dict[str, Any]]: ...
    def to_frame(self) -> Any: ...
    def plot_loop(self, law: str, device: str, ax: Any = None) -> Any: ...
    def plot_front(self, ax: Any = None, *, kind: Literal["runs", "converged", "loo"] = "runs") -> Any: ...
    @property
    def summary(self) -> dict[str, Any]: ...
    @property
    def complete(self) -> bool: ...
    @property
    def devices(self) -> list[str]: ...
    @property
    def laws(self) -> list[str]: ...
    def record(self, device: str) -> Record: ...
    def fit_record(self, device: str) -> dict[str, _Floats]: ...
    def force(
        self, law: str, device: str, motion: Record | ArrayLike | None = None, *, anyway: bool = False
    ) -> _Floats: ...
    def parameters(self, law: str, device: str) -> dict[str, float]: ...
    def runs(self, law: str, device: str) -> dict[str, Any]: ...
    def front(self, kind: Literal["runs", "converged", "loo"] = "runs") -> list[_FrontRow]: ...
    def properties(self, device: str) -> dict[str, Any]: ...
    def export(
        self,
        law: str,
        device: str = "lot",
        *,
        to: str,
        out: _Path | None = None,
        units: str | None = None,
        name: str | None = None,
        motions: _Path | Iterable[_Path] = (),
        seed: int | None = None,
        anyway: bool = False,
        # isolaw keywords export --but report_units letterhead
        rules: str | PathLike[str] | None = None,
        design: str | Mapping[str, float] | None = None,
        lot_size: int | None = None,
        alike_temperature_C: float | None = None,
        alike_frequency_percent: float | None = None,
        alike_load_percent: float | None = None,
        alike_amplitude_percent: float | None = None,
        alike_earlier_cycles: float | None = None,
        motion_dt: float | None = None,
        motion_unit: str | None = None,
        layout: str | None = None,
        mass: str | None = None,
        gyration: str | None = None,
        axial: str | None = None,
        ground_motion: str | None = None,
        ground_motion_y: str | None = None,
        ground_motion_dt: float | None = None,
        ground_motion_unit: str | None = None,
        scale: float | None = None,
        draws: int | None = None,
        # end of the keywords that the command above wrote
    ) -> Export: ...
    def sample(self, law: str, count: int = 100, *, seed: int | None = None) -> dict[str, _Floats]: ...
    def write(self, directory: _Path) -> None: ...

def calibrate(
    records: Record | _Path | Iterable[Record | _Path],
    laws: str | Sequence[str] = "usual",
    *,
    # isolaw keywords settings acceptance --but laws
    method: Literal["best", "ga"] = "best",
    integration: Literal["converged", "paper"] = "converged",
    turning_points: Literal["sampled", "interpolated"] = "sampled",
    runs: int | None = None,
    population: int = 100,
    generations: int = 50,
    stagnation_tolerance: float = 0.0,
    seed: int = 1,
    box: Literal["published", "auto"] = "auto",
    set: str | Sequence[str] = (),
    smooth: int = 1,
    samples_per_cycle: int | Literal["all"] | None = 200,
    center: bool = False,
    dead_band: float | Literal["auto"] = "auto",
    weights: Literal["auto", "time", "swing", "travel"] = "auto",
    fit_blocks: str = "all",
    fit_cycles: str = "all",
    score_blocks: str = "all",
    analysis: bool | Literal["full", "none"] = "full",
    replicates: int = 100,
    bidirectional: bool | Literal["none", "springs"] = "none",
    rules: str | PathLike[str] | None = None,
    design: str | Mapping[str, float] | None = None,
    lot_size: int | None = None,
    report_units: Literal["kN-mm", "N-m", "kip-in"] | None = None,
    letterhead: str | PathLike[str] | None = None,
    alike_temperature_C: float | None = None,
    alike_frequency_percent: float | None = None,
    alike_load_percent: float | None = None,
    alike_amplitude_percent: float | None = None,
    alike_earlier_cycles: float | None = None,
    # end of the keywords that the command above wrote
    vertical: Mapping[str, _Vertical] | None = None,
    jobs: int = 0,
    out: _Path | None = None,
    fresh: bool = False,
    title: str = "",
    part: tuple[int, int] | None = None,
    progress: Callable[..., object] | bool | None = None,
) -> Campaign: ...
def merge(
    out: _Path,
    parts: _Path | Iterable[_Path],
    *,
    jobs: int = 0,
    fresh: bool = False,
    progress: Callable[..., object] | bool | None = None,
) -> Campaign: ...
def load(directory: _Path) -> Campaign: ...

def inspect(
    lot: Record | _Path | Iterable[Record | _Path] | Mapping[str, Any],
    *,
    vertical: Mapping[str, _Vertical] | None = None,
    folder: _Path = ".",
    allow_outside: bool = False,
    # isolaw keywords acceptance
    rules: str | PathLike[str] | None = None,
    design: str | Mapping[str, float] | None = None,
    lot_size: int | None = None,
    report_units: Literal["kN-mm", "N-m", "kip-in"] | None = None,
    letterhead: str | PathLike[str] | None = None,
    alike_temperature_C: float | None = None,
    alike_frequency_percent: float | None = None,
    alike_load_percent: float | None = None,
    alike_amplitude_percent: float | None = None,
    alike_earlier_cycles: float | None = None,
    # end of the keywords that the command above wrote
) -> dict[str, Any]: ...
@overload
def rules(name: None = None) -> list[dict[str, Any]]: ...
@overload
def rules(name: _Path) -> str: ...
def check(directory: _Path) -> dict[str, Any]: ...
def example(directory: _Path, kind: Literal["lot", "tests", "conditions", "building"] = "lot") -> None: ...

_Motion = _Path | tuple[_Path, _Path] | tuple[float, ArrayLike] | tuple[float, ArrayLike, ArrayLike]

class Building:
    @property
    def results(self) -> dict[str, Any]: ...
    @property
    def laws(self) -> list[str]: ...
    @property
    def motions(self) -> list[str]: ...
    @property
    def quantities(self) -> dict[str, dict[str, Any]]: ...
    def peaks(self, quantity: str = "isolator_mm") -> _Floats: ...
    @property
    def displacements_mm(self) -> _Floats: ...
    @property
    def drifts_mm(self) -> _Floats: ...
    @property
    def accelerations_mm_s2(self) -> _Floats: ...
    @property
    def coverage(self) -> dict[str, dict[str, _Floats]]: ...
    def history(self, law: int | str = 0, motion: int | str = 0) -> dict[str, Any]: ...
    def write(self, directory: _Path) -> None: ...

def building(
    building: _Path | Mapping[str, Any],
    campaign: Campaign | _Path,
    motions: _Path | Sequence[_Motion] | None = None,
    *,
    # isolaw keywords building
    title: str | None = None,
    laws: str | Sequence[str] | None = None,
    draws: int | None = None,
    populations: int | None = None,
    draws_of_each: int | None = None,
    seed: int | None = None,
    damping: float | None = None,
    lower: float | Literal["conditions"] | dict[str, float] | None = None,
    upper: float | Literal["conditions"] | dict[str, float] | None = None,
    step_s: float | None = None,
    rest_s: float | None = None,
    motion_dt: float | None = None,
    motion_unit: str | None = None,
    # end of the keywords that the command above wrote
    jobs: int = 0,
    out: _Path | None = None,
    fresh: bool = False,
    progress: Callable[[int, int], object] | bool | None = None,
) -> Building: ...

class Conditions:
    @property
    def results(self) -> dict[str, Any]: ...
    @property
    def bounds(self) -> dict[str, Any]: ...
    @property
    def effects(self) -> list[dict[str, Any]]: ...
    @property
    def levels(self) -> list[dict[str, Any]]: ...
    @property
    def observations(self) -> list[dict[str, Any]]: ...
    @property
    def findings(self) -> list[dict[str, Any]]: ...
    @property
    def at_reference(self) -> list[dict[str, Any]]: ...
    def plan(self, devices: int | None = None) -> list[dict[str, Any]]: ...

class Test(dict[str, Any]):
    def __init__(
        self,
        file: _Path | Iterable[_Path],
        *,
        name: str | None = None,
        aged: Mapping[str, float] | None = None,
        # isolaw keywords device-test
        columns: str | Mapping[str, str | int] | None = None,
        units: str | Mapping[str, str | int] | None = None,
        channel_scale: str | Mapping[str, str | int] | None = None,
        dt: float | None = None,
        rows: str | None = None,
        from_s: float | None = None,
        to_s: float | None = None,
        footer: Literal["skip"] | None = None,
        missing: Literal["leave-out", "interpolate"] | None = None,
        thousands: Literal[",", ".", "'", "blank"] | None = None,
        date_order: Literal["dmy", "mdy"] | None = None,
        sheet: str | int | None = None,
        test: str | int | None = None,
        flip_force: bool | None = None,
        half_cycles: bool | None = None,
        repair: Literal["spikes"] | None = None,
        skew_ms: float | None = None,
        rig_friction_kN: float | None = None,
        rig_friction_coefficient: float | None = None,
        moving_mass_kg: float | None = None,
        force_factor: float | None = None,
        order: int | None = None,
        temperature_C: float | None = None,
        load_kN: float | None = None,
        rest_h: float | None = None,
        conditioned_h: float | None = None,
        scale: float | None = None,
        fit: bool | None = None,
        specimen: bool | Literal["full", "scaled"] | None = None,
        started: str | None = None,
        stands_for: bool | Literal["dependence", "acceptance"] | None = None,
        temperature_of: Literal["core", "surface", "chamber"] | None = None,
        # end of the keywords that the command above wrote
    ) -> None: ...

def conditions(
    lot: _Path | Mapping[str, Any], *, folder: _Path = ".", allow_outside: bool = False
) -> Conditions: ...
