"""Constrained Delaunay, conforming Delaunay, and a conforming mesh of the letter A."""
import matplotlib.pyplot as plt

import pardel.compat.triangle as tr

A = tr.get_data("A")
meshes = {opts: tr.triangulate(A, opts) for opts in ("p", "pD", "pq0D", "pqa0.1D")}
for number, (opts, mesh) in enumerate(meshes.items()):
    tr.plot(plt.subplot(2, 2, number + 1), **mesh)
plt.show()
counts = {opts: len(mesh["triangles"]) for opts, mesh in meshes.items()}
