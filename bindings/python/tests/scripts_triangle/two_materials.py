"""Regions with attributes and largest areas of their own."""
import numpy as np

import pardel.compat.triangle as tr

plate = {
    "vertices": [[0, 0], [2, 0], [4, 0], [4, 2], [2, 2], [0, 2]],
    "segments": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]],
    "segment_markers": [[1], [1], [2], [1], [1], [3], [0]],
    "regions": [[1, 1, 1, 0.2], [3, 1, 2, 0.02]],
}
mesh = tr.triangulate(plate, "pq30Aa")

material = mesh["triangle_attributes"].ravel().astype(int)
corners = mesh["vertices"][mesh["triangles"]]
u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
area = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
area_of = {m: area[material == m].sum() for m in (1, 2)}
largest = {m: area[material == m].max() for m in (1, 2)}
outflow = mesh["segments"][mesh["segment_markers"].ravel() == 2]
