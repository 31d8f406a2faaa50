"""Domains under construction: places that are joined to chains, and the triangles of what is there already."""

from __future__ import annotations

from typing import Dict, List, Sequence, Set, Tuple

import numpy as np

from ..domain import Domain
from ..meshing import delaunay
from .code import code_of
from .shapes import Place, Places, place_inside, turn

Corners = Tuple[Place, Place, Place]
Lattice = Sequence[Tuple[int, int]]


class DrawnDomain(Domain):
    """A domain whose text is the Python code that makes it, for reports of Hypothesis."""

    def __repr__(self) -> str:
        return f"pardel.Domain({code_of(self, with_regions=True)})"


class Draft:
    """The points, segments, holes and regions of a domain; equal places become one point."""

    def __init__(self, outline: Places = ()) -> None:
        self.points: List[Place] = []
        self.segments: List[Tuple[int, int]] = []
        self.holes: List[Place] = []
        self.regions: List[Tuple[float, float, float]] = []
        self._ids: Dict[Place, int] = {}
        if outline:
            self.add(outline, closed=True)

    def add(self, places: Places, closed: bool = False) -> None:
        """Adds the segments of a path, or of a polygon; of one place the point."""
        ids = [self._id(place) for place in places]
        self.segments += list(zip(ids, ids[1:]))
        if closed:
            self.segments.append((ids[-1], ids[0]))

    def _id(self, place: Place) -> int:
        if place not in self._ids:
            self._ids[place] = len(self.points)
            self.points.append(place)
        return self._ids[place]

    def domain(self, offset: Place = (0, 0)) -> DrawnDomain:
        """The domain, moved by an offset."""
        points, holes, regions = (np.array(rows, dtype=np.float64).reshape(-1, columns)
                                  for rows, columns in ((self.points, 2), (self.holes, 2), (self.regions, 3)))
        points += offset
        holes += offset
        regions[:, :2] += offset
        return DrawnDomain(points, self.segments, holes=holes, regions=regions if len(regions) else None)

    def triangles(self) -> List[Tuple[int, int, int]]:
        """The corners of the triangles of the constrained Delaunay triangulation, in a fixed order."""
        return [(int(a), int(b), int(c)) for a, b, c in delaunay(self.domain(), threads=1).triangles.tolist()]

    def corners(self, triangle: Tuple[int, int, int]) -> Corners:
        a, b, c = triangle
        return self.points[a], self.points[b], self.points[c]

    def add_hole(self, ring: Places) -> None:
        """Adds a polygon inside a face as a hole."""
        inner = Draft(ring)
        for triangle in inner.triangles():
            place = place_inside(*inner.corners(triangle))
            if place is not None:
                self.add(ring, closed=True)
                self.holes.append(place)
                return

    def add_regions(self) -> None:
        """Puts a place with an attribute, 1, 2 and so on, into each face."""
        triangles = self.triangles()
        walls = {frozenset(ends) for ends in self.segments}
        across: Dict[frozenset[int], List[int]] = {}
        for index, triangle in enumerate(triangles):
            for k in range(3):
                across.setdefault(frozenset((triangle[k], triangle[k - 1])), []).append(index)
        seen: Set[int] = set()
        for first in range(len(triangles)):
            place = None if first in seen else place_inside(*self.corners(triangles[first]))
            if place is None:
                continue
            self.regions.append((*place, float(len(self.regions) + 1)))
            waiting = [first]
            while waiting:
                index = waiting.pop()
                if index in seen:
                    continue
                seen.add(index)
                for edge, beside in across.items():
                    if index in beside and edge not in walls:
                        waiting += beside


def mapped(corners: Corners, lattice: Lattice) -> List[Place]:
    """Places of the lattice (i, j), 1 <= i, j and i + j <= 5, inside a triangle whose corners are multiples of six."""
    (ax, ay), (bx, by), (cx, cy) = corners
    assert turn(*corners) > 0
    return [((i * ax + j * bx + (6 - i - j) * cx) // 6, (i * ay + j * by + (6 - i - j) * cy) // 6) for i, j in lattice]
