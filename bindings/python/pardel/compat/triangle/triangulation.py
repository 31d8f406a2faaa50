"""`triangulate`: all that Triangle does, as its switches say."""

from __future__ import annotations

from typing import Any, Mapping

from .given import Given
from .meshing import meshed, refined
from .result import Dictionary, dictionary
from .switches import parsed


def triangulate(tri: Mapping[str, Any], opts: str = "") -> Dictionary:
    """Triangulates, meshes or refines, as the switches of Triangle say.

    tri: a dictionary.
      vertices: shape (n, 2), n >= 3; vertex_attributes: shape (n, k); vertex_markers: shape (n, 1) or (n,).
      With p: segments: shape (s, 2); segment_markers: shape (s, 1) or (s,); holes: shape (h, 2); regions: shape (r, 4):
        x, y, attribute, largest area.
      With r: triangles: shape (m, 3) or (m, 6), counter-clockwise; triangle_attributes: shape (m, k);
        triangle_max_area: shape (m, 1) or (m,), used by the switch a without a number.
    opts: the switches, without spaces:
      p: the domain is what the segments enclose, without the holes; without p the convex hull.
      r: refines triangles. q: smallest angle, 20 degrees or the number after it. a: largest area: the number after it;
        without a number those of the regions, or triangle_max_area. D: conforming Delaunay. c: the convex hull.
      A: triangle_attributes are those of regions. e: edges. n: neighbors. o2: six nodes. j: no unused vertices.
      Y, YY: segments of the boundary, or all, are not split. S: the largest number of new vertices. O: no holes.
      B, P, N, E: no markers, segments, vertices, triangles. C: pardel's exact check.

    Returns a dictionary of new arrays: vertices, triangles and their attributes and markers, and with p or c segments
    and segment_markers, with p holes and regions. A key without rows is absent.

    Raises `UsageError`, which is a ValueError, for a wrong switch or array, and `InvalidInput`, which is one, too, if
    the domain cannot be meshed. Points that coincide and segments that cross are no error, as in Triangle.

    >>> square = [[0, 0], [0, 1], [1, 1], [1, 0]]
    >>> mesh = triangulate({"vertices": square}, "a0.2")
    >>> mesh["vertices"].shape, mesh["triangles"].shape, mesh["vertex_markers"].ravel().tolist()
    ((9, 2), (8, 3), [1, 1, 1, 1, 0, 1, 1, 1, 1])
    """
    switches = parsed(opts)
    given = Given(tri)
    made = refined(given, switches) if switches.refine else meshed(given, switches)
    return dictionary(made, given, switches)
