"""Meshes for meshio, SciPy and matplotlib. These packages are needed only when they are asked for."""

from __future__ import annotations

import importlib
from typing import Any, Dict, List, Tuple

import numpy as np
import numpy.typing as npt

from . import _pardel
from .errors import UsageError

Indices = npt.NDArray[np.int32]


def _package(name: str, what: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise UsageError(f"{what} needs the package {name.split('.')[0]}, which is not installed") from None


def to_meshio(mesh: Any) -> Any:
    meshio = _package("meshio", "to_meshio()")
    cells = [("triangle", np.ascontiguousarray(mesh.triangles)), ("line", np.ascontiguousarray(mesh.segments))]
    at_points, in_cells = _point_data(mesh), _cell_data(mesh)
    for name, is_at_points, components, values, _ in _pardel.fields_of(mesh._core):
        rows = values if components == 1 else values.reshape(-1, components)
        if is_at_points:
            at_points.setdefault(name, rows)
        else:
            lines = np.full((len(mesh.segments), *rows.shape[1:]), np.nan)
            in_cells.setdefault(name, [rows, lines])
    if not len(mesh.segments):
        cells, in_cells = cells[:1], {name: blocks[:1] for name, blocks in in_cells.items()}
    return meshio.Mesh(np.ascontiguousarray(mesh.points), cells, point_data=at_points, cell_data=in_cells)


def _point_data(mesh: Any) -> Dict[str, npt.NDArray[Any]]:
    data: Dict[str, npt.NDArray[Any]] = {"marker": np.ascontiguousarray(mesh.point_markers)}
    if mesh.attributes.shape[1]:
        data["attributes"] = np.ascontiguousarray(mesh.attributes)
    return data


def _cell_data(mesh: Any) -> Dict[str, List[npt.NDArray[Any]]]:
    data: Dict[str, List[npt.NDArray[Any]]] = {
        "marker": [np.zeros(len(mesh.triangles), np.int32), np.ascontiguousarray(mesh.segment_markers)]}
    if len(mesh.regions):
        attribute = np.append(mesh.region_attributes, 0.0)[mesh.regions]  # -1, no region, is the last one
        data["region"] = [attribute, np.zeros(len(mesh.segments))]
    return data


def to_matplotlib(mesh: Any) -> Any:
    triangulation = _package("matplotlib.tri", "to_matplotlib()").Triangulation
    x, y = np.ascontiguousarray(mesh.points.T)
    return triangulation(x, y, np.ascontiguousarray(mesh.triangles))


def neighbours_of_points(mesh: Any) -> Tuple[Indices, Indices, npt.NDArray[np.intp]]:
    """Rows of a sparse matrix: where each point's row starts, the points at the other ends of its edges in ascending
    order, and the edge of each entry."""
    edges = np.ascontiguousarray(mesh.edges)
    sources, targets = np.concatenate([edges, edges[:, ::-1]]).T
    order = np.lexsort((targets, sources))
    starts = np.zeros(len(mesh.points) + 1, np.int32)
    np.cumsum(np.bincount(sources, minlength=len(mesh.points)), out=starts[1:])
    return starts, np.ascontiguousarray(targets[order]), order % max(len(edges), 1)


def adjacency(mesh: Any, lengths: bool) -> Any:
    csr_array = getattr(_package("scipy.sparse", "adjacency()"), "csr_array", None)
    if csr_array is None:
        raise UsageError("adjacency() needs SciPy 1.8 or later")
    starts, targets, edge = neighbours_of_points(mesh)
    values: npt.NDArray[Any] = np.ones(len(targets), np.int32)
    if lengths:
        ends = mesh.points[mesh.edges]
        values = np.hypot(*(ends[:, 0] - ends[:, 1]).T)[edge]
    return csr_array((values, targets, starts), shape=(len(mesh.points), len(mesh.points)))
