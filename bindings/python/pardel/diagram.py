"""Voronoi diagrams."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Tuple

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from ._mesh import Indices, Mesh, Numbers
from .meshing import delaunay

# Below this sine of the largest angle, a circumcentre is computed in rational arithmetic.
_FLAT = 1e-5


@dataclass(frozen=True, eq=False)
class Voronoi:
    """The Voronoi diagram of points: the dual graph of their Delaunay triangulation, which is exact.

    delaunay: the triangulation; its points are the sites, in their order.
    vertices: shape (m, 2): the circumcentre of each triangle, rounded. Where more than three sites lie on one circle,
        several triangles have this circumcentre; they have the same coordinates here.
    edges: shape (e, 2), int32: indices of vertices, one edge per edge between two triangles.
    edge_sites: shape (e, 2), int32: the sites that each edge separates.
    has_length: shape (e,): False for an edge of length zero: its four sites lie on one circle. Exact. The cells of its
        two sites touch in a point only; ``edges[has_length]`` are the edges that one sees.
    ray_origins: shape (r,), int32: the vertex where each ray begins; one ray per edge of the convex hull.
    ray_directions: shape (r, 2): away from the hull, at a right angle to its edge, and as long as this edge.
    ray_sites: shape (r, 2), int32: the sites that each ray separates.
    """

    delaunay: Mesh
    vertices: Numbers
    edges: Indices
    edge_sites: Indices
    has_length: npt.NDArray[np.bool_]
    ray_origins: Indices
    ray_directions: Numbers
    ray_sites: Indices

    def __repr__(self) -> str:
        return f"Voronoi({len(self.vertices)} vertices, {len(self.edges)} edges, {len(self.ray_origins)} rays)"


def voronoi(points: npt.ArrayLike) -> Voronoi:
    """The Voronoi diagram of points.

    points: shape (n, 2), any unit: at least three that are not on one line, each once. O(n log n).
    Raises `UsageError`, and `InvalidInput` as `delaunay` does.

    >>> diagram = voronoi([(0, 0), (2, 0), (2, 2), (0, 2), (1, 1)])
    >>> diagram
    Voronoi(4 vertices, 4 edges, 4 rays)
    >>> sorted(diagram.vertices.tolist())
    [[0.0, 1.0], [1.0, 0.0], [1.0, 2.0], [2.0, 1.0]]
    """
    mesh = delaunay(arrays.numbers("points", points, 2))
    corners, across = np.ascontiguousarray(mesh.triangles), np.ascontiguousarray(mesh.neighbors)
    # The two ends of the side opposite each corner, counter-clockwise.
    ends = np.stack([np.roll(corners, -1, axis=1), np.roll(corners, -2, axis=1)], axis=2)
    on_one_circle = _pardel.cocircular_sides(mesh._core)
    triangle, side = np.nonzero(across > np.arange(len(corners))[:, None])
    edges = np.stack([triangle, across[triangle, side]], axis=1).astype(np.int32)
    has_length = ~on_one_circle[triangle, side]
    outer, outer_side = np.nonzero(across == -1)
    ray_sites = ends[outer, outer_side]
    ahead = mesh.points[ray_sites[:, 1]] - mesh.points[ray_sites[:, 0]]
    vertices = _circumcentres(mesh.points[corners])
    vertices = vertices[_first_of_circle(len(corners), edges[~has_length])]
    return Voronoi(mesh, vertices, edges, ends[triangle, side], has_length, outer.astype(np.int32),
                   np.stack([ahead[:, 1], 0 - ahead[:, 0]], axis=1), ray_sites)


def _circumcentres(corners: Numbers) -> Numbers:
    """corners: shape (m, 3, 2), counter-clockwise."""
    rows = np.arange(len(corners))
    opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    apex = np.argmax(np.einsum("ijk,ijk->ij", opposite, opposite), axis=1)  # opposite the longest side
    origin = corners[rows, apex]
    a, b = corners[rows, (apex + 1) % 3] - origin, corners[rows, (apex + 2) % 3] - origin
    left, right = a[:, 0] * b[:, 1], a[:, 1] * b[:, 0]
    twice_area = left - right
    is_flat = ~(twice_area > _FLAT * (np.abs(left) + np.abs(right)))
    a_squared, b_squared = np.einsum("ij,ij->i", a, a), np.einsum("ij,ij->i", b, b)
    divisor = np.where(is_flat, 1, 2 * twice_area)
    away = np.stack([b[:, 1] * a_squared - a[:, 1] * b_squared, a[:, 0] * b_squared - b[:, 0] * a_squared], axis=1)
    centres: Numbers = origin + away / divisor[:, None]
    for k in np.flatnonzero(is_flat):
        centres[k] = _exact_circumcentre(corners[k])
    return centres


def _exact_circumcentre(corners: Numbers) -> Tuple[float, float]:
    (x, y), (ax, ay), (bx, by) = ((Fraction(float(p[0])), Fraction(float(p[1]))) for p in corners)
    ax, ay, bx, by = ax - x, ay - y, bx - x, by - y
    a_squared, b_squared = ax * ax + ay * ay, bx * bx + by * by
    divisor = 2 * (ax * by - ay * bx)
    # Coordinates are at most 2^200 and have 53 bits, so this is below 2^700.
    return (float(x + (by * a_squared - ay * b_squared) / divisor),
            float(y + (ax * b_squared - bx * a_squared) / divisor))


def _first_of_circle(count: int, same: Indices) -> npt.NDArray[np.int64]:
    """For each of `count` triangles the first one with the same circumcircle. same: pairs that have the same."""
    first = list(range(count))

    def root(t: int) -> int:
        while first[t] != t:
            first[t] = t = first[first[t]]
        return t

    for a, b in same.tolist():
        a, b = root(a), root(b)
        first[max(a, b)] = min(a, b)
    return np.array([root(t) for t in range(count)])
