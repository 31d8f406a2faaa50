"""A strip whose left and right sides have the same points, because no point is added on the boundary."""
import pardel.compat.meshpy.triangle as triangle

points = [(0, 0), (3, 0), (3, 1), (0, 1)]
facets = [(0, 1), (1, 2), (2, 3), (3, 0)]
markers = [1, 2, 3, 4]
points, facets, markers = triangle.subdivide_facets([12, 5, 12, 5], points, facets, markers)

info = triangle.MeshInfo()
info.set_points(points)
info.set_facets(facets, markers)
mesh = triangle.build(info, max_volume=0.04, allow_boundary_steiner=False)
left = sorted(y for (x, y) in mesh.points if x == 0)
right = sorted(y for (x, y) in mesh.points if x == 3)
