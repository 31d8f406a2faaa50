"""Linear finite elements: the temperature is given on the boundary and is x + 2 y there, so it is so everywhere."""
import numpy as np

import pardel.compat.triangle as tr

ell = dict(vertices=np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], dtype=float),
           segments=[[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]])
mesh = tr.triangulate(ell, "pq32a0.02")
points, triangles = mesh["vertices"], mesh["triangles"]

count = len(points)
matrix = np.zeros((count, count))
for corners in triangles:
    p = points[corners]
    sides = np.roll(p, -2, axis=0) - np.roll(p, -1, axis=0)
    double_area = sides[0, 0] * sides[1, 1] - sides[0, 1] * sides[1, 0]
    matrix[np.ix_(corners, corners)] += sides @ sides.T / (2 * double_area)
fixed = mesh["vertex_markers"].ravel() != 0
exact = points @ [1, 2]
free = ~fixed
temperature = exact * fixed
temperature[free] = np.linalg.solve(matrix[np.ix_(free, free)], -matrix[np.ix_(free, fixed)] @ exact[fixed])
error = np.abs(temperature - exact).max()
