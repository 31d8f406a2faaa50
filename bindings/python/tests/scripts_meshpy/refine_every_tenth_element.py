"""A mesh is refined in every tenth of its elements."""
import pardel.compat.meshpy.triangle as triangle

info = triangle.MeshInfo()
info.set_points([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)])
info.set_facets([(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0)], [5, 5, 6, 6, 6, 5])
coarse = triangle.build(info, max_volume=0.1)

coarse.element_volumes.setup()
for i in range(len(coarse.elements)):
    coarse.element_volumes[i] = -1
for i in range(0, len(coarse.elements), 10):
    coarse.element_volumes[i] = 1e-3
mesh = triangle.refine(coarse)
