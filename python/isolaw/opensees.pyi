from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import Literal

from . import Campaign

_Bound = Literal["nominal", "lower", "upper"] | float

def attach(ops: ModuleType | None = None) -> None: ...
def material(
    tag: int,
    law: str,
    source: Campaign | Mapping[str, float],
    *,
    device: str = "lot",
    bound: _Bound = "nominal",
    units: tuple[str, str] = ("kN", "mm"),
    anyway: bool = False,
    dead_band_mm: float = 0.0,
    refinement: int = 1,
) -> None: ...
def section(
    tag: int,
    law: str,
    source: Campaign | Mapping[str, float],
    *,
    device: str = "lot",
    bound: _Bound = "nominal",
    units: tuple[str, str] = ("kN", "mm"),
    orient: Sequence[float] | None = None,
    anyway: bool = False,
    dead_band_mm: float = 0.0,
    refinement: int = 1,
) -> None: ...
