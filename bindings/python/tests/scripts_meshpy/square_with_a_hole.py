"""A square with a square hole."""
import pardel.compat.meshpy.triangle as triangle


def round_trip_connect(start, end):
    return [(i, i + 1) for i in range(start, end)] + [(end, start)]


points = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
facets = round_trip_connect(0, len(points) - 1)
start = len(points)
points.extend([(-1, -1), (1, -1), (1, 1), (-1, 1)])
facets.extend(round_trip_connect(start, len(points) - 1))

info = triangle.MeshInfo()
info.set_points(points)
info.set_facets(facets)
info.set_holes([(0, 0)])
mesh = triangle.build(info, max_volume=0.05, min_angle=30)
