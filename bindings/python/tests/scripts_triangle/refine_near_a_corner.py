"""A loop of refinement: each round gives the triangles near a corner a smaller largest area."""
import numpy as np

import pardel.compat.triangle as tr

square = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]])
mesh = tr.triangulate(square, "pq25a0.1")
counts = [len(mesh["triangles"])]
for _ in range(4):
    middles = mesh["vertices"][mesh["triangles"]].mean(axis=1)
    wanted = 0.02 * np.hypot(*middles.T) ** 2
    mesh["triangle_max_area"] = wanted.reshape(-1, 1)
    mesh = tr.triangulate(mesh, "prq25a")
    counts.append(len(mesh["triangles"]))
