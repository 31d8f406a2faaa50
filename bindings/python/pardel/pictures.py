"""Pictures in files, as the program's command ``draw`` makes them."""

from __future__ import annotations

import os
from typing import Any, Optional, Sequence, Tuple

import numpy as np

from . import _pardel
from .domain import Domain, domain_of
from .errors import UsageError
from .mesh_like import mesh_of
from .paths import Path, text_of
from .scalars import whole
from .shapes import is_shapes


def draw(path: Path, mesh: Any, *, by: str = "region", report: Optional[Path] = None,
         window: Optional[Sequence[float]] = None, pixels: Optional[int] = None, legend: bool = True,
         title: Optional[str] = None) -> None:
    """Draws a mesh or a domain as .svg or .png, with a legend. Many triangles become an image of their mean colours.

    mesh: a `Domain` or a geometry, or a mesh in each form that `check` takes.
    by: the colour of triangles: ``region``, ``quality`` (the smallest angle) or ``size`` (the longest edge); or what
        the program made them in: ``tile``, ``phase`` or ``thread``. report: for these, the file that
        ``pardel mesh --json`` wrote with the mesh.
    window: (x0, y0, x1, y1): only this rectangle. pixels: the longer side, from 50 to 20000; by default 1600 for .png
    and 1000 for .svg. title: the first line of the legend; by default the name of the picture.
    Raises `FileError`; `UsageError`, also if the package was built without cairo; `ResourceError` if cairo is not
    installed. `write` draws without it.

    >>> import tempfile
    >>> draw(tempfile.mkdtemp() + "/square.png", ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)]))
    """
    if not hasattr(_pardel, "Picture"):
        raise UsageError("this package was built without cairo (libcairo2-dev), which draw needs; write(path, mesh) "
                         "draws an .svg without it")
    colours = _pardel.colours()
    if by not in colours:
        raise UsageError(f"by is {by!r}; it must be one of {', '.join(sorted(colours))}")
    if colours[by] and report is None:
        raise UsageError(f"by is {by!r}, which needs report, the file that pardel mesh --json wrote with the mesh")
    if not colours[by] and report is not None:
        raise UsageError(f"report is for by='tile', 'phase' or 'thread', and by is {by!r}")
    file = text_of(path)
    suffix = os.path.splitext(file)[1]
    if suffix not in (".svg", ".png"):
        raise UsageError(f"{file}: the suffix of a picture is .svg or .png")
    size = (1600 if suffix == ".png" else 1000) if pixels is None else whole("pixels", pixels)
    if not 50 <= size <= 20000:
        raise UsageError(f"pixels is {size}; an integer from 50 to 20000 is needed")
    picture = _pardel.Picture(file, _window(window), size, _title(title, file) if legend else None)
    if isinstance(mesh, Domain) or is_shapes(mesh):
        if by != "region":
            raise UsageError(f"by is {by!r}, which needs a mesh, and this is a domain")
        _pardel.draw_domain(picture, domain_of(mesh)._core)
    else:
        _pardel.draw_mesh(picture, mesh_of(mesh)._core, by, "" if report is None else text_of(report))


def _title(title: Optional[str], file: str) -> str:
    text = os.path.splitext(os.path.basename(file))[0] if title is None else str(title)
    return os.fsencode(text).decode("utf-8", "replace")


def _window(window: Optional[Sequence[float]]) -> Optional[Tuple[float, float, float, float]]:
    if window is None:
        return None
    try:
        x0, y0, x1, y1 = (float(each) for each in window)
    except (TypeError, ValueError):
        raise UsageError(f"window is {window!r}; four numbers are needed: x0, y0, x1, y1") from None
    if not (x0 < x1 and y0 < y1 and 1e-300 < max(x1 - x0, y1 - y0) < 1e300 and np.isfinite([x0, y0, x1, y1]).all()):
        raise UsageError(f"window is {(x0, y0, x1, y1)}; x0 below x1 and y0 below y1 are needed")
    return x0, y0, x1, y1
