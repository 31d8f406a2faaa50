"""The exact checker, for meshes of any program."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

from . import _pardel
from .domain import DomainLike, domain_of
from .errors import Coordinates
from .goal import Size, Test, goal_of, has_caps, sizes_of, test_of
from .mesh_like import mesh_of
from .scalars import number, whole
from .sources import SourcesLike, sources_of


@dataclass(frozen=True)
class Violation:
    """One broken rule.

    kind: the rule, for example ``"not_delaunay"`` or ``"small_angle"``.
    ids: vertices, triangles, edges or segments, from 0; the text says which. coordinates: the places.
    text: one line with the exact witness.
    """

    kind: str
    ids: Tuple[int, ...]
    coordinates: Tuple[Coordinates, ...]
    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Extreme:
    """An extreme value over all triangles, the first triangle that attains it, and the place."""

    value: float
    triangle: int
    coordinates: Coordinates


@dataclass(frozen=True)
class Certificate:
    """The verdict of `check`. It is true in a condition if the mesh is valid.

    valid: no rule is broken. violations: at most ``max_violations`` of each kind; violation_counts: all, by kind.
    not_checked: what was not compared because the mesh or the domain lacks it, for example markers.
    extremes: ``min_angle``, ``max_angle`` (degrees), ``max_area``, ``max_edge``, ``min_edge``, ``max_circumradius``,
    ``max_radius_edge_ratio``. area: the exact sum, rounded once. justified: the number of triangles with a small angle
    that a small angle of the domain makes unavoidable. equilateral: triangles whose edges are equal up to a millionth.
    decided_exactly: triangles that needed exact arithmetic. angle_histogram: all angles in 18 bins of 10 degrees.
    text: the certificate as lines of text.
    """

    valid: bool
    violations: Tuple[Violation, ...]
    violation_counts: Dict[str, int]
    not_checked: Tuple[str, ...]
    extremes: Dict[str, Extreme]
    vertices: int
    triangles: int
    constrained_edges: int
    area: float
    justified: int
    equilateral: int
    decided_exactly: int
    angle_histogram: Tuple[int, ...]
    digest: str
    text: str

    def __bool__(self) -> bool:
        return self.valid

    def __str__(self) -> str:
        return self.text


def check(domain: DomainLike, mesh: Any, *, min_angle: float = 20.7, max_area: Optional[float] = None,
          max_edge: Optional[float] = None, size: Optional[Size] = None, sources: Optional[SourcesLike] = None,
          refine_if: Optional[Test] = None, grading: Optional[float] = None, feature_size: Optional[float] = None,
          conforming: bool = False, convex_hull: bool = False, max_circumradius: float = 0,
          max_violations: int = 1000) -> Certificate:
    """Proves in exact arithmetic that a mesh is right for a domain and keeps the bounds, or lists what is wrong.

    domain: a `Domain`, the path of a file, geometries, or an array of points whose convex hull is the domain.
    mesh: a `Mesh`; (points, triangles); anything with ``points`` and ``cells``, such as a mesh of meshio; or the path
        of a file. Neighbours, edges and markers of arrays are not checked, because arrays have none.
    The bounds mean what they mean in `mesh`, and have the same defaults; min_angle=0 asks for none. The areas of the
    domain's regions are bounds, too. max_circumradius: in the unit of the coordinates; 0: none.
    size: as for `mesh`. A function of arrays is called with up to 65,536 places at once; a function of x and y once per
        triangle.
    refine_if: as for `mesh`. Triangles for which it returns True are violations of the kind ``user_test``.

    On all threads; Ctrl-C ends it. Raises `UsageError`, `FileError`, and `InvalidInput` if the domain is not valid.

    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> bool(check(triangle, (triangle, [(0, 1, 2)])))
    True
    >>> check(triangle, (triangle, [(0, 2, 1)])).violations[0].kind
    'degenerate_triangle'
    """
    of_domain, of_mesh = domain_of(domain), mesh_of(mesh)
    goal = goal_of(min_angle=min_angle, max_area=max_area, max_edge=max_edge, size=size, grading=grading,
                   feature_size=feature_size, conforming=conforming, convex_hull=convex_hull,
                   region_caps=has_caps(of_domain))
    sizes = sizes_of(size, len(of_domain.points))
    places = sources_of(sources, grading)
    if places is not None:
        sizes.set_places(places)
    found = _pardel.check(of_domain._core, of_mesh._core, goal, sizes, number("max_circumradius", max_circumradius),
                          whole("max_violations", max_violations), test_of(refine_if))
    found["violations"] = tuple(Violation(*row) for row in found["violations"])
    found["extremes"] = {name: Extreme(*row) for name, row in found["extremes"].items()}
    return Certificate(**found)
