"""The bounds that `mesh`, `refine` and `check` have in common."""

from __future__ import annotations

import inspect
import math
import os
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from ._mesh import Mesh
from .errors import InvalidInput, UsageError
from .mesh_like import mesh_of
from .paths import Path, text_of
from .raster import Raster
from .scalars import number

# Size: a number; one length per point; a mesh with one length per point of it; a function; a raster; the values of a
# raster with its extent or transform; the path of a file with lengths.
Size = Union[float, npt.ArrayLike, Tuple[Any, npt.ArrayLike], Callable[..., Any], Raster, Path]

# A test of triangles: a function of the corners, shape (3, 2), and the area; True: the triangle must be refined.
Test = Callable[[npt.NDArray[np.float64], float], Any]


def goal_of(*, min_angle: float, max_area: Optional[float], max_edge: Optional[float], size: Optional[Size],
            grading: Optional[float], feature_size: Optional[float], conforming: bool, convex_hull: bool,
            region_caps: bool) -> _pardel.Goal:
    """The bounds, apart from a size that depends on the place."""
    goal = _pardel.Goal()
    goal.min_angle = number("min_angle", min_angle)
    if max_area is not None:
        goal.max_area = number("max_area", max_area)
    if max_edge is not None:
        goal.max_edge = number("max_edge", max_edge)
    if is_number(size):
        length = number("size", size)
        if not length > 0:
            raise UsageError(f"size is {length}; a number greater than 0 is needed")
        goal.max_edge = min(goal.max_edge, length)
    if grading is not None:
        goal.grading = number("grading", grading)
    if feature_size is not None:
        goal.feature_edges = number("feature_size", feature_size)
    goal.conforming, goal.convex_hull, goal.region_caps = bool(conforming), bool(convex_hull), region_caps
    return goal


def has_caps(domain: Any) -> bool:
    """True if a region of the domain has a largest area."""
    return bool(np.isfinite(domain.regions[:, 3]).any())


def is_number(size: Any) -> bool:
    return isinstance(size, (int, float, np.number)) or (isinstance(size, np.ndarray) and size.ndim == 0)


def sizes_of(size: Optional[Size], points: int, mesh: Optional[Mesh] = None) -> _pardel.Sizes:
    """A size that depends on the place. `points`: their number; `mesh`: the mesh to which they belong, if any."""
    if size is None or is_number(size):
        return _pardel.Sizes()
    if isinstance(size, (str, os.PathLike)):
        return _sizes_in(size, points, mesh)
    raster = _raster_of(size)
    if raster is not None:
        return _pardel.Sizes.on_raster(raster._core)
    if callable(size):
        return _pardel.Sizes.of_function(size, _takes_numbers(size))
    if isinstance(size, tuple) and len(size) == 2 and not is_number(size[0]):
        background = mesh_of(size[0])
        return _pardel.Sizes.on_mesh(background._core, _lengths(size[1], len(background.points)))
    return _at_points(_lengths(size, points), mesh)


def _at_points(lengths: arrays.Numbers, mesh: Optional[Mesh]) -> _pardel.Sizes:
    return _pardel.Sizes.at_points(lengths) if mesh is None else _pardel.Sizes.on_mesh(mesh._core, lengths)


def _sizes_in(path: Path, points: int, mesh: Optional[Mesh]) -> _pardel.Sizes:
    """Those of a file for the program's option --sizes: a raster, a mesh with lengths, or one length per point."""
    file = text_of(path)
    if not os.path.splitext(file)[1] and not os.path.exists(file):
        raise UsageError(f"size is {file!r}; a number, an array, a function, a Raster or the path of a file with "
                         f"lengths is needed")
    found = _pardel.read_sizes(file)
    if isinstance(found, _pardel.Raster):
        return _pardel.Sizes.on_raster(found)
    if isinstance(found, tuple):
        return _pardel.Sizes.on_mesh(found[0], _lengths(found[1], len(found[1]), file))
    if len(found) != points:
        raise InvalidInput(f"{file}: {len(found)} sizes for {points} points")
    return _at_points(_lengths(found, points, file), mesh)


def _raster_of(size: Any) -> Optional[Raster]:
    """A raster, or an array of two dimensions with an extent (4 numbers) or a transform (6 or 9)."""
    if isinstance(size, Raster):
        return size
    if isinstance(size, tuple) and len(size) == 2 and isinstance(size[0], np.ndarray) and size[0].ndim == 2:
        where = tuple(size[1])
        return Raster(size[0], where) if len(where) == 4 else Raster(size[0], transform=where)
    return None


def test_of(refine_if: Optional[Test]) -> Optional[Test]:
    if refine_if is not None and not callable(refine_if):
        raise UsageError(f"refine_if is {refine_if!r}; a function of the corners of a triangle and its area is needed")
    return refine_if


def _lengths(value: Any, count: int, name: str = "size") -> arrays.Numbers:
    lengths = arrays.one_per(name, value, count, "point")
    wrong = np.flatnonzero(~((lengths > 0) & (lengths < math.inf)))
    if wrong.size:
        raise UsageError(f"{name}[{wrong[0]}] is {lengths[wrong[0]]}; a finite number greater than 0 is needed")
    return lengths


def _takes_numbers(function: Callable[..., Any]) -> bool:
    """True for a function of x and y; False for a function of an array of places."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):  # a builtin function
        return False
    needed = [p for p in parameters
              if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) and p.default is p.empty]
    return len(needed) == 2
