"""For scripts that were written for MeshPy's `meshpy.triangle`: one import changes.

docs/python_meshpy.md lists what differs.

>>> import pardel.compat.meshpy.triangle as triangle
>>> info = triangle.MeshInfo()
>>> info.set_points([(0, 0), (1, 0), (1, 1), (0, 1)])
>>> info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)])
>>> mesh = triangle.build(info, max_volume=0.1)
>>> len(mesh.points), len(mesh.elements), len(mesh.facets)
(13, 16, 8)
"""

from . import geometry, triangle

__all__ = ["geometry", "triangle"]
