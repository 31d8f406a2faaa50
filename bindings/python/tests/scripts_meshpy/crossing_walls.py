"""Walls that cross each other inside a square: their common point is added, and edges lie on both."""
from pardel.compat.meshpy import triangle

OUTSIDE, RISING, FALLING = 1, 20, 30
points = [(0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (3, 3), (1, 3), (3, 1)]
facets = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (6, 7)]

info = triangle.MeshInfo()
info.set_points(points)
info.set_facets(facets, facet_markers=4 * [OUTSIDE] + [RISING, FALLING])
mesh = triangle.build(info, max_volume=0.1)
walls = {marker: [tuple(facet) for facet, m in zip(mesh.facets, mesh.facet_markers) if m == marker]
         for marker in (RISING, FALLING)}
common = {end for facet in walls[RISING] for end in facet} & {end for facet in walls[FALLING] for end in facet}
