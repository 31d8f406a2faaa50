"""Lines of a drawing that cross, with points that are given twice."""
import numpy as np

import pardel.compat.triangle as tr

lines = [((0, 0), (4, 0)), ((4, 0), (4, 4)), ((4, 4), (0, 4)), ((0, 4), (0, 0)), ((1, 1), (3, 3)), ((1, 3), (3, 1))]
vertices = np.array([end for line in lines for end in line], dtype=float)
segments = np.arange(len(vertices)).reshape(-1, 2)
mesh = tr.triangulate(dict(vertices=vertices, segments=segments), "pj")
kept = tr.triangulate(dict(vertices=vertices, segments=segments), "p")
