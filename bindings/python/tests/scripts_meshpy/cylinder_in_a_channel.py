"""A circle in a box, put together by the builder; faces with markers are where a solver sets conditions."""
import numpy as np

from pardel.compat.meshpy.geometry import GeometryBuilder, Marker, make_circle
from pardel.compat.meshpy.triangle import MeshInfo, build

points, facets, _, markers = make_circle(0.5, center=(0, 0), subdivisions=32, marker=Marker.SHELL)
builder = GeometryBuilder()
builder.add_geometry(points=points, facets=facets, facet_markers=markers)
builder.wrap_in_box(1.5, subdivisions=(8, 4))
info = MeshInfo()
builder.set(info)
info.set_holes([builder.center()])


def is_too_large(vertices, area):
    distance = np.linalg.norm(np.mean(np.array(vertices), axis=0)) - 0.5
    return area > 0.002 + 0.05 * distance


mesh = build(info, refinement_func=is_too_large, generate_faces=True)
marker_of = mesh.face_vertex_indices_to_face_marker
on_shell = [face for face, marker in marker_of.items() if marker == Marker.SHELL]
