"""`MeshInfo`: what goes into `build` and `refine`, and what comes out."""

from __future__ import annotations

import sys
from typing import Any, Dict, FrozenSet, Iterable, Optional, TextIO, Tuple

import numpy as np

from .foreign_array import ForeignArray
from .neutral import write_neutral

# The name, the kind and the number of numbers per row of each array, and the array whose length it has.
_ARRAYS: Tuple[Tuple[str, type, int, Optional[str]], ...] = (
    ("points", float, 2, None), ("point_attributes", float, 0, "points"), ("point_markers", int, 1, "points"),
    ("elements", int, 3, None), ("element_attributes", float, 0, "elements"),
    ("element_volumes", float, 1, "elements"), ("neighbors", int, 3, "elements"), ("facets", int, 2, None),
    ("facet_markers", int, 1, "facets"), ("holes", float, 2, None), ("regions", float, 4, None),
    ("faces", int, 2, None), ("face_markers", int, 1, "faces"), ("normals", float, 2, "faces"))


class MeshInfo:
    """Points, facets (segments), holes and regions of a domain; or a mesh, whose elements are triangles.

    Each field is a `ForeignArray`: points (n, 2), point_attributes, point_markers; elements (m, 3) or (m, 6),
    element_attributes, element_volumes (the largest area in what each triangle covers, for `refine`), neighbors; facets
    (s, 2), facet_markers; holes (h, 2); regions (r, 4): x, y, attribute, largest area; faces (e, 2), all edges,
    face_markers; normals, which `build` never sets. Objects can be copied and pickled.
    """

    points: ForeignArray
    point_attributes: ForeignArray
    point_markers: ForeignArray
    elements: ForeignArray
    element_attributes: ForeignArray
    element_volumes: ForeignArray
    neighbors: ForeignArray
    facets: ForeignArray
    facet_markers: ForeignArray
    holes: ForeignArray
    regions: ForeignArray
    faces: ForeignArray
    face_markers: ForeignArray
    normals: ForeignArray

    def __init__(self) -> None:
        for name, kind, unit, master in _ARRAYS:
            setattr(self, name, ForeignArray(name, kind, unit, None if master is None else getattr(self, master)))

    @property
    def number_of_point_attributes(self) -> int:
        """Numbers per point. Setting it makes room for them, once `point_attributes` has been set up."""
        return self.point_attributes.unit

    @number_of_point_attributes.setter
    def number_of_point_attributes(self, count: int) -> None:
        self.point_attributes.set_unit(count)

    @property
    def number_of_element_attributes(self) -> int:
        """Numbers per triangle."""
        return self.element_attributes.unit

    @number_of_element_attributes.setter
    def number_of_element_attributes(self, count: int) -> None:
        self.element_attributes.set_unit(count)

    @property
    def number_of_element_vertices(self) -> int:
        """3, or 6 with points in the middle of edges."""
        return self.elements.unit

    @number_of_element_vertices.setter
    def number_of_element_vertices(self, count: int) -> None:
        self.elements.set_unit(count)

    def set_points(self, points: Iterable[Any], point_markers: Optional[Iterable[Any]] = None) -> None:
        """Sets the points, and one marker per point."""
        self.points.set_all(points)
        if point_markers is not None:
            self.point_markers.set_all(point_markers)

    def set_facets(self, facets: Iterable[Any], facet_markers: Optional[Iterable[Any]] = None) -> None:
        """Sets the segments: pairs of indices of points, and one marker per segment."""
        self.facets.set_all(facets)
        if facet_markers is not None:
            self.facet_markers.set_all(facet_markers)

    def set_holes(self, hole_starts: Iterable[Any]) -> None:
        """Sets one place in each hole."""
        self.holes.set_all(hole_starts)

    @property
    def face_vertex_indices_to_face_marker(self) -> Dict[FrozenSet[int], int]:
        """The marker of each face, by the set of its two points."""
        markers = np.array(self.face_markers).tolist()
        return {frozenset(face): marker for face, marker in zip(np.array(self.faces).tolist(), markers)}

    def copy(self) -> MeshInfo:
        """An object with arrays of its own."""
        other = MeshInfo()
        other.__setstate__(self.__getstate__())
        return other

    __copy__ = copy

    def dump(self) -> None:
        """Prints all arrays."""
        for name, _, _, _ in _ARRAYS:
            array: ForeignArray = getattr(self, name)
            lines = [f"array {name}: {len(array)} elements, {array.unit} values per element"]
            rows = np.array(array).tolist() if array.allocated else []
            lines += [f"  {index}: {','.join(map(str, row)) if isinstance(row, list) else row}"
                      for index, row in enumerate(rows)]
            sys.stdout.write("\n".join(lines) + "\n")

    def write_neu(self, outfile: TextIO, bc: Optional[Dict[Any, Tuple[str, int]]] = None,
                  periodicity: Optional[Tuple[int, Iterable[float]]] = None,
                  description: str = "pardel output") -> None:
        """Writes the mesh as a Gambit neutral file.

        bc: by face marker, or by a frozenset of them, the name and the code of a boundary condition.
        periodicity: a face marker, and the period in each direction. Both need faces (``generate_faces=True``).
        """
        write_neutral(self, outfile, dict(bc or {}), periodicity, description)

    def __getstate__(self) -> Dict[str, Any]:
        return {name: (array.unit, np.array(array) if array.allocated else None)
                for name, array in ((name, getattr(self, name)) for name, _, _, _ in _ARRAYS)}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        MeshInfo.__init__(self)
        for name, (unit, rows) in state.items():
            array: ForeignArray = getattr(self, name)
            array.set_unit(unit)
            if rows is not None:
                array.set_all(rows)

    def __repr__(self) -> str:
        return f"MeshInfo({len(self.points)} points, {len(self.elements)} elements, {len(self.facets)} facets)"
