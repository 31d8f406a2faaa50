"""Meshes: their arrays, and what is measured on them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays, exports, locating, pickling
from .domain import Domain
from .notebook import svg_of_mesh
from .paths import Path, text_of
from .plotting import By, plot_mesh
from .report import Report, report_of
from .simplices import Simplices

Indices = npt.NDArray[np.int32]
Numbers = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Quality:
    """Measures of a mesh. Angles in degrees, lengths in the unit of the coordinates, areas in its square."""

    vertices: int
    triangles: int
    min_angle: float
    max_angle: float
    max_circumradius: float
    area: float


class Mesh:
    """A triangle mesh. `mesh`, `refine`, `delaunay` and `read` make meshes, and so do arrays of any program.

    points: shape (n, 2). triangles: shape (m, 3): indices of points from 0, counter-clockwise. Both are copied once.

    All arrays of a mesh are read-only views on its memory, without a copy; they stay valid when the mesh is deleted.
    Those of triangles are parts of larger records, so they are not contiguous: ``numpy.ascontiguousarray`` copies one.
    Indices are int32; -1 means none. Raises `UsageError` for a wrong shape or dtype. An index out of range is a finding
    of `check`; everything else then raises `InvalidInput`.

    >>> square = Mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])
    >>> square.neighbors.tolist()
    [[-1, 1, -1], [-1, -1, 0]]
    """

    def __init__(self, points: npt.ArrayLike, triangles: npt.ArrayLike) -> None:
        self._core = _pardel.HeldMesh(arrays.numbers("points", points, 2), arrays.corners("triangles", triangles))
        self._report: Optional[Mapping[str, Any]] = None

    @classmethod
    def _of(cls, core: _pardel.HeldMesh, report: Optional[Mapping[str, Any]] = None) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._core, mesh._report = core, report
        return mesh

    @property
    def points(self) -> Numbers:
        """Shape (n, 2), float64. Those of the domain come first, in their order."""
        return self._core.points

    @property
    def triangles(self) -> Indices:
        """Shape (m, 3), int32: the corners of each triangle, counter-clockwise."""
        return self._core.triangles

    @property
    def neighbors(self) -> Indices:
        """Shape (m, 3), int32: the triangle across the edge opposite each corner; -1 on the boundary."""
        return self._core.neighbors

    @property
    def edges(self) -> Indices:
        """Shape (e, 2), int32: the ends of all edges. Computed at the first use."""
        return self._core.edges

    @property
    def edge_markers(self) -> Indices:
        """Shape (e,), int32: the marker of each of `edges`: that of its segment; else 1 on the boundary, 0 inside."""
        return self._core.edge_markers

    @property
    def segments(self) -> Indices:
        """Shape (s, 2), int32: the edges on segments of the domain, or on the convex hull where it is the domain."""
        return self._core.segments

    @property
    def segment_markers(self) -> Indices:
        """Shape (s,), int32: the marker of each of `segments`."""
        return self._core.segment_markers

    @property
    def segment_ids(self) -> Indices:
        """Shape (s,), int32: the segment of the domain on which each of `segments` lies; -1 if it is not known."""
        return self._core.segment_ids

    @property
    def point_markers(self) -> Indices:
        """Shape (n,), int32: given ones; else the first marker other than 0 of an edge of `segments` at the point."""
        return self._core.point_markers

    @property
    def regions(self) -> Indices:
        """Shape (m,), int32: an index into `region_attributes`; -1: no region. Empty if the mesh has no regions."""
        return self._core.regions

    @property
    def region_attributes(self) -> Numbers:
        """Shape (r,), float64: the attribute of each region."""
        return self._core.region_attributes

    @property
    def attributes(self) -> Numbers:
        """Shape (n, k), float64: numbers at the points, those of the domain and interpolated ones."""
        return self._core.attributes

    @property
    def domain(self) -> Optional[Domain]:
        """The domain that was meshed, after its repair; None if it is not known."""
        core = self._core.domain
        return None if core is None else Domain._of(core)

    @property
    def report(self) -> Optional[Report]:
        """How the mesh was made; None for a mesh of arrays or of a file."""
        return None if self._report is None else report_of(self._report)

    @property
    def digest(self) -> str:
        """32 hexadecimal digits that do not depend on the numbering: equal for equal meshes. O(m), computed anew."""
        return self._core.digest()

    def quality(self) -> Quality:
        """Measures of the mesh, in floating-point arithmetic, in one pass on all threads."""
        return Quality(**self._core.statistics())

    def area(self) -> float:
        """The sum of the areas of all triangles, in the square of the unit of the coordinates."""
        return self.quality().area

    def plot(self, ax: Any = None, by: By = None, *, edges: bool = True, segments: bool = True, colorbar: bool = True,
             **options: Any) -> Any:
        """Draws the mesh with matplotlib.

        ax: the axes of matplotlib; None: the current ones.
        by: what the colours show: ``quality`` (the smallest angle of a triangle), ``angle`` (its largest one), ``size``
            (its longest edge), ``region`` (the attribute); or numbers, one per point or one per triangle. If both would
            fit, they are at points. None: one colour.
        edges, segments: False: they are not drawn. colorbar: False: no scale of the colours is added.
        Further arguments are for matplotlib's ``tripcolor``. Returns the axes.
        Raises `UsageError` for another shape, or if matplotlib is not installed.
        """
        return plot_mesh(self, ax, by, edges, segments, colorbar, **options)

    def _repr_svg_(self) -> Optional[str]:
        return svg_of_mesh(self)

    def locate(self, points: npt.ArrayLike, *, threads: int = 0) -> Indices:
        """The triangle in which each point lies: shape (n,), int32; -1 outside the mesh. Exact: there is no tolerance.

        points: shape (n, 2). A point on an edge or at a vertex gets the triangle with the smallest index among those
        that contain it; one with a coordinate that is not finite gets -1. threads: 0: all.
        The mesh may be of any kind, with holes and cracks. The first call prepares the search of all later ones.
        Raises `UsageError`; `InvalidInput` for a clockwise triangle, or one with corners that are not finite.

        >>> square = Mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])
        >>> square.locate([(0.9, 0.5), (0.1, 0.5), (0.5, 0.5), (2, 2)]).tolist()
        [0, 1, 0, -1]
        """
        return locating.locate(self._core, points, threads)

    def interpolate(self, values: npt.ArrayLike, points: npt.ArrayLike, outside: float = np.nan, *,
                    threads: int = 0) -> Numbers:
        """Interpolates values at the points of the mesh, linearly in each triangle.

        values: shape (n,) or (n, k), of any real dtype: one row per point of the mesh. points: shape (m, 2).
        outside: the result where `locate` finds no triangle. threads: 0: all.
        Returns float64 of shape (m,) or (m, k). At a vertex the result is its value exactly; on an edge it depends on
        the values at both ends only; everywhere it lies between those at the corners. A linear function is reproduced
        up to rounding, a constant exactly. Raises the exceptions of `locate`.

        >>> square = Mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])
        >>> square.interpolate([0, 1, 2, 1], [(0.25, 0.5), (1, 1), (2, 2)], outside=-1).tolist()
        [0.75, 2.0, -1.0]
        """
        return locating.interpolate(self._core, values, points, outside, threads)

    def save(self, path: Path, *, as_text: bool = False, second_order: bool = False) -> None:
        """Writes a file, as `write` does."""
        _pardel.write_mesh(text_of(path), self._core, as_text, second_order)

    def to_meshio(self) -> Any:
        """A ``meshio.Mesh``: triangles, then `segments` as lines.

        Its point data are ``marker``, ``attributes`` and fields of the file; its cell data ``marker`` (0 in triangles),
        ``region`` (the attribute; 0 where there is none) and fields. Raises `UsageError` without the package meshio.
        """
        return exports.to_meshio(self)

    def to_matplotlib(self) -> Any:
        """A ``matplotlib.tri.Triangulation``. Raises `UsageError` without the package matplotlib."""
        return exports.to_matplotlib(self)

    def to_scipy(self) -> Simplices:
        """The mesh with the attributes and `find_simplex` of ``scipy.spatial.Delaunay``. Needs no SciPy."""
        return Simplices(self)

    def adjacency(self, *, lengths: bool = False) -> Any:
        """A ``scipy.sparse.csr_array`` of shape (n, n), symmetric: the points that edges join.

        lengths: the entries are the lengths of the edges (float64), as ``scipy.sparse.csgraph`` takes them; else 1.
        Raises `UsageError` without SciPy.
        """
        return exports.adjacency(self, bool(lengths))

    def __copy__(self) -> Mesh:
        return pickling.copied(self)  # type: ignore[no-any-return]

    def __deepcopy__(self, memo: Dict[int, Any]) -> Mesh:
        return pickling.deeply_copied(self, memo)  # type: ignore[no-any-return]

    def __reduce__(self) -> Tuple[Any, ...]:
        return pickling.reduced(self)

    def __repr__(self) -> str:
        return f"Mesh({len(self.points)} points, {len(self.triangles)} triangles)"
