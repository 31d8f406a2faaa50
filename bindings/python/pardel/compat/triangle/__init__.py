"""For scripts that were written for the package `triangle`, the wrapper of Shewchuk's Triangle: one import changes.

docs/python_triangle.md lists what differs.

>>> import pardel.compat.triangle as tr
>>> square = dict(vertices=[(0, 0), (1, 0), (1, 1), (0, 1)], segments=[(0, 1), (1, 2), (2, 3), (3, 0)])
>>> mesh = tr.triangulate(square, "pq30a0.1")
>>> sorted(mesh)
['segment_markers', 'segments', 'triangles', 'vertex_markers', 'vertices']
"""

from .data import get_data, show_data
from .files import load, loads
from .plot import compare, comparev, plot
from .points import convex_hull, delaunay, voronoi
from .triangulation import triangulate

__all__ = ["compare", "comparev", "convex_hull", "delaunay", "get_data", "load", "loads", "plot", "show_data",
           "triangulate", "voronoi"]
