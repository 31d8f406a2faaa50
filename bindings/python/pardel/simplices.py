"""Meshes in the terms of scipy.spatial.Delaunay."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional, Tuple, TypeVar

import numpy as np
import numpy.typing as npt

from . import exports
from .errors import UsageError

Indices = npt.NDArray[np.int32]
Numbers = npt.NDArray[np.float64]
Scalar = TypeVar("Scalar", bound=np.generic)


class Simplices:
    """A mesh with the attributes of ``scipy.spatial.Delaunay``, for code that was written for it. Needs no SciPy.

    points: shape (n, 2). simplices: shape (m, 3): the corners, counter-clockwise. neighbors: shape (m, 3): the triangle
    opposite each corner, or -1. coplanar: shape (0, 3). ndim: 2. npoints, nsimplex: n and m.
    min_bound, max_bound: the least and the greatest coordinates. All arrays are contiguous and read-only.

    The mesh need be neither Delaunay nor convex: then `convex_hull` is its boundary. It has no ``equations``,
    ``lift_points`` and ``plane_distance``, which concern the Delaunay property, and no ``add_points``. SciPy's own
    interpolators take a real ``Delaunay`` only; `Mesh.interpolate` is the linear one.

    >>> import pardel
    >>> square = pardel.delaunay([(0, 0), (1, 0), (1, 1), (0, 1)]).to_scipy()
    >>> square.find_simplex([(0.9, 0.5), (2, 2)]).tolist(), square.nsimplex
    ([1, -1], 2)
    """

    ndim = 2

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh
        self.points: Numbers = _fixed(mesh.points)
        self.simplices: Indices = _fixed(mesh.triangles)
        self.neighbors: Indices = _fixed(mesh.neighbors)
        self.coplanar: Indices = _fixed(np.empty((0, 3), np.int32))
        self.npoints, self.nsimplex = len(self.points), len(self.simplices)
        self.min_bound: Numbers = _fixed(self.points.min(axis=0, initial=np.inf))
        self.max_bound: Numbers = _fixed(self.points.max(axis=0, initial=-np.inf))

    def find_simplex(self, xi: npt.ArrayLike, bruteforce: bool = False, tol: Optional[float] = None) -> Indices:
        """The triangle of each point, as `Mesh.locate` finds it; -1 outside.

        xi: shape (..., 2); the result has the shape (...). bruteforce, tol: without a meaning, because the search is
        exact.
        """
        places = np.asarray(xi)
        if places.ndim == 0 or places.shape[-1] != 2:
            raise UsageError(f"xi has the shape {places.shape}; (..., 2) is needed")
        found: Indices = self._mesh.locate(places.reshape(-1, 2)).reshape(places.shape[:-1])
        return found

    @cached_property
    def transform(self) -> Numbers:
        """Shape (m, 3, 2): of a point x in triangle i, the first two barycentric coordinates are
        ``transform[i, :2] @ (x - transform[i, 2])``; the third is 1 minus their sum. NaN for a flat triangle."""
        corners = self.points[self.simplices]
        first, second = corners[:, 0] - corners[:, 2], corners[:, 1] - corners[:, 2]
        determinant = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        rows = np.stack([np.stack([second[:, 1], -second[:, 0]], 1), np.stack([-first[:, 1], first[:, 0]], 1)], 1)
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse = rows / np.where(determinant > 0, determinant, np.nan)[:, None, None]
        return _fixed(np.concatenate([inverse, corners[:, 2:]], axis=1))

    @cached_property
    def vertex_to_simplex(self) -> Indices:
        """Shape (n,): the first triangle at each point; -1 for a point without triangles."""
        first = np.full(self.npoints, -1, np.int32)
        first[self.simplices[::-1].ravel()] = np.repeat(np.arange(self.nsimplex - 1, -1, -1, dtype=np.int32), 3)
        return _fixed(first)

    @cached_property
    def vertex_neighbor_vertices(self) -> Tuple[Indices, Indices]:
        """Two arrays, indptr and indices: the neighbours of point k are ``indices[indptr[k]:indptr[k + 1]]``."""
        starts, targets, _ = exports.neighbours_of_points(self._mesh)
        return _fixed(starts), _fixed(targets)

    @cached_property
    def convex_hull(self) -> Indices:
        """Shape (b, 2): the edges of the boundary, those with one triangle."""
        triangle, corner = np.nonzero(self.neighbors == -1)
        ends = [self.simplices[triangle, (corner + step) % 3] for step in (1, 2)]
        return _fixed(np.stack(ends, axis=1))

    def __repr__(self) -> str:
        return f"Simplices({self.npoints} points, {self.nsimplex} simplices)"


def _fixed(array: npt.NDArray[Scalar]) -> npt.NDArray[Scalar]:
    """Contiguous and read-only; a copy only if it is not contiguous."""
    fixed = np.ascontiguousarray(array)
    fixed.flags.writeable = False
    return fixed
