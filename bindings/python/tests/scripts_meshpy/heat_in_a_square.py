"""Linear finite elements: the temperature in a square that is cold at its edges and heated everywhere."""
import numpy as np

import pardel.compat.meshpy.triangle as triangle

info = triangle.MeshInfo()
info.set_points([(0, 0), (1, 0), (1, 1), (0, 1)])
info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)], [1, 2, 3, 4])
mesh = triangle.build(info, max_volume=2e-3, min_angle=28)

points = np.array(mesh.points)
elements = np.array(mesh.elements)
matrix, load = np.zeros((len(points), len(points))), np.zeros(len(points))
for corners in elements:
    (x0, y0), (x1, y1), (x2, y2) = points[corners]
    slopes = np.array([[y1 - y2, y2 - y0, y0 - y1], [x2 - x1, x0 - x2, x1 - x0]])
    area = ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2
    matrix[np.ix_(corners, corners)] += slopes.T @ slopes / (4 * area)
    load[corners] += area / 3
inside = np.array(mesh.point_markers) == 0
temperature = np.zeros(len(points))
temperature[inside] = np.linalg.solve(matrix[np.ix_(inside, inside)], load[inside])
