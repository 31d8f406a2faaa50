"""Domains: points, segments, holes and regions."""

from __future__ import annotations

import os
from typing import Any, Mapping, Optional, Protocol, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from .errors import UsageError
from .notebook import svg_of_domain
from .paths import Path, read_as, text_of
from .plotting import plot_domain
from .shapes import is_shapes


class Domain:
    """A planar straight-line graph: what a mesh is made of, and what it is checked against.

    points: shape (n, 2), float64: coordinates in any unit.
    segments: shape (m, 2): indices of points, from 0. They may meet only at common points (`repair` mends this).
        Without segments the domain is the convex hull of the points.
    holes: shape (h, 2): one place inside each hole.
    regions: shape (r, 2), (r, 3) or (r, 4): a place inside each region, then its attribute (else 0), then the largest
        area of its triangles, in the square of the unit; a number that is not positive means no bound.
    markers: shape (m,): one integer per segment, which the edges on it get.
    point_markers: shape (n,). attributes: shape (n, k): numbers at the points; they are interpolated at new points.

    The arrays are copied once. Raises `UsageError` for a wrong shape, a wrong dtype, or an index out of range. Whether
    the domain can be meshed is found out by `validate`, `mesh` and `check`.

    >>> square = Domain([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    >>> square
    Domain(4 points, 4 segments)
    """

    def __init__(self, points: npt.ArrayLike, segments: Optional[npt.ArrayLike] = None, *,
                 holes: Optional[npt.ArrayLike] = None, regions: Optional[npt.ArrayLike] = None,
                 markers: Optional[npt.ArrayLike] = None, point_markers: Optional[npt.ArrayLike] = None,
                 attributes: Optional[npt.ArrayLike] = None) -> None:
        if points is None:
            raise UsageError("points is None; an array of shape (n, 2) is needed")
        places = arrays.numbers("points", points, 2)
        count = len(places)
        ends = arrays.indices("segments", np.empty((0, 2)) if segments is None else segments, 2, count)
        self._core = _pardel.Pslg(places, ends, arrays.markers("markers", markers, len(ends), "segment"),
                                  arrays.numbers("holes", holes, 2), _regions(regions),
                                  arrays.markers("point_markers", point_markers, count, "point"),
                                  _attributes(attributes, count))

    @classmethod
    def _of(cls, core: _pardel.Pslg) -> Domain:
        domain = cls.__new__(cls)
        domain._core = core
        return domain

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """Shape (n, 2), float64. Read-only, as all arrays here; not copied."""
        return self._core.points

    @property
    def segments(self) -> npt.NDArray[np.int32]:
        """Shape (m, 2), int32: indices of points."""
        return self._core.segments

    @property
    def markers(self) -> Optional[npt.NDArray[np.int32]]:
        """Shape (m,), int32: one per segment; None if none were given."""
        return self._core.markers if self._core.has_markers else None

    @property
    def holes(self) -> npt.NDArray[np.float64]:
        """Shape (h, 2), float64."""
        return self._core.holes

    @property
    def regions(self) -> npt.NDArray[np.float64]:
        """Shape (r, 4), float64: x, y, attribute, largest area (inf: no bound). A copy."""
        return self._core.regions

    @property
    def point_markers(self) -> Optional[npt.NDArray[np.int32]]:
        """Shape (n,), int32; None if none were given."""
        given = self._core.point_markers
        return given if len(given) == len(self.points) and len(given) else None

    @property
    def attributes(self) -> npt.NDArray[np.float64]:
        """Shape (n, k), float64."""
        return self._core.attributes

    def plot(self, ax: Any = None, *, points: bool = True, **options: Any) -> Any:
        """Draws the domain with matplotlib: segments, points, holes as crosses, regions as diamonds.

        ax: the axes of matplotlib; None: the current ones. points: False: no points. Further arguments are for the
        collection of lines. Returns the axes. Raises `UsageError` if matplotlib is not installed.
        """
        return plot_domain(self, ax, points, **options)

    def save(self, path: Path) -> None:
        """Writes a file, .poly or .svg, as `write` does."""
        _pardel.write_domain(text_of(path), self._core)

    def _repr_svg_(self) -> str:
        return svg_of_domain(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Domain):
            return NotImplemented
        return bool(self._core == other._core)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> Tuple[Any, ...]:
        return _unpickled, (self.points.copy(), self.segments.copy(), self.holes.copy(), self.regions,
                            _copied(self.markers), _copied(self.point_markers), self.attributes.copy())

    def __repr__(self) -> str:
        parts = [f"{len(self.points)} points", f"{len(self.segments)} segments"]
        for name, rows in (("holes", self.holes), ("regions", self.regions)):
            if len(rows):
                parts.append(f"{len(rows)} {name}")
        return f"Domain({', '.join(parts)})"


class HasGeoInterface(Protocol):
    """A geometry of shapely, a GeoDataFrame, and so on."""

    @property
    def __geo_interface__(self) -> Any: ...


DomainLike = Union[Domain, npt.ArrayLike, str, "os.PathLike[str]", HasGeoInterface, Mapping[str, Any],
                   Sequence[HasGeoInterface], Sequence[Mapping[str, Any]]]


def _copied(array: Optional[npt.NDArray[np.int32]]) -> Optional[npt.NDArray[np.int32]]:
    return None if array is None else array.copy()


def _unpickled(points: Any, segments: Any, holes: Any, regions: Any, markers: Any, point_markers: Any,
               attributes: Any) -> Domain:
    return Domain(points, segments, holes=holes, regions=regions, markers=markers, point_markers=point_markers,
                  attributes=attributes)


def _regions(regions: Optional[npt.ArrayLike]) -> arrays.Numbers:
    if regions is None:
        return np.empty((0, 4))
    columns = arrays.shape("regions", regions)[-1]
    if columns not in (2, 3, 4):
        return arrays.numbers("regions", regions, 4)
    rows = arrays.numbers("regions", regions, columns)
    full = np.full((len(rows), 4), np.inf)
    full[:, 2] = 0
    full[:, :columns] = rows
    return full


def _attributes(attributes: Optional[npt.ArrayLike], count: int) -> arrays.Numbers:
    if attributes is None:
        return np.empty((count, 0))
    shape = arrays.shape("attributes", attributes)
    if len(shape) != 2:
        raise UsageError(f"attributes has the shape {shape}; ({count}, k) is needed")
    if shape[1] == 0:
        return np.empty((count, 0))
    numbers = arrays.numbers("attributes", attributes, shape[1])
    if len(numbers) != count:
        raise UsageError(f"attributes has {len(numbers)} rows; {count} are needed, one per point")
    return numbers


def domain_of(value: Any, segments: Any = None, **parts: Any) -> Domain:
    """The domain that an argument stands for: a `Domain`, the path of a file, shapes (`geometry`), or points."""
    given = [name for name, part in [("segments", segments), *parts.items()] if part is not None]
    has_parts = isinstance(value, (Domain, str, os.PathLike)) or is_shapes(value)
    if has_parts and given:
        raise UsageError(f"{given[0]} cannot be given beside a domain, which has its own")
    if isinstance(value, Domain):
        return value
    if isinstance(value, (str, os.PathLike)):
        return Domain._of(read_as(_pardel.Pslg, value, "a mesh", "a domain"))
    if has_parts:
        from .geometry import geometry  # which needs Domain

        return geometry(value)
    if hasattr(value, "points") and (hasattr(value, "triangles") or hasattr(value, "cells")):
        raise UsageError(f"this is a {type(value).__name__}; a domain is needed: that of a Mesh is mesh.domain, and "
                         f"pardel.refine takes a mesh")
    return Domain(value, segments, **parts)
