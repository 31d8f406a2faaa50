"""The meshes that the switches ask for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, Optional

import numpy as np
import numpy.typing as npt

from ... import _pardel, checking, meshing
from ..._mesh import Mesh
from ...domain import Domain
from ...errors import InternalError, InvalidInput, UsageError
from ...validation import repair
from .given import Given
from .switches import Switches

# Above this angle the mesher needs a limit on the number of points.
_SURE_ANGLE = 33.0


@dataclass
class Made:
    """A mesh.

    point_map: the point of the mesh for each given vertex, if the numbers differ. triangle_attributes: shape (m, k).
    """

    mesh: Mesh
    point_map: Optional[npt.NDArray[np.int32]] = None
    triangle_attributes: Optional[npt.NDArray[np.float64]] = None


def meshed(given: Given, switches: Switches) -> Made:
    """The mesh of the domain."""
    domain = _domain(given, switches)
    convex_hull = switches.convex_hull or not switches.poly
    point_map = None
    try:
        mesh = _mesh_of(domain, switches, convex_hull)
    except InvalidInput as error:
        if not error.problems:
            raise
        # Like Triangle: equal points become one, and segments that cross get a common point.
        repaired = repair(domain, snap=0, convex_hull=convex_hull)
        domain, point_map = repaired.domain, repaired.point_map
        mesh = _mesh_of(domain, switches, convex_hull)
    if switches.check:
        _check(domain, mesh, switches, convex_hull)
    made = Made(mesh, point_map)
    if switches.region_attributes and len(given.rows("regions", 4)):
        values = np.append(mesh.region_attributes, 0.0)  # the last one is that of no region
        rows = mesh.regions if len(mesh.regions) else np.full(len(mesh.triangles), -1)
        made.triangle_attributes = values[rows].reshape(-1, 1)
    return made


def _mesh_of(domain: Domain, switches: Switches, convex_hull: bool) -> Mesh:
    if not switches.quality:
        return meshing.mesh(domain, convex_hull=convex_hull, min_angle=0)

    def run(**bounds: Any) -> Mesh:
        return meshing.mesh(domain, convex_hull=convex_hull, interior="automatic", **bounds)

    return _for_angle(run, switches, len(domain.points))


def refined(given: Given, switches: Switches) -> Made:
    """The mesh that is given, refined."""
    corners = given.triangles()
    count = len(corners)
    segments = given.indices("segments") if switches.poly else np.empty((0, 2), dtype=np.int64)
    markers = given.markers("segment_markers", len(segments), "segment") if switches.poly else None
    point_markers = given.markers("vertex_markers", len(given.points), "vertex")
    attributes = given.per_row("vertex_attributes", len(given.points), "vertex")
    of_triangles = given.per_row("triangle_attributes", count, "triangle")
    rows, regions = np.empty((0, 0)), np.empty(0, dtype=np.int64)
    if of_triangles is not None:
        rows, regions = np.unique(of_triangles, axis=0, return_inverse=True)
    _check_segments(segments, corners, len(given.points))
    areas = given.per_row("triangle_max_area", count, "triangle") if switches.areas else None
    if switches.areas and areas is None:
        raise UsageError("opts has the switches r and a without a number, but tri has no triangle_max_area")
    caps = None if areas is None else np.where(areas[:, 0] > 0, areas[:, 0], np.inf)

    core = _pardel.with_parts(
        Mesh(given.points, corners)._core, segments,
        np.zeros(len(segments), dtype=np.int32) if markers is None else markers,
        np.empty(0, dtype=np.int32) if point_markers is None else point_markers,
        np.empty((len(given.points), 0)) if attributes is None else attributes,
        regions.reshape(-1), np.arange(len(rows), dtype=np.float64))

    def run(**bounds: Any) -> Mesh:
        return meshing.refine(Mesh._of(core), max_areas=caps, **bounds)

    mesh = _for_angle(run, switches, len(given.points))
    return Made(mesh, None, rows[mesh.regions] if of_triangles is not None else None)


def _domain(given: Given, switches: Switches) -> Domain:
    point_markers = given.markers("vertex_markers", len(given.points), "vertex")
    attributes = given.per_row("vertex_attributes", len(given.points), "vertex")
    if not switches.poly:
        return Domain(given.points, point_markers=point_markers, attributes=attributes)
    segments = given.indices("segments")
    if not len(segments) and not switches.convex_hull:
        raise UsageError("opts has the switch p, but tri has no segments; without p, or with the switch c, the convex "
                         "hull is meshed")
    regions = given.rows("regions", 4) if switches.region_attributes or switches.areas else np.empty((0, 4))
    if not switches.areas:
        regions = np.column_stack([regions[:, :3], np.full(len(regions), np.inf)])
    return Domain(given.points, segments, holes=None if switches.no_holes else given.rows("holes", 2), regions=regions,
                  markers=given.markers("segment_markers", len(segments), "segment"), point_markers=point_markers,
                  attributes=attributes)


def _for_angle(run: Callable[..., Mesh], switches: Switches, points: int) -> Mesh:
    """Above the sure angle: with at most six times as many points, and 1000 more, as the sure angle needs."""
    bounds: Dict[str, Any] = dict(
        min_angle=switches.min_angle, max_area=switches.max_area, refine_if=switches.refine_if,
        conforming=switches.conforming, split_boundary=switches.splits == 0, split_segments=switches.splits < 2,
        placement="automatic")
    if switches.max_new_points is not None:
        bounds["max_vertices"] = min(points + switches.max_new_points, 2**31 - 1)
    elif switches.min_angle > _SURE_ANGLE:
        sure = run(**{**bounds, "min_angle": _SURE_ANGLE})
        bounds["max_vertices"] = 6 * len(sure.points) + 1000
    mesh = run(**bounds)
    _check_goal(mesh, switches, bounds)
    return mesh


def _check_goal(mesh: Mesh, switches: Switches, bounds: Dict[str, Any]) -> None:
    """A bound may be missed beside a small angle of the domain, and because of the switches S and Y."""
    assert mesh.report is not None
    if mesh.report.goal_met:
        return
    missed = mesh.report.exempt_counts
    if "budget" in missed and switches.max_new_points is None:
        raise UsageError(f"opts: the smallest angle of {switches.min_angle:g} degrees needs more than "
                         f"{bounds['max_vertices']} vertices; up to {_SURE_ANGLE:g} degrees are sure, or give the "
                         f"switch S")
    for reason in ("precision", "min_edge"):
        if reason in missed:
            raise InvalidInput(f"{missed[reason]} triangles miss a bound, because no double splits them ({reason}); "
                               f"pardel.mesh returns such a mesh, and lists these triangles")


def _check(domain: Domain, mesh: Mesh, switches: Switches, convex_hull: bool) -> None:
    """The switch C. Bounds that S and Y let the mesh miss are left out."""
    assert mesh.report is not None
    met = mesh.report.goal_met
    certificate = checking.check(
        domain if met else Domain(domain.points, domain.segments, holes=domain.holes), mesh,
        min_angle=switches.min_angle if met else 0, max_area=switches.max_area if met else None,
        conforming=switches.conforming and met, convex_hull=convex_hull)
    if not certificate.valid:
        raise InternalError(f"the mesh is wrong: {certificate.violations[0]}")


def _check_segments(segments: npt.NDArray[np.int64], corners: npt.NDArray[np.int64], points: int) -> None:
    ends = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    wanted = np.sort(segments, axis=1)
    wrong = np.flatnonzero(~np.isin(wanted[:, 0] * points + wanted[:, 1], ends[:, 0] * points + ends[:, 1]))
    if wrong.size:
        raise UsageError(f"segments[{wrong[0]}] is {tuple(segments[wrong[0]].tolist())}, which is no edge of the "
                         f"triangles; the switch r needs the segments of the mesh that is refined")
