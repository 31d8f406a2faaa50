"""Facets in equal parts, and files for gnuplot."""

from __future__ import annotations

import os
from typing import Any, List, Optional, Sequence, Tuple, Union

from ...errors import UsageError
from .mesh_info import MeshInfo

Facets = List[Tuple[int, int]]


def subdivide_facets(subdivisions: Union[int, Sequence[int]], points: Sequence[Any], facets: Sequence[Any],
                     facet_markers: Optional[Sequence[Any]] = None) -> Any:
    """Divides each facet into equal parts, and returns (points, facets), or (points, facets, markers).

    subdivisions: the number of parts, or one number per facet. The given points come first.

    >>> subdivide_facets(2, [(0, 0), (1, 0)], [(0, 1)], [7])
    ([(0, 0), (1, 0), [0.5, 0.0]], [(0, 2), (2, 1)], [7, 7])
    """
    counts = [subdivisions] * len(facets) if isinstance(subdivisions, int) else [int(n) for n in subdivisions]
    for name, length in (("subdivisions", len(counts)),
                         ("facet_markers", len(facets) if facet_markers is None else len(facet_markers))):
        if length != len(facets):
            raise UsageError(f"{name} has {length} entries; {len(facets)} are needed, one per facet")
    new_points: List[Any] = list(points)
    new_facets: Facets = []
    new_markers: List[Any] = []
    for k, ((a, b), parts) in enumerate(zip(facets, counts)):
        if parts < 1:
            raise UsageError(f"subdivisions[{k}] is {parts}; at least 1 is needed")
        last = a
        for i in range(1, parts):
            new_points.append([p + (q - p) * i / parts for p, q in zip(points[a], points[b])])
            new_facets.append((last, len(new_points) - 1))
            last = len(new_points) - 1
        new_facets.append((last, b))
        if facet_markers is not None:
            new_markers += [facet_markers[k]] * parts
    return (new_points, new_facets) if facet_markers is None else (new_points, new_facets, new_markers)


def write_gnuplot_mesh(filename: Union[str, "os.PathLike[str]"], out_p: MeshInfo, facets: bool = False) -> None:
    """Writes the outlines of the elements, or of the facets, as blocks of points: ``plot "FILE" with lines``."""
    shapes = out_p.facets if facets else out_p.elements
    with open(filename, "w", encoding="ascii") as file:
        for corners in shapes:
            assert isinstance(corners, list)
            for corner in [*corners[:3], corners[0]]:
                x, y = out_p.points[corner]
                file.write(f"{x:f} {y:f}\n")
            file.write("\n")
