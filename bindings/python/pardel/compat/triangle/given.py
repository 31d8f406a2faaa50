"""The dictionary that a script gives to `triangulate`."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np
import numpy.typing as npt

from ... import arrays
from ...errors import UsageError

_KEYS = ("vertices", "vertex_attributes", "vertex_markers", "triangles", "triangle_max_area", "triangle_attributes",
         "segments", "segment_markers", "holes", "regions", "neighbors", "edges", "edge_markers",
         # What `load` and `voronoi` make, too.
         "triangle_neighbors", "ray_origins", "ray_directions")


class Given:
    """The arrays of the dictionary, each checked when it is asked for. Raises `UsageError` that names the key."""

    def __init__(self, tri: Mapping[str, Any]) -> None:
        if not isinstance(tri, Mapping):
            raise UsageError(f"tri is a {type(tri).__name__}; a dictionary with the key 'vertices' is needed")
        unknown = [key for key in tri if key not in _KEYS]
        if unknown:
            raise UsageError(f"tri has the unknown key {unknown[0]!r}; the keys are {', '.join(_KEYS[:13])}")
        self._tri = tri
        self.points = at_least_three(tri.get("vertices"), "vertices")

    def rows(self, key: str, columns: int) -> arrays.Numbers:
        """Shape (n, columns); (0, columns) without the key."""
        return arrays.numbers(key, self._tri.get(key), columns)

    def indices(self, key: str, columns: int = 2) -> arrays.Integers:
        value = self._tri.get(key)
        return arrays.indices(key, np.empty((0, columns)) if value is None else value, columns, len(self.points))

    def markers(self, key: str, count: int, of: str) -> Optional[arrays.Markers]:
        return arrays.markers(key, self._tri.get(key), count, of)

    def per_row(self, key: str, count: int, of: str) -> Optional[arrays.Numbers]:
        """Shape (count, k): k numbers per vertex or triangle; shape (count,) stands for k = 1."""
        value = self._tri.get(key)
        if value is None or np.size(value) == 0:
            return None
        shape = arrays.shape(key, value)
        if len(shape) > 2 or shape[0] != count:
            raise UsageError(f"{key} has the shape {shape}; ({count}, k) is needed, one row per {of}")
        if len(shape) == 1:
            return arrays.one_per(key, value, count, of).reshape(-1, 1)
        return arrays.numbers(key, value, shape[1])

    def triangles(self) -> arrays.Integers:
        """The corners. Nodes at the middle of edges are left out."""
        value = self._tri.get("triangles")
        if value is None or np.size(value) == 0:
            raise UsageError("opts has the switch r, but tri has no triangles to refine")
        columns = arrays.shape("triangles", value)[-1]
        return self.indices("triangles", 6 if columns == 6 else 3)[:, :3]


def at_least_three(value: Optional[npt.ArrayLike], name: str) -> arrays.Numbers:
    points = arrays.numbers(name, value, 2)
    if len(points) < 3:
        raise UsageError(f"Input must have at least three vertices; {name} has {len(points)}")
    return points
