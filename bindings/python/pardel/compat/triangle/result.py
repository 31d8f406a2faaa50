"""The dictionary that `triangulate` returns."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np
import numpy.typing as npt

from ..._mesh import Mesh
from .given import Given
from .meshing import Made
from .switches import Switches

Dictionary = Dict[str, npt.NDArray[Any]]


def dictionary(made: Made, given: Given, switches: Switches) -> Dictionary:
    """As the wrapper: markers have the shape (n, 1), integers are int32, and a key without rows is absent."""
    mesh = made.mesh
    # The vertices as they are written, and the number of each point of the mesh among them.
    vertices: Dictionary = dict(vertices=mesh.points, vertex_attributes=mesh.attributes,
                                vertex_markers=mesh.point_markers.reshape(-1, 1))
    number = np.arange(len(mesh.points), dtype=np.int32)
    if made.point_map is not None:
        number = _given_numbers(vertices, number, made.point_map, given)
    if switches.jettison:
        number = _without_unused(vertices, number, mesh)
    triangles: npt.NDArray[Any] = number[mesh.triangles]
    if switches.second_order:
        triangles = _with_middles(vertices, triangles, number[mesh.edges], mesh.edge_markers)

    found: Dictionary = {}
    if not switches.no_node:
        found.update(vertices)
    if not switches.no_ele:
        found["triangles"] = triangles
        if made.triangle_attributes is not None:
            found["triangle_attributes"] = made.triangle_attributes
    if (switches.poly or switches.convex_hull) and not switches.no_poly:
        ends = number[mesh.segments]
        is_kept = (ends >= 0).all(axis=1)
        found["segments"], found["segment_markers"] = ends[is_kept], mesh.segment_markers[is_kept].reshape(-1, 1)
        if switches.poly:
            found["holes"], found["regions"] = given.rows("holes", 2), given.rows("regions", 4)
    if switches.edges:
        found["edges"], found["edge_markers"] = number[mesh.edges], mesh.edge_markers.reshape(-1, 1)
    if switches.neighbors:
        found["neighbors"] = mesh.neighbors
    return {key: np.array(value, order="C") for key, value in found.items()
            if value.size and not (switches.no_markers and key.endswith("_markers"))}


def _given_numbers(vertices: Dictionary, number: npt.NDArray[np.int32], point_map: npt.NDArray[np.int32],
                   given: Given) -> npt.NDArray[np.int32]:
    """The given vertices come first, also those that were merged into others; then the new ones."""
    count, points = len(given.points), len(number)
    is_mapped = np.flatnonzero(point_map >= 0)[::-1]
    numbers = np.full(points, -1, dtype=np.int32)
    numbers[point_map[is_mapped]] = is_mapped  # the first of several vertices is written last
    is_new = numbers < 0
    numbers[is_new] = count + np.arange(np.count_nonzero(is_new))
    attributes = given.per_row("vertex_attributes", count, "vertex")
    markers = given.markers("vertex_markers", count, "vertex")
    own: Dictionary = dict(vertices=given.points)
    if attributes is not None:
        own["vertex_attributes"] = attributes
    if markers is not None:
        own["vertex_markers"] = markers.reshape(-1, 1)
    for key, rows in vertices.items():
        all_rows = np.zeros((count + np.count_nonzero(is_new), rows.shape[1]), dtype=rows.dtype)
        if key in own:
            all_rows[:count] = own[key]
        all_rows[numbers] = rows
        vertices[key] = all_rows
    return numbers


def _without_unused(vertices: Dictionary, number: npt.NDArray[np.int32], mesh: Mesh) -> npt.NDArray[np.int32]:
    """Leaves out the vertices in no triangle; their number is -1."""
    used = np.unique(number[mesh.triangles])
    order = np.full(len(vertices["vertices"]), -1, dtype=np.int32)
    order[used] = np.arange(len(used))
    for key, rows in vertices.items():
        vertices[key] = rows[used]
    return order[number]


def _with_middles(vertices: Dictionary, triangles: npt.NDArray[Any], edges: npt.NDArray[Any],
                  markers: npt.NDArray[np.int32]) -> npt.NDArray[Any]:
    """Six nodes per triangle: the fourth to the sixth are in the middle of the sides opposite the first three."""
    first = len(vertices["vertices"])
    keys = np.sort(edges, axis=1).astype(np.int64) @ np.array([first, 1])
    order = np.argsort(keys)
    middles = []
    for a, b in ((1, 2), (2, 0), (0, 1)):
        side = np.sort(triangles[:, [a, b]], axis=1).astype(np.int64) @ np.array([first, 1])
        middles.append(first + order[np.searchsorted(keys, side, sorter=order)])
    for key, rows in vertices.items():
        new = markers.reshape(-1, 1) if key == "vertex_markers" else rows[edges].mean(axis=1)
        vertices[key] = np.concatenate([rows, new])
    return np.column_stack([triangles, *middles]).astype(np.int32)
