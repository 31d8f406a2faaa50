"""Faults that are put into right meshes. Each makes the mesh wrong for its domain, as exact tests here make sure."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt
from hypothesis import assume
from hypothesis import strategies as st

from .._mesh import Mesh
from ..domain import Domain
from ..meshing import mesh
from .shapes import Place, turn

Points = npt.NDArray[np.float64]
Triangles = npt.NDArray[np.int64]
Arrays = Tuple[Points, Triangles]
ANGLE = 20.7  # the bound that a mesh with the fault small_angle does not keep, in degrees
# Puts a fault into copies of the arrays of a mesh; None if this mesh has no place for it.
Fault = Callable[[st.DrawFn, Domain, Mesh], Optional[Arrays]]


def _arrays(right: Mesh) -> Arrays:
    return right.points.copy(), right.triangles.astype(np.int64)


def _pick(draw: st.DrawFn, count: int) -> int:
    return draw(st.integers(0, count - 1))


def _places(points: Points, *corners: int) -> List[Place]:
    return [(float(points[k, 0]), float(points[k, 1])) for k in corners]


def _is_fat(a: Place, b: Place, c: Place) -> bool:
    """Whether a triangle is far wider than rounded coordinates allow a vertex to be beside its segment.

    Faults of thinner triangles would be none: a mesh may leave out what rounding errors make.
    """
    sides = [float(np.hypot(q[0] - p[0], q[1] - p[1])) for p, q in ((a, b), (b, c), (c, a))]
    twice = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    return twice > max(sides) * (1e-9 * max(sides) + 2.0**-46 * max(abs(number) for p in (a, b, c) for number in p))


def _fat_one(draw: st.DrawFn, points: Points, triangles: Triangles) -> int:
    """One of the triangles that are fat."""
    fat = [k for k, corners in enumerate(triangles.tolist()) if _is_fat(*_places(points, *corners))]
    assume(fat)
    return fat[_pick(draw, len(fat))]


def _in_circle(a: Place, b: Place, c: Place, d: Place) -> bool:
    """Whether d is strictly inside the circle through a, b, c, which turn to the left. Exact."""
    x, y = Fraction(d[0]), Fraction(d[1])
    (ax, ay), (bx, by), (cx, cy) = ((Fraction(p[0]) - x, Fraction(p[1]) - y) for p in (a, b, c))
    return (ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) + \
        (cx * cx + cy * cy) * (ax * by - bx * ay) > 0


def _flips(right: Mesh, constrained: bool) -> List[Tuple[int, int, int, int, int, int]]:
    """The edges that can be flipped: two triangles, and the corners a, b of the edge, c and d across it."""
    points, triangles = _arrays(right)
    walls = {frozenset(ends) for ends in right.segments.tolist()}
    found = []
    for first, beside in enumerate(right.neighbors.tolist()):
        for k, second in enumerate(beside):
            c, a, b = (int(triangles[first, (k + step) % 3]) for step in range(3))
            if second <= first or (frozenset((a, b)) in walls) != constrained:
                continue
            (d,) = set(triangles[second].tolist()) - {a, b}
            at_a, at_b, at_c, at_d = _places(points, a, b, c, d)
            if turn(at_c, at_a, at_d) > 0 and turn(at_c, at_d, at_b) > 0 and \
                    _is_fat(at_c, at_a, at_d) and _is_fat(at_c, at_d, at_b):
                found.append((first, second, a, b, c, d))
    return found


def _flipped(draw: st.DrawFn, right: Mesh, flips: List[Tuple[int, int, int, int, int, int]]) -> Optional[Arrays]:
    if not flips:
        return None
    points, triangles = _arrays(right)
    first, second, a, b, c, d = flips[_pick(draw, len(flips))]
    triangles[first], triangles[second] = (c, a, d), (c, d, b)
    return points, triangles


def _edge_flipped(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points = right.points
    return _flipped(draw, right, [flip for flip in _flips(right, False)
                                  if _in_circle(*_places(points, flip[4], flip[2], flip[5], flip[3]))])


def _segment_ignored(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    return _flipped(draw, right, _flips(right, True))


def _hole_filled(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    if not len(domain.holes):
        return None
    holes = np.delete(domain.holes, _pick(draw, len(domain.holes)), axis=0)
    filled = mesh(domain.points, domain.segments, holes=holes, min_angle=0, threads=1)
    return _arrays(filled) if filled.area() > right.area() * (1 + 1e-9) else None


def _point_moved(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points, triangles = _arrays(right)
    which, axis = np.unique(triangles[triangles < len(domain.points)]), draw(st.integers(0, 1))
    vertex, bits = int(which[_pick(draw, len(which))]), draw(st.integers(0, 52))
    points[vertex, axis] += max(1.0, abs(points[vertex, axis])) * 2.0**-bits
    return points, triangles


def _gap(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points, triangles = _arrays(right)
    return points, np.delete(triangles, _fat_one(draw, points, triangles), axis=0)


def _clockwise(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points, triangles = _arrays(right)
    which = np.full(len(triangles), draw(st.booleans()))
    which[_fat_one(draw, points, triangles)] = True
    triangles[which] = triangles[which, ::-1]
    return points, triangles


def _triangle_doubled(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points, triangles = _arrays(right)
    again = np.roll(triangles[_pick(draw, len(triangles))], draw(st.integers(0, 2)))
    return points, np.vstack([triangles, again])


def _small_angle(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    """Of domains without an angle below 60 degrees between segments: no small angle is unavoidable."""
    coarse = mesh(domain, min_angle=0, threads=1)
    return _arrays(coarse) if coarse.quality().min_angle < ANGLE - 1e-3 else None


def _far_point(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    """One more triangle, on an edge of the convex hull."""
    points, triangles = _arrays(right)
    boundary = [(int(triangles[t, k - 2]), int(triangles[t, k - 1])) for t, k in np.argwhere(right.neighbors < 0)]
    outer = [(a, b) for a, b in boundary if all(turn(*_places(points, a, b, k)) >= 0 for k in range(len(points)))]
    if not outer:
        return None
    a, b = outer[_pick(draw, len(outer))]
    along = points[b] - points[a]
    far = (points[a] + points[b]) / 2 + draw(st.sampled_from([10.0, 1000.0, 1e9])) * np.array([along[1], -along[0]])
    return np.vstack([points, far]), np.vstack([triangles, (b, a, len(points))])


def _triangles_cross(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    """One triangle gets a corner elsewhere, on the same side of its edge, so it is not what the others leave free."""
    points, triangles = _arrays(right)
    which = _fat_one(draw, points, triangles)
    a, b, c = (int(corner) for corner in np.roll(triangles[which], draw(st.integers(0, 2))))
    size = np.hypot(*np.ptp(points, axis=0)) + 1e-3 * np.abs(points).max()
    others = [d for d in range(len(points)) if np.hypot(*(points[d] - points[c])) > 1e-9 * size and
              turn(*_places(points, a, b, d)) > 0]
    if not others:
        return None
    triangles[which] = a, b, others[_pick(draw, len(others))]
    return points, triangles


def _bad_index(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points, triangles = _arrays(right)
    triangles[_pick(draw, len(triangles)), draw(st.integers(0, 2))] = draw(st.sampled_from([len(points), -1, 2**31]))
    return points, triangles


def _not_a_number(draw: st.DrawFn, domain: Domain, right: Mesh) -> Optional[Arrays]:
    points, triangles = _arrays(right)
    points[triangles[_pick(draw, len(triangles)), 0], draw(st.integers(0, 1))] = draw(
        st.sampled_from([float("nan"), float("inf")]))
    return points, triangles


# By name: the fault, and the families of domains that have places for it.
PLANTED: Dict[str, Tuple[Fault, Any]] = {
    "hole_filled": (_hole_filled, ("holes",)),
    "segment_ignored": (_segment_ignored, ("regions", "cracks")),
    "point_moved": (_point_moved, ()),
    "edge_flipped": (_edge_flipped, ()),
    "gap": (_gap, ()),
    "clockwise": (_clockwise, ()),
    "triangle_doubled": (_triangle_doubled, ()),
    "small_angle": (_small_angle, None),
    "far_point": (_far_point, ()),
    "triangles_cross": (_triangles_cross, ()),
    "bad_index": (_bad_index, ()),
    "not_a_number": (_not_a_number, ()),
}
FAULTS: Tuple[str, ...] = tuple(PLANTED)
