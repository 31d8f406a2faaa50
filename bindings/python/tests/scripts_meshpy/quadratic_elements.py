"""Six points per element: corners, and the middles of the sides."""
import numpy as np

from pardel.compat.meshpy.triangle import MeshInfo, build

info = MeshInfo()
info.set_points([(0, 0), (2, 0), (2, 1), (0, 1)])
info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)], [1, 2, 3, 4])
mesh = build(info, max_volume=0.02, mesh_order=2, generate_faces=True)

points = np.vstack(mesh.points)
elements = np.vstack(mesh.elements)
# The fourth point of an element is in the middle of the side opposite the first one, and so on.
middles = [(points[elements[:, (k + 1) % 3]] + points[elements[:, (k + 2) % 3]]) / 2 for k in range(3)]
farthest = max(np.abs(points[elements[:, 3 + k]] - middles[k]).max() for k in range(3))
