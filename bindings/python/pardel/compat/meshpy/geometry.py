"""What `meshpy.geometry` has for two dimensions: boxes, circles, and domains that are put together from parts."""

from __future__ import annotations

import math
from types import ModuleType
from typing import Any, Callable, List, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from ...errors import UsageError
from .facets import subdivide_facets
from .mesh_info import MeshInfo

Part = Tuple[List[Any], List[Tuple[int, int]], None, List[int]]


class Marker:
    """Markers of the sides of a box and of a circle."""

    MINUS_X = 1
    PLUS_X = 2
    MINUS_Y = 3
    PLUS_Y = 4
    SHELL = 100
    FIRST_USER_MARKER = 1000


def bounding_box(points: npt.ArrayLike) -> Tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """The lower left and the upper right corner."""
    places = np.asarray(points, dtype=np.float64)
    return places.min(axis=0), places.max(axis=0)


def make_box(a: Sequence[float], b: Sequence[float], subdivisions: Optional[Sequence[int]] = None) -> Part:
    """A rectangle with the corners a and b, as (points, facets, None, markers), counter-clockwise from a.

    subdivisions: the numbers of facets along x and along y.

    >>> make_box((0, 0), (2, 1))
    ([(0, 0), (2, 0), (2, 1), (0, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)], None, [3, 2, 4, 1])
    """
    _require_plane("a", len(a))
    _require_plane("b", len(b))
    points: List[Any] = [(a[0], a[1]), (b[0], a[1]), (b[0], b[1]), (a[0], b[1])]
    facets = [(0, 1), (1, 2), (2, 3), (3, 0)]
    markers = [Marker.MINUS_Y, Marker.PLUS_X, Marker.PLUS_Y, Marker.MINUS_X]
    if subdivisions is not None:
        counts = [subdivisions[0], subdivisions[1]] * 2
        points, facets, markers = subdivide_facets(counts, points, facets, markers)
    return points, facets, None, markers


def make_circle(r: float, center: Sequence[float] = (0, 0), subdivisions: int = 40,
                marker: int = Marker.SHELL) -> Part:
    """A circle of equal chords, as (points, facets, None, markers), counter-clockwise from its right end."""
    angles = [2 * math.pi * k / subdivisions for k in range(subdivisions)]
    points = [np.array([center[0] + r * math.cos(angle), center[1] + r * math.sin(angle)]) for angle in angles]
    facets = [(k, (k + 1) % subdivisions) for k in range(subdivisions)]
    return points, facets, None, [marker] * subdivisions


class GeometryBuilder:
    """Puts points and facets of several parts together.

    >>> builder = GeometryBuilder()
    >>> builder.add_geometry(*make_box((0, 0), (1, 1)))
    >>> builder.wrap_in_box(1)
    >>> info = MeshInfo()
    >>> builder.set(info)
    >>> info
    MeshInfo(8 points, 0 elements, 8 facets)
    """

    def __init__(self) -> None:
        self.points: List[Any] = []
        self.facets: List[Tuple[int, int]] = []
        self.facet_hole_starts: Optional[List[Any]] = None
        self.facet_markers: Optional[List[int]] = None
        self.point_markers: Optional[List[int]] = None

    def add_geometry(self, points: Sequence[Any], facets: Sequence[Any],
                     facet_hole_starts: Optional[Sequence[Any]] = None, facet_markers: Any = None,
                     point_markers: Optional[Sequence[int]] = None) -> None:
        """Adds a part. Its facets count its own points from 0. facet_markers: one per facet, or one for all."""
        if facet_hole_starts:
            raise UsageError("facet_hole_starts are for facets of three dimensions; set_holes sets places in holes")
        if isinstance(facet_markers, int):
            facet_markers = [facet_markers] * len(facets)
        self.facet_markers = _joined("facet_markers", self.facet_markers, facet_markers, len(self.facets), len(facets))
        self.point_markers = _joined("point_markers", self.point_markers, point_markers, len(self.points), len(points))
        first = len(self.points)
        self.facets += [(int(a) + first, int(b) + first) for a, b in facets]
        self.points += list(points)

    def set(self, mesh_info: MeshInfo) -> None:
        """Gives the points, the facets and the markers to a `MeshInfo`."""
        mesh_info.set_points(self.points, self.point_markers)
        mesh_info.set_facets(self.facets, self.facet_markers)

    def dimensions(self) -> int:
        """2."""
        return len(self.points[0])

    def mesher_module(self) -> ModuleType:
        """The module with `build`."""
        from . import triangle
        _require_plane("the points", self.dimensions())
        return triangle

    def bounding_box(self) -> Tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """The lower left and the upper right corner."""
        return bounding_box(self.points)

    def center(self) -> npt.NDArray[np.float64]:
        """The middle of the bounding box."""
        low, high = self.bounding_box()
        return (low + high) / 2

    def wrap_in_box(self, distance: float, subdivisions: Optional[Sequence[int]] = None) -> None:
        """Adds a rectangle around everything, at this distance."""
        low, high = self.bounding_box()
        points, facets, _, markers = make_box((low - distance).tolist(), (high + distance).tolist(), subdivisions)
        self.add_geometry(points, facets, facet_markers=markers)

    def apply_transform(self, f: Callable[[Any], Any]) -> None:
        """Replaces each point p by f(p)."""
        self.points = [f(point) for point in self.points]


def _require_plane(what: str, dimensions: int) -> None:
    if dimensions != 2:
        raise UsageError(f"{what} has {dimensions} coordinates; pardel meshes two dimensions")


def _joined(name: str, old: Optional[List[int]], new: Optional[Sequence[int]], of_old: int,
            of_new: int) -> Optional[List[int]]:
    """The markers of all parts; 0 for parts without markers; None if no part has markers."""
    if new is not None and len(new) != of_new:
        raise UsageError(f"{name} has {len(new)} entries; {of_new} are needed")
    if not old and not new:
        return None
    return (old or [0] * of_old) + (list(new) if new else [0] * of_new)
