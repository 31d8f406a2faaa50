"""Two materials, each with its attribute and its largest area."""
import pardel.compat.meshpy.triangle as triangle

info = triangle.MeshInfo()
info.set_points([(0, 0), (1, 0), (3, 0), (3, 1), (1, 1), (0, 1)])
info.set_facets([(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)])
info.regions.resize(2)
info.regions[0] = (0.5, 0.5, 7, 0.002)
info.regions[1] = (2, 0.5, 8, 0.05)
mesh = triangle.build(info, attributes=True, volume_constraints=True)
fine = [i for i in range(len(mesh.elements)) if mesh.element_attributes[i] == 7]
coarse = [i for i in range(len(mesh.elements)) if mesh.element_attributes[i] == 8]
