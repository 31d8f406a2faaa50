"""The mesher: quality meshes, refinement, Delaunay triangulations."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from ._mesh import Mesh
from .domain import DomainLike, domain_of
from .goal import Size, Test, goal_of, has_caps, sizes_of, test_of
from .mesh_like import mesh_of
from .progress import Progress, reporting
from .scalars import number, whole
from .sources import SourcesLike, sources_of


def _options(*, threads: int, max_vertices: int, max_memory: int, min_edge: float,
             placement: str, interior: str, split_boundary: bool, split_segments: bool) -> _pardel.Options:
    options = _pardel.Options()
    options.threads = whole("threads", threads)
    options.max_vertices = whole("max_vertices", max_vertices)
    options.max_memory = int(max_memory)
    options.min_edge = number("min_edge", min_edge)
    options.no_boundary_splits, options.no_segment_splits = not split_boundary, not split_segments
    options.set_placement(placement)
    options.set_interior(interior)
    return options


def mesh(points: DomainLike, segments: Optional[npt.ArrayLike] = None, *, holes: Optional[npt.ArrayLike] = None,
         regions: Optional[npt.ArrayLike] = None, markers: Optional[npt.ArrayLike] = None,
         point_markers: Optional[npt.ArrayLike] = None, attributes: Optional[npt.ArrayLike] = None,
         min_angle: float = 20.7, max_area: Optional[float] = None, max_edge: Optional[float] = None,
         size: Optional[Size] = None, sources: Optional[SourcesLike] = None, refine_if: Optional[Test] = None,
         grading: Optional[float] = None, feature_size: Optional[float] = None, conforming: bool = False,
         convex_hull: bool = False, threads: int = 0, max_vertices: int = 0, max_memory: int = 0, min_edge: float = 0,
         placement: str = "off_centre", interior: str = "refine", split_boundary: bool = True,
         split_segments: bool = True, repair: bool = False, snap: Optional[float] = None,
         progress: Progress = None) -> Mesh:
    """Makes a quality mesh: a constrained Delaunay triangulation, refined until every triangle keeps the bounds.

    The domain
      points: shape (n, 2), any unit; or a `Domain`, the path of a file, or geometries (see `geometry`), which have the
        following arguments.
      segments: shape (m, 2): indices of points. None: the domain is the convex hull of the points.
      holes, regions, markers, point_markers, attributes: as for `Domain`. Areas of regions are bounds.

    The bounds
      min_angle: the least angle in degrees, from 0 (none) to 33, or to 45 with max_vertices. Triangles beside a small
        angle of the domain may have smaller ones; ``report.exempt`` lists them.
      max_area: the largest area, in the square of the unit. max_edge: the longest edge, in the unit.
      size: the longest edge near a place, in the unit:
        a number; or an array of shape (n,), one length per point, interpolated over the domain;
        or (mesh, lengths), one length per point of a mesh that covers the domain;
        or a `Raster`, or its values with their extent or transform as a tuple;
        or the path of a file, as for the program's option ``--sizes``: a raster .asc or .npy, a mesh with lengths at
        its points, or one length per point of the domain;
        or a function of an array of places, shape (k, 2), that returns k lengths;
        or a function of two numbers x and y that returns a length.
        A function must be pure: what it returns for a place depends on nothing else. The mesher asks about three
        times per triangle, and works on one thread, because Python does. Arrays have the places of one insertion (k is
        mostly 4 to 10), so functions of x and y cost less. Lengths at points, also of a coarse mesh, cost least and
        are for all threads.
      refine_if: a function of the corners of a triangle, shape (3, 2), and its area. Triangles for which it returns
        True are refined. It must be pure, and is asked about each triangle that the mesher makes, and about reduced
        copies of some. The corners are counter-clockwise, from that with the least x. If it is True for every triangle,
        however small, only min_edge or max_vertices ends the run; ``report.fail_test`` counts the triangles that are
        left.
      grading: lengths grow by at most this number per unit of distance, from segments, from lengths in arrays, and from
        `sources`: `Sources`, the path of their file, geometries with a length, rows of x, y and length, or a dict of
        lengths by marker.
      feature_size: at least this number of edges across narrow places.
      conforming: every edge is Delaunay, those on segments, too. convex_hull: the domain is the convex hull.

    The run
      threads: 0: one per core; always one if size or refine_if is a function. The mesh does not depend on it.
      max_vertices: no point is inserted beyond this number; 0: no limit. max_memory: bytes; 0: no limit.
      min_edge: no edge becomes shorter, in the unit. placement: ``off_centre``, ``circumcentre``, ``search``,
      ``automatic``. interior: ``refine``, ``fill``, ``automatic``. split_boundary, split_segments: False: segments on
      the boundary, or all, stay whole.
      repair: True: duplicate points, crossing segments and tiny gaps are mended first; snap: the width of gaps that are
        closed, in the unit, which means repair.
      progress: a function of the number of triangles and the estimated final number (0: not known), called about ten
        times per second; the run ends with `Cancelled` if it returns False. True: a bar of tqdm.

    The interpreter lock is released. Ctrl-C ends the run at once. Exceptions of functions reach the caller unchanged.
    Raises `UsageError`; `InvalidInput` with ``problems`` if the domain cannot be meshed; `ResourceError`.

    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> made = mesh(square, [(0, 1), (1, 2), (2, 3), (3, 0)], min_angle=30, max_area=0.01)
    >>> made.report.goal_met, round(made.area(), 12)
    (True, 1.0)
    """
    domain = domain_of(points, segments, holes=holes, regions=regions, markers=markers, point_markers=point_markers,
                       attributes=attributes)
    goal = goal_of(min_angle=min_angle, max_area=max_area, max_edge=max_edge, size=size, grading=grading,
                   feature_size=feature_size, conforming=conforming, convex_hull=convex_hull,
                   region_caps=has_caps(domain))
    options = _options(threads=threads, max_vertices=max_vertices, max_memory=max_memory,
                       min_edge=min_edge, placement=placement, interior=interior, split_boundary=split_boundary,
                       split_segments=split_segments)
    distance = None if snap is None else number("snap", snap)
    sizes = sizes_of(size, len(domain.points))
    places = sources_of(sources, grading)
    if places is not None:
        sizes.set_places(places)
    with reporting(progress) as report:
        made = _pardel.mesh(domain._core, goal, options, sizes,
                            repair or snap is not None, distance, report, test_of(refine_if))
    return Mesh._of(*made)


def refine(mesh: Any, *, max_areas: Optional[npt.ArrayLike] = None, min_angle: float = 20.7,
           max_area: Optional[float] = None, max_edge: Optional[float] = None, size: Optional[Size] = None,
           refine_if: Optional[Test] = None, conforming: bool = False, threads: int = 0, max_vertices: int = 0,
           max_memory: int = 0, min_edge: float = 0, placement: str = "off_centre", split_boundary: bool = True,
           split_segments: bool = True, progress: Progress = None) -> Mesh:
    """Refines a mesh of any program. Its vertices, its boundary and its constrained edges stay.

    mesh: a `Mesh`; (points, triangles); anything with ``points`` and ``cells``; or the path of a file.
    max_areas: shape (m,): the largest area in what each triangle covers, in the square of the unit; inf: no bound.
    size, refine_if: as for `mesh`; an array has one length per point of this mesh. The other arguments are those of
    `mesh`.
    Raises `UsageError`; `InvalidInput` if a triangle is not counter-clockwise, or the mesh is not a manifold.

    >>> coarse = ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])
    >>> finer = refine(coarse, max_area=0.1)
    >>> len(finer.triangles) >= 10
    True
    """
    coarse = mesh_of(mesh)
    goal = goal_of(min_angle=min_angle, max_area=max_area, max_edge=max_edge, size=size, grading=None,
                   feature_size=None, conforming=conforming, convex_hull=False, region_caps=False)
    options = _options(threads=threads, max_vertices=max_vertices, max_memory=max_memory,
                       min_edge=min_edge, placement=placement, interior="refine", split_boundary=split_boundary,
                       split_segments=split_segments)
    caps = np.empty(0) if max_areas is None else arrays.one_per("max_areas", max_areas, len(coarse.triangles),
                                                                "triangle")
    with reporting(progress) as report:
        made = _pardel.refine(coarse._core, caps, goal, options, sizes_of(size, len(coarse.points), coarse), report,
                              test_of(refine_if))
    return Mesh._of(*made)


def delaunay(points: DomainLike, segments: Optional[npt.ArrayLike] = None, *, threads: int = 0,
             **parts: Any) -> Mesh:
    """The Delaunay triangulation of points; with segments the constrained one. No point is added.

    points, segments, and the arguments of `Domain`: as for `mesh`. Raises `InvalidInput`, for example for equal points.

    >>> delaunay([(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.5)])
    Mesh(5 points, 4 triangles)
    """
    return mesh(points, segments, min_angle=0, threads=threads, **parts)


def convex_hull(points: npt.ArrayLike) -> npt.NDArray[np.int32]:
    """The indices of the points on the convex hull, counter-clockwise from the leftmost (of these, the lowest) one.

    points: shape (n, 2). Points on the sides of the hull are listed, too. Exact. O(n log n).
    Raises `InvalidInput` for equal points, or if all points are on one line.

    >>> convex_hull([(0, 0), (2, 0), (1, 1), (2, 2), (0, 2)]).tolist()
    [0, 1, 3, 4]
    """
    hull = delaunay(arrays.numbers("points", points, 2))
    triangle, corner = np.nonzero(hull.neighbors == -1)
    after = dict(zip(hull.triangles[triangle, (corner + 1) % 3].tolist(),
                     hull.triangles[triangle, (corner + 2) % 3].tolist()))
    first = min(after, key=lambda index: tuple(hull.points[index]))
    order = [first]
    while after[order[-1]] != first:
        order.append(after[order[-1]])
    return np.array(order, dtype=np.int32)
