"""Shows records and campaigns as HTML in notebooks, Matplotlib figures and pandas tables, and progress on a terminal.

Matplotlib, pandas and tqdm are used where they are installed. isolaw needs none of them.
"""

import html as _html
import importlib as _importlib
import sys as _sys

import numpy as _np

from ._error import Error


def needed(module, what):
    """Imports a package that isolaw does not need itself. Raises Error if it is not installed."""
    try:
        return _importlib.import_module(module)
    except ImportError:
        package = module.split(".")[0]
        raise Error(f"{what}: needs {package}, which is not installed; try: pip install {package}") from None


def axes(ax):
    return needed("matplotlib.pyplot", "a plot").subplots()[1] if ax is None else ax


def frame(rows, index=None):
    made = needed("pandas", "to_frame()").DataFrame(rows)
    for name, values in made.items():  # None among numbers becomes NaN
        if values.dtype == object and all(value is None or isinstance(value, (int, float)) for value in values):
            made[name] = values.astype(float)
    return made if index is None else made.set_index(index)


def _number(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _svg(x, curves, titles):
    """Draws curves of y over x, each in a colour, as an SVG element."""
    width, height, edge = 340, 240, 24
    step = max(1, len(x) // 800)
    x, curves = x[::step], [curve[::step] for curve in curves]
    low, high = min(_np.min(curve) for curve in curves), max(_np.max(curve) for curve in curves)
    left, right = _np.min(x), _np.max(x)
    across = edge + (x - left) / ((right - left) or 1.0) * (width - 2 * edge)
    lines = []
    for curve, colour in zip(curves, ("#404040", "#c03030")):
        down = height - edge - (curve - low) / ((high - low) or 1.0) * (height - 2 * edge)
        points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(across, down))
        lines.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1"/>')
    ends = (
        f'<text x="{edge}" y="{height - 6}">{left:.4g}</text>'
        f'<text x="{width - edge}" y="{height - 6}" text-anchor="end">{right:.4g}</text>'
        f'<text x="{width / 2}" y="{height - 6}" text-anchor="middle">{titles[0]}</text>'
        f'<text x="{edge}" y="14">{titles[1]}: {low:.4g} to {high:.4g}</text>'
    )
    return (
        f'<svg width="{width}" height="{height}" style="background: #fff; font: 11px sans-serif">'
        + "".join(lines)
        + f'<g fill="#404040">{ends}</g></svg>'
    )


def counted(number, thing):
    return f"{number} {thing}" + ("" if number == 1 else "s")


def escaped(text):
    return _html.escape(text)


def page(title, rows, picture=""):
    """Returns HTML with a small table and a picture. rows: pairs of a name and a value."""
    cells = "".join(
        f"<tr><td>{_html.escape(str(name))}</td><td>{_html.escape(_number(value))}</td></tr>" for name, value in rows
    )
    return f"<b>{_html.escape(title)}</b><table>{cells}</table>{picture}"


def loop_picture(disp_mm, *forces_kN):
    return _svg(disp_mm, forces_kN, ("Displacement, mm", "Force, kN"))


def time_picture(time_s, disp_mm):
    return _svg(time_s, [disp_mm], ("Time, s", "Displacement, mm"))


def draw_loop(ax, disp_mm, labelled):
    """Draws loops with Matplotlib. labelled: pairs of label and forces in kN; a loop with an empty label has no entry
    in the legend."""
    ax = axes(ax)
    for label, force_kN in labelled:
        ax.plot(disp_mm, force_kN, linewidth=1.0, label=label or None)
    ax.set_xlabel("Displacement, mm")
    ax.set_ylabel("Force, kN")
    if any(label for label, _ in labelled):
        ax.legend()
    return ax


class Bar:
    """Shows the share of work that is done: with tqdm where it is installed, else as a line on standard error."""

    def __init__(self):
        try:
            self._bar = _importlib.import_module("tqdm.auto").tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}")
        except ImportError:
            self._bar = None

    def __call__(self, share):
        percent = round(100.0 * share)
        if self._bar is not None:
            self._bar.update(percent - self._bar.n)
        else:
            print(f"\r{percent:3d} %", end="", file=_sys.stderr, flush=True)

    def close(self):
        if self._bar is not None:
            self._bar.close()
        else:
            print(file=_sys.stderr)
