"""Arguments as NumPy arrays of the right shape, with a message that names the argument where they are not."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np
import numpy.typing as npt

from .errors import UsageError

Numbers = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]
Markers = npt.NDArray[np.int32]

_NONE = np.iinfo(np.uint32).max


def _as_array(name: str, value: Any) -> npt.NDArray[Any]:
    try:
        array = np.asarray(value)
    except ValueError as error:  # rows of different lengths
        raise UsageError(f"{name} is not an array: {error}") from None
    if array.ndim == 0 and array.dtype.kind in "OUS":
        raise UsageError(f"{name} is a {type(value).__name__}; an array of real numbers is needed"
                         + ("; pardel.geometry makes a domain of it" if hasattr(value, "__geo_interface__") else ""))
    if array.dtype.kind not in "iufb" and array.size > 0:
        raise UsageError(f"{name} has the dtype {array.dtype}; real numbers are needed")
    return array


def shape(name: str, value: Any) -> Tuple[int, ...]:
    """The shape of an array; of a number (1,)."""
    return _as_array(name, value).shape or (1,)


def _check_columns(name: str, array: npt.NDArray[Any], columns: int) -> None:
    if array.ndim != 2 or array.shape[1] != columns:
        raise UsageError(f"{name} has the shape {array.shape}; (n, {columns}) is needed")


def numbers(name: str, value: Any, columns: int) -> Numbers:
    """An array of shape (n, columns). Float64 in rows is used as it is."""
    if value is None:
        return np.empty((0, columns))
    array = _as_array(name, value)
    if array.size == 0:
        return np.empty((0, columns))
    _check_columns(name, array, columns)
    return np.ascontiguousarray(array, dtype=np.float64)


def one_per(name: str, value: Any, count: int, of: str) -> Numbers:
    """An array of shape (count,)."""
    array = _as_array(name, value)
    if array.shape != (count,):
        raise UsageError(f"{name} has the shape {array.shape}; ({count},) is needed, one number per {of}")
    return np.ascontiguousarray(array, dtype=np.float64)


def _as_integers(name: str, array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    if array.dtype.kind == "f":
        rounded = array.astype(np.int64, casting="unsafe") if np.isfinite(array).all() else None
        if rounded is None or not np.array_equal(rounded, array):
            raise UsageError(f"{name} has numbers that are not integers")
        return rounded
    return array


def indices(name: str, value: Any, columns: int, points: int) -> Integers:
    """Indices of points, of shape (n, columns)."""
    array = _as_array(name, value)
    if array.size == 0:
        return np.empty((0, columns), dtype=np.int64)
    _check_columns(name, array, columns)
    array = _as_integers(name, array)
    wrong = np.argwhere((array < 0) | (array >= min(points, _NONE)))
    if wrong.size:
        row, column = wrong[0]
        last = f"0 to {points - 1}" if points else "none"
        raise UsageError(f"{name}[{row}] has the point {array[row, column]}; the points are {last}")
    return np.ascontiguousarray(array, dtype=np.int64)


def corners(name: str, value: Any) -> npt.NDArray[Any]:
    """Three integers per triangle. Whether they are indices of points is found out later."""
    array = np.asarray(value)
    if array.size == 0:
        return np.empty((0, 3), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise UsageError(f"{name} has the shape {array.shape}; (m, 3) is needed")
    if array.dtype.kind not in "iu":
        raise UsageError(f"{name} has the dtype {array.dtype}; integers are needed")
    if array.dtype == np.uint64:
        array = np.minimum(array, np.uint64(2**32)).astype(np.int64)
    return array


def markers(name: str, value: Any, count: int, of: str) -> Optional[Markers]:
    """Integers of shape (count,), or (count, 1) as Triangle's wrappers have them."""
    if value is None:
        return None
    array = _as_array(name, value)
    if array.shape == (count, 1):
        array = array[:, 0]
    if array.shape != (count,):
        raise UsageError(f"{name} has the shape {array.shape}; ({count},) is needed, one marker per {of}")
    array = _as_integers(name, array)
    if array.size and (int(array.min()) < -2**31 or int(array.max()) >= 2**31):
        raise UsageError(f"{name} has a number that is no 32-bit integer")
    return np.ascontiguousarray(array, dtype=np.int32)
