"""`build` and `refine`: meshes of the domain, or of the triangles, in a `MeshInfo`."""

from __future__ import annotations

import warnings
from typing import Any, Callable, Dict, NamedTuple, Optional, Tuple

import numpy as np

from ...errors import UsageError
from ...goal import Test
from ...scalars import number
from ..triangle.given import Given
from ..triangle.meshing import Made, meshed, refined
from ..triangle.result import dictionary
from ..triangle.switches import Switches
from .mesh_info import MeshInfo


class Vertex(NamedTuple):
    """A corner of a triangle."""

    x: float
    y: float


Vertices = Tuple[Vertex, Vertex, Vertex]
RefinementFunction = Callable[[Vertices, float], Any]

_FIELDS = {"points": "vertices", "point_attributes": "vertex_attributes", "point_markers": "vertex_markers",
           "facets": "segments", "facet_markers": "segment_markers", "holes": "holes", "regions": "regions"}
_FIELDS_OF_ELEMENTS = {"elements": "triangles", "element_attributes": "triangle_attributes",
                       "element_volumes": "triangle_max_area"}
_FIELDS_OF_RESULTS = {"points": "vertices", "point_attributes": "vertex_attributes", "point_markers": "vertex_markers",
                      "elements": "triangles", "element_attributes": "triangle_attributes", "neighbors": "neighbors",
                      "facets": "segments", "facet_markers": "segment_markers", "faces": "edges",
                      "face_markers": "edge_markers"}


def build(mesh_info: MeshInfo, verbose: bool = False, refinement_func: Optional[RefinementFunction] = None,
          attributes: bool = False, volume_constraints: bool = False, max_volume: Optional[float] = None,
          allow_boundary_steiner: bool = True, allow_volume_steiner: bool = True, quality_meshing: bool = True,
          generate_edges: Optional[bool] = None, generate_faces: bool = False, min_angle: Optional[float] = None,
          mesh_order: Optional[int] = None, generate_neighbor_lists: bool = False) -> MeshInfo:
    """Meshes what the facets enclose, without the holes. Without facets, the convex hull of the points.

    refinement_func: a function of three corners, each with ``x`` and ``y``, and of the area; triangles for which it
        returns True are refined. Its exceptions reach the caller.
    attributes: element_attributes are those of the regions, 0 elsewhere. volume_constraints: the fourth number of a
        region is the largest area of its triangles. max_volume: the largest area everywhere.
    allow_boundary_steiner: False: facets on the boundary stay whole. allow_volume_steiner: False: all facets do.
    quality_meshing: angles are at least min_angle, 20 degrees without a number. generate_faces: faces are all edges.
    mesh_order: 2: elements have six points; the last three are in the middle of the sides opposite the first three.
    verbose, generate_neighbor_lists: no effect; nothing is printed, and neighbors are always there.
    Raises `UsageError` and `InvalidInput`, which are a ValueError; TypeError for something else than a MeshInfo.

    >>> info = MeshInfo()
    >>> info.set_points([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)])
    >>> build(info, refinement_func=lambda vertices, area: area > 0.1)
    MeshInfo(13 points, 16 elements, 8 facets)
    """
    _require_info("mesh_info", mesh_info)
    if not allow_volume_steiner and allow_boundary_steiner:
        raise UsageError("allow_volume_steiner is False, which needs allow_boundary_steiner=False, too")
    if generate_edges is not None:
        warnings.warn("generate_edges is an old name of generate_faces", stacklevel=2)
        generate_faces = generate_edges
    if mesh_order not in (None, 1, 2):
        raise UsageError(f"mesh_order is {mesh_order!r}; 1 or 2 is needed")
    switches = _switches(refinement_func, quality_meshing, min_angle)
    switches.poly = len(mesh_info.facets) > 0
    switches.region_attributes, switches.areas = bool(attributes), bool(volume_constraints)
    if max_volume:
        switches.max_area = number("max_volume", max_volume)
    switches.quality = switches.quality or switches.areas or switches.max_area is not None
    switches.splits = 2 if not allow_volume_steiner else int(not allow_boundary_steiner)
    switches.edges, switches.second_order = bool(generate_faces), mesh_order == 2
    given = Given(_given(mesh_info, _FIELDS))
    return _result(meshed(given, switches), given, switches)


def refine(input_p: MeshInfo, verbose: bool = False, refinement_func: Optional[RefinementFunction] = None,
           quality_meshing: bool = True, min_angle: Optional[float] = None,
           generate_neighbor_lists: bool = False) -> MeshInfo:
    """Refines a mesh that `build` or `refine` has made. Its points stay, and come first.

    The largest area in what each element covers is that in element_volumes, if it has been set up; a number that is not
    positive means no bound. The facets stay, and their markers. The other arguments are those of `build`.
    """
    _require_info("input_p", input_p)
    switches = _switches(refinement_func, quality_meshing, min_angle)
    switches.refine, switches.poly = True, len(input_p.facets) > 0
    switches.areas = input_p.element_volumes.allocated
    if len(input_p.elements) == 0:
        raise UsageError("input_p has no elements to refine; build makes a mesh")
    given = Given(_given(input_p, {**_FIELDS, **_FIELDS_OF_ELEMENTS}))
    return _result(refined(given, switches), given, switches)


def _switches(function: Optional[RefinementFunction], quality: bool, min_angle: Optional[float]) -> Switches:
    """What Triangle's switches for a call of `build` or `refine` have in common."""
    switches = Switches(jettison=True, neighbors=True, refine_if=_test(function))
    if quality:
        switches.min_angle = 20.0 if min_angle is None else number("min_angle", min_angle)
    switches.quality = quality or function is not None
    return switches


def _test(function: Optional[RefinementFunction]) -> Optional[Test]:
    if function is None:
        return None
    if not callable(function):
        raise UsageError(f"refinement_func is {function!r}; a function of the vertices and the area is needed")
    asked = function

    def test(corners: Any, area: float) -> bool:
        a, b, c = corners.tolist()
        answer = asked((Vertex(*a), Vertex(*b), Vertex(*c)), area)
        if answer is None:
            raise TypeError("refinement_func returned None; it must return True or False")
        return bool(answer)

    return test


def _require_info(name: str, info: Any) -> None:
    if not isinstance(info, MeshInfo):
        raise TypeError(f"{name} is a {type(info).__name__}; a MeshInfo is needed, with set_points and set_facets")


def _given(info: MeshInfo, fields: Dict[str, str]) -> Dict[str, Any]:
    return {key: np.array(getattr(info, name)) for name, key in fields.items() if getattr(info, name).allocated}


def _result(made: Made, given: Given, switches: Switches) -> MeshInfo:
    found, info = dictionary(made, given, switches), MeshInfo()
    for name, key in _FIELDS_OF_RESULTS.items():
        if key not in found:
            continue
        rows, array = found[key], getattr(info, name)
        array.set_unit(rows.shape[1])
        array.set_all(rows[:, 0] if rows.shape[1] == 1 else rows)
    return info
