"""The triangulation of random points, and how many neighbours a point has."""
import numpy as np

import pardel.compat.triangle as tr

points = np.random.default_rng(0).random((300, 2))
mesh = tr.triangulate(dict(vertices=points), "e")
same = tr.delaunay(points)

degree = np.bincount(mesh["edges"].ravel(), minlength=len(points))
hull = len(tr.convex_hull(points))
boundary = int(mesh["edge_markers"].sum())
mean_degree = degree.mean()
