"""Meshes of a spiral with larger and larger smallest angles, and a table of them."""
import numpy as np

import pardel.compat.triangle as tr

spiral = tr.get_data("spiral")
table = []
for opts in ("", "q", "q25", "q30", "q32.5"):
    mesh = tr.triangulate(spiral, opts)
    p = mesh["vertices"][mesh["triangles"]]
    sides = np.linalg.norm(np.roll(p, -1, axis=1) - p, axis=2)
    a, b, c = sides.T
    cosines = [(y**2 + z**2 - x**2) / (2 * y * z) for x, y, z in ((a, b, c), (b, c, a), (c, a, b))]
    table.append((opts, len(mesh["triangles"]), np.degrees(np.arccos(np.max(cosines)))))
