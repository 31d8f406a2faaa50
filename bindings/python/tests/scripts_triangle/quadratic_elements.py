"""Triangles with six nodes, and an integral that is exact for polynomials of the second degree."""
import numpy as np

import pardel.compat.triangle as tr

letter = tr.get_data("A")
mesh = tr.triangulate(letter, "pqa0.5o2")
nodes, triangles = mesh["vertices"], mesh["triangles"]

p = nodes[triangles[:, :3]]
u, v = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
area = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
middles = nodes[triangles[:, 3:]]
moment = (area[:, None] * middles[:, :, 1] ** 2 / 3).sum()
whole = tr.triangulate(letter, "p")
