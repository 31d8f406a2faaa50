"""Domains: points, segments, holes and regions."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from .errors import Problem, UsageError, problems_of


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


DomainLike = Union[Domain, npt.ArrayLike, str, "os.PathLike[str]"]


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
    """The domain that an argument stands for: a `Domain`, the path of a file, or points with `segments` and so on."""
    given = [name for name, part in [("segments", segments), *parts.items()] if part is not None]
    if isinstance(value, (Domain, str, os.PathLike)) and given:
        raise UsageError(f"{given[0]} cannot be given beside a domain, which has its own")
    if isinstance(value, Domain):
        return value
    if isinstance(value, (str, os.PathLike)):
        read = _pardel.read(os.fspath(value))
        if not isinstance(read, _pardel.Pslg):
            raise UsageError(f"{os.fspath(value)} is a mesh; a domain is needed")
        return Domain._of(read)
    return Domain(value, segments, **parts)


def polygon(outline: npt.ArrayLike, *inner: npt.ArrayLike) -> Domain:
    """The domain inside a polygon, without the polygons inside it.

    outline, inner: shape (n, 2): the corners in their order, in either direction, each once or with the first one again
    at the end. The inner ones become holes.

    Raises `UsageError` for a wrong shape, and `InvalidInput` for an inner polygon that crosses itself.

    >>> polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (2, 1), (2, 2)])
    Domain(7 points, 7 segments, 1 holes)
    """
    rings = [_ring(ring) for ring in (outline, *inner)]
    starts = np.cumsum([0, *map(len, rings)])
    ends = [np.stack([start + np.arange(len(ring)), start + np.roll(np.arange(len(ring)), -1)], axis=1)
            for start, ring in zip(starts, rings)]
    holes = [_place_inside(ring) for ring in rings[1:]]
    return Domain(np.concatenate(rings), np.concatenate(ends), holes=holes or None)


def _ring(corners: npt.ArrayLike) -> arrays.Numbers:
    ring = arrays.numbers("a polygon", corners, 2)
    if len(ring) > 1 and np.array_equal(ring[0], ring[-1]):
        ring = ring[:-1]
    if len(ring) < 3:
        raise UsageError(f"a polygon has {len(ring)} corners; at least 3 are needed")
    return ring


def _place_inside(ring: arrays.Numbers) -> arrays.Numbers:
    """The centroid of the largest triangle of the polygon."""
    goal = _pardel.Goal()
    goal.min_angle = 0
    core, _ = _pardel.mesh(polygon(ring)._core, goal, _pardel.Options(), _pardel.Sizes(), False, None, None)
    corners = core.points[core.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    largest = np.argmax(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    place: arrays.Numbers = corners[largest].mean(axis=0)
    return place


def validate(domain: DomainLike, segments: Optional[npt.ArrayLike] = None, *, holes: Optional[npt.ArrayLike] = None,
             regions: Optional[npt.ArrayLike] = None, markers: Optional[npt.ArrayLike] = None,
             convex_hull: bool = False, threads: int = 0) -> Sequence[Problem]:
    """All problems of a domain; none if it can be meshed. Exact: there is no tolerance.

    domain: a `Domain`, the path of a file, or points with the other arguments of `Domain`.
    convex_hull: the domain is the convex hull of the points, and an open outline is no problem.
    Raises `UsageError`, `FileError`. O(n log n) for n points and segments.

    >>> crossing = Domain([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (2, 3)])
    >>> for problem in validate(crossing):
    ...     print(problem.kind, problem.ids, problem.coordinates)
    crossing_segments (0, 1) (1.0, 1.0)
    """
    core = domain_of(domain, segments, holes=holes, regions=regions, markers=markers)._core
    return problems_of(_pardel.problems_of(core, convex_hull, threads))


@dataclass(frozen=True)
class Repaired:
    """What `repair` made.

    domain: the repaired domain. log: the changes, one sentence each; empty if nothing changed.
    point_map: shape (n,), int32: the new index of each old point. segment_map: one old segment per new segment, -1 for
    a side of the convex hull. snap: the distance that was used, in the unit of the coordinates.
    moved_points, bent_segments: how many were moved; farthest: how far, at most.
    """

    domain: Domain
    log: Tuple[str, ...]
    point_map: npt.NDArray[np.int32]
    segment_map: npt.NDArray[np.int32]
    snap: float
    moved_points: int
    bent_segments: int
    farthest: float
    convex_hull: bool


def repair(domain: DomainLike, segments: Optional[npt.ArrayLike] = None, *, snap: Optional[float] = None,
           convex_hull: bool = False, **parts: Any) -> Repaired:
    """Makes a valid domain of one with duplicate points, crossing or overlapping segments, or tiny gaps.

    snap: gaps below this distance are closed, in the unit of the coordinates; 0: only equal points are merged; None:
    gaps that are narrower than about 4e-12 of the coordinates there.
    Raises `UsageError`; `InvalidInput` if a coordinate is not finite, or if no domain is left.

    >>> crossing = Domain([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    >>> repair(crossing).domain
    Domain(5 points, 6 segments)
    """
    made = _pardel.repair(domain_of(domain, segments, **parts)._core, snap, convex_hull)
    return Repaired(domain=Domain._of(made.pop("domain")), **made)
