"""Arguments that stand for a mesh."""

from __future__ import annotations

import os
from typing import Any, Tuple

import numpy as np

from . import _pardel
from ._mesh import Mesh
from .errors import UsageError
from .paths import read_as


def mesh_of(value: Any) -> Mesh:
    """The mesh that an argument stands for: a `Mesh`, the path of a file, (points, triangles), or a mesh of meshio."""
    if isinstance(value, Mesh):
        return value
    if isinstance(value, (str, os.PathLike)):
        return Mesh._of(read_as(_pardel.HeldMesh, value, "a domain", "a mesh"))
    if hasattr(value, "points") and hasattr(value, "cells"):
        return _of_cells(value.points, value.cells)
    if isinstance(value, (tuple, list)) and len(value) == 2:
        return Mesh(value[0], value[1])
    raise UsageError(f"a mesh is needed: a Mesh, a path, (points, triangles), or an object with points and cells; "
                     f"this is a {type(value).__name__}")


def _of_cells(points: Any, cells: Any) -> Mesh:
    """The triangles of a mesh of meshio; a third coordinate is left out."""
    blocks = cells.items() if isinstance(cells, dict) else [_type_and_data(block) for block in cells]
    corners = [np.asarray(data)[:, :3] for kind, data in blocks if kind in ("triangle", "triangle6")]
    unusable = sorted({kind for kind, _ in blocks} - {"triangle", "triangle6", "line", "line3", "vertex"})
    if unusable:
        raise UsageError(f"the mesh has cells of the type {unusable[0]}; triangles are needed")
    if not corners:
        raise UsageError("the mesh has no triangles")
    places = np.asarray(points)
    return Mesh(places[:, :2] if places.ndim == 2 else places, np.concatenate(corners))


def _type_and_data(block: Any) -> Tuple[str, Any]:
    return (block.type, block.data) if hasattr(block, "data") else (block[0], block[1])
