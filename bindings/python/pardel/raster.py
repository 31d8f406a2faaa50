"""Rasters of edge lengths."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _pardel
from .errors import UsageError
from .paths import Path, text_of


class Raster:
    """Edge lengths on a regular grid, for ``size`` of `mesh`, `refine` and `check`.

    values: shape (rows, columns), the northernmost row first, as in images. Not a number, or masked: no value there;
        inf: no bound. Between the centres of the cells the length is interpolated bilinearly.
    extent: (left, right, bottom, top) of the outer borders of the cells, as matplotlib's ``imshow`` takes it.
    transform: instead of the extent, (a, 0, c, 0, e, f), as rasterio and affine have it: the width of a cell, the
        x of the left border, the height of a cell (negative), and the y of the top.

    The raster has to cover the domain; a place without a value where the mesher needs one is an `InvalidInput`.
    The mesher reads it without the interpreter, on all threads. Raises `UsageError`.

    >>> raster = Raster([[0.1, 0.2], [0.1, 0.4]], extent=(0, 1, 0, 1))
    >>> raster
    Raster(2 rows, 2 columns, extent=(0.0, 1.0, 0.0, 1.0))
    """

    def __init__(self, values: npt.ArrayLike, extent: Optional[Sequence[float]] = None, *,
                 transform: Optional[Sequence[float]] = None) -> None:
        grid = _grid(values)
        rows, columns = grid.shape
        left, right, bottom, top = _borders(extent, transform, rows, columns)
        step_x, step_y = (right - left) / columns, (top - bottom) / rows
        if not (0 < step_x < np.inf and 0 < step_y < np.inf):
            raise UsageError(f"the raster reaches from {left} to {right} and from {bottom} to {top}; each has to be an "
                             f"interval")
        self._core = _pardel.Raster(np.ascontiguousarray(grid[::-1]), left + step_x / 2, bottom + step_y / 2, step_x,
                                    step_y)

    @classmethod
    def read(cls, path: Path) -> Raster:
        """An ESRI ASCII grid (.asc), or an .npy with a world file .wld. Raises `FileError`, `InvalidInput`."""
        raster = cls.__new__(cls)
        raster._core = _pardel.Raster.read(text_of(path))
        return raster

    @property
    def values(self) -> npt.NDArray[np.float64]:
        """Shape (rows, columns), float64, the northernmost row first. Read-only, without a copy."""
        return self._core.values[::-1]

    @property
    def extent(self) -> Tuple[float, float, float, float]:
        """(left, right, bottom, top) of the outer borders of the cells."""
        return self._core.extent

    def __repr__(self) -> str:
        rows, columns = self._core.shape
        return f"Raster({rows} rows, {columns} columns, extent={self.extent})"


def _grid(values: npt.ArrayLike) -> npt.NDArray[np.float64]:
    try:
        given: Any = values if isinstance(values, np.ma.MaskedArray) else np.asarray(values)
        grid = given.astype(np.float64)
        if isinstance(grid, np.ma.MaskedArray):
            grid = grid.filled(np.nan)  # type: ignore[no-untyped-call]
    except (TypeError, ValueError):
        raise UsageError("the values of a raster are not an array of numbers") from None
    if grid.ndim != 2 or grid.size == 0 or max(grid.shape) >= 2**32 - 1:
        raise UsageError(f"the values of a raster have the shape {grid.shape}; (rows, columns) is needed")
    wrong = np.argwhere(grid <= 0)
    if len(wrong):
        row, column = wrong[0]
        raise UsageError(f"the raster has the value {grid[row, column]} in row {row}, column {column}, both counted "
                         f"from 0; a number greater than 0 is needed")
    return grid  # type: ignore[no-any-return]


def _borders(extent: Optional[Sequence[float]], transform: Optional[Sequence[float]], rows: int,
             columns: int) -> Tuple[float, float, float, float]:
    if (extent is None) == (transform is None):
        raise UsageError("a raster needs its extent or its transform, and not both")
    if extent is not None:
        left, right, bottom, top = _finite("extent", extent, 4, "left, right, bottom, top")
        return left, right, bottom, top
    assert transform is not None
    a, b, c, d, e, f = _finite("transform", tuple(transform)[:6], 6, "a, 0, c, 0, e, f")
    if b != 0 or d != 0 or a <= 0 or e >= 0:
        raise UsageError(f"transform is {(a, b, c, d, e, f)}; a > 0, b = d = 0 and e < 0 are needed: columns to the "
                         f"east, and rows to the south")
    return c, c + a * columns, f + e * rows, f


def _finite(name: str, values: Sequence[float], count: int, meaning: str) -> Sequence[float]:
    try:
        numbers = [float(each) for each in values]
    except (TypeError, ValueError):
        numbers = []
    if len(numbers) != count or not np.isfinite(numbers).all():
        raise UsageError(f"{name} is {values!r}; {count} finite numbers are needed: {meaning}")
    return numbers
