"""A disk whose triangles grow with the distance to a point on its edge."""
import numpy as np

from pardel.compat.meshpy.triangle import MeshInfo, build


def needs_refinement(vertices, area):
    origin, destination, apex = vertices
    x = (origin.x + destination.x + apex.x) / 3
    y = (origin.y + destination.y + apex.y) / 3
    return bool(area > 0.0005 + 0.02 * ((x - 1)**2 + y**2))


angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
info = MeshInfo()
info.set_points(np.column_stack([np.cos(angles), np.sin(angles)]))
info.set_facets([(i, (i + 1) % 60) for i in range(60)])
mesh = build(info, refinement_func=needs_refinement)
