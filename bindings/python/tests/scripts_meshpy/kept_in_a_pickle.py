"""A mesh is pickled, and refined when it is read again."""
import copy
import pickle

from pardel.compat.meshpy.triangle import MeshInfo, build, refine

info = MeshInfo()
info.set_points([(0, 0), (1, 0), (0.5, 1)], point_markers=[11, 12, 13])
info.set_facets([(0, 1), (1, 2), (2, 0)], facet_markers=[1, 2, 3])
coarse = build(copy.copy(info), max_volume=0.05, generate_faces=True)
again = pickle.loads(pickle.dumps(coarse))
mesh = refine(again, refinement_func=lambda vertices, area: area > 0.005)
