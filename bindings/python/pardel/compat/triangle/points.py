"""Points without segments: their triangulation, hull and Voronoi diagram. Vertices may coincide."""

from __future__ import annotations

from typing import Tuple

import numpy as np
import numpy.typing as npt

from ... import diagram, meshing
from .given import at_least_three

Integers = npt.NDArray[np.int32]
Numbers = npt.NDArray[np.float64]


def delaunay(pts: npt.ArrayLike) -> Integers:
    """The Delaunay triangulation of points: shape (m, 3), int32, counter-clockwise.

    >>> delaunay([[0, 0], [0, 1], [0.5, 0.5], [1, 1], [1, 0]]).shape
    (4, 3)
    """
    points, number = _distinct(pts)
    return number[meshing.delaunay(points).triangles]


def convex_hull(pts: npt.ArrayLike) -> Integers:
    """The edges of the convex hull: shape (h, 2), int32, each clockwise. Points on its sides are on it.

    >>> convex_hull([[0, 0], [0, 1], [1, 1], [1, 0]]).tolist()
    [[3, 0], [2, 3], [1, 2], [0, 1]]
    """
    points, number = _distinct(pts)
    hull = number[meshing.convex_hull(points)]
    return np.stack([np.roll(hull, -1), hull], axis=1)


def voronoi(pts: npt.ArrayLike) -> Tuple[Numbers, Integers, Integers, Numbers]:
    """The Voronoi diagram: points, edges, ray_origin, ray_direct.

    points: shape (m, 2), the circumcentre of each Delaunay triangle. edges: shape (e, 2), int32. ray_origin: shape
    (r,), int32: a point. ray_direct: shape (r, 2). Four points on one circle make an edge of length zero, as in
    Triangle; `pardel.voronoi` says which edges these are.

    >>> points, edges, ray_origin, ray_direct = voronoi([[0, 0], [0, 1], [0.5, 0.5], [1, 1], [1, 0]])
    >>> sorted(points.tolist())
    [[0.0, 0.5], [0.5, 0.0], [0.5, 1.0], [1.0, 0.5]]
    >>> sorted(ray_direct.tolist())
    [[-1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [1.0, 0.0]]
    """
    found = diagram.voronoi(_distinct(pts)[0])
    return found.vertices, found.edges, found.ray_origins, found.ray_directions


def _distinct(pts: npt.ArrayLike) -> Tuple[Numbers, Integers]:
    """The points without those that repeat an earlier one, and the number of each."""
    points = at_least_three(pts, "pts")
    _, first = np.unique(points, axis=0, return_index=True)
    number = np.sort(first).astype(np.int32)
    return points[number], number
