"""Outlines whose last point is the first one again, with a marker each."""
import numpy as np

from pardel.compat.meshpy import triangle


def outline(radius, count):
    angles = np.linspace(0, 2 * np.pi, count + 1)
    return [(radius * round(np.cos(a), 12), radius * round(np.sin(a), 12)) for a in angles]


points, facets, markers = [], [], []
for marker, radius in ((2, 1), (3, 3)):
    ring = outline(radius, 12)
    first, last = len(points), len(points) + len(ring) - 1
    points += ring
    facets += [(i, i + 1) for i in range(first, last)] + [(last, first)]
    markers += [marker] * len(ring)

info = triangle.MeshInfo()
info.set_points(points)
info.set_holes([(0, 0)])
info.set_facets(facets, facet_markers=markers)
mesh = triangle.build(info, refinement_func=lambda vertices, area: area > 0.1)
inner_nodes = [i for i, marker in enumerate(mesh.point_markers) if marker == 2]
outer_nodes = [i for i, marker in enumerate(mesh.point_markers) if marker == 3]
