"""Places with edge lengths, from which lengths grow."""

from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from .domain import HasGeoInterface
from .errors import UsageError
from .geometry import Of, lengths_of
from .paths import Path, text_of
from .shapes import is_shapes


class Sources:
    """Edge lengths at points, along lines, on segments and in regions, for ``sources`` of `mesh` and `check`.

    Away from them, lengths grow by at most ``grading`` per unit of distance. Where they overlap, the least one counts.

    points: shape (n, 3): x, y and the length there.
    lines: shape (n, 5): x and y of both ends, and the length; or (n, 6): the lengths at both ends.
    markers: the length on all segments, and at all points, with a marker of the domain.
    regions: the length in all regions with an attribute of the domain.

    Raises `UsageError`. A marker or an attribute that the domain does not have is an `InvalidInput` of `mesh`.

    >>> Sources(points=[(0.5, 0.5, 0.01)], markers={2: 0.05})
    Sources(2 places)
    """

    def __init__(self, *, points: Optional[npt.ArrayLike] = None, lines: Optional[npt.ArrayLike] = None,
                 markers: Optional[Mapping[int, float]] = None,
                 regions: Optional[Mapping[float, float]] = None) -> None:
        self._core = _pardel.Places(_checked("points", points, 3, 1), _lines(lines), _markers(markers),
                                    _lengths("regions", regions))

    @classmethod
    def read(cls, path: Path) -> Sources:
        """The places that a file of the program's option ``--sources`` names, also one of GeoJSON (docs/formats.md)."""
        return cls._of(_pardel.Places.read(text_of(path)))

    @classmethod
    def of(cls, shapes: Any, length: Of = None) -> Sources:
        """Points, lines and polygons, in each form that `geometry` takes. A length holds inside a polygon, too.

        length: the name of a property, a number for all, or one number per geometry; by default the property
        ``length``. Shapes without a length do not count. Sides of polygons that cross are mended.

        >>> Sources.of({"type": "Point", "coordinates": (0.5, 0.5)}, 0.01)
        Sources(1 places)
        """
        return cls._of(lengths_of(shapes, length))

    @classmethod
    def _of(cls, core: _pardel.Places) -> Sources:
        sources = cls.__new__(cls)
        sources._core = core
        return sources

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        return f"Sources({len(self)} places)"


SourcesLike = Union[Sources, Path, npt.ArrayLike, Mapping[Any, Any], HasGeoInterface, Sequence[HasGeoInterface]]


def sources_of(value: Optional[SourcesLike], grading: Optional[float]) -> Optional[_pardel.Places]:
    """The places that an argument stands for: `Sources`, a path, shapes, rows of x, y and length, lengths by marker."""
    if value is None:
        return None
    if grading is None:
        raise UsageError("sources needs grading, by which lengths grow from them")
    if isinstance(value, (str, os.PathLike)):
        return Sources.read(value)._core
    if is_shapes(value):
        return Sources.of(value)._core
    if isinstance(value, Mapping):
        return Sources(markers=value)._core
    if not isinstance(value, Sources):
        value = Sources(points=arrays.numbers("sources", value, 3))
    return value._core


def _checked(name: str, rows: Any, columns: int, lengths: int) -> arrays.Numbers:
    """The last columns are lengths."""
    numbers = arrays.numbers(f"{name} of sources", rows, columns)
    if not np.isfinite(numbers).all() or not (numbers[:, -lengths:] > 0).all():
        wrong = np.flatnonzero(~(np.isfinite(numbers).all(axis=1) & (numbers[:, -lengths:] > 0).all(axis=1)))[0]
        raise UsageError(f"{name}[{wrong}] of sources is {tuple(numbers[wrong].tolist())}; finite numbers and lengths "
                         f"greater than 0 are needed")
    return numbers


def _lines(lines: Any) -> arrays.Numbers:
    if lines is not None and arrays.shape("lines of sources", lines)[-1] == 5:
        numbers = _checked("lines", lines, 5, 1)
        return np.ascontiguousarray(numbers[:, [0, 1, 2, 3, 4, 4]])
    return _checked("lines", lines, 6, 2)


def _lengths(name: str, lengths: Optional[Mapping[Any, float]]) -> Dict[float, float]:
    if lengths is None:
        return {}
    if not isinstance(lengths, Mapping):
        raise UsageError(f"{name} of sources is a {type(lengths).__name__}; a dict of lengths is needed")
    try:
        found = {float(key): float(length) for key, length in lengths.items()}
    except (TypeError, ValueError):
        raise UsageError(f"{name} of sources is {dict(lengths)!r}; numbers are needed") from None
    for key, length in found.items():
        if not (0 < length < np.inf and np.isfinite(key)):
            raise UsageError(f"{name} of sources has the length {length} for {key}; a finite number greater than 0 is "
                             f"needed")
    return found


def _markers(markers: Optional[Mapping[int, float]]) -> Dict[int, float]:
    found = _lengths("markers", markers)
    for marker in found:
        if marker != int(marker) or abs(marker) > np.iinfo(np.int32).max:
            raise UsageError(f"markers of sources has {marker}, which is no 32-bit integer")
    return {int(marker): length for marker, length in found.items()}
