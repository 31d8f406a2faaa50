"""The names of `meshpy.triangle`."""

from .building import build, refine
from .facets import subdivide_facets, write_gnuplot_mesh
from .mesh_info import MeshInfo

__all__ = ["MeshInfo", "build", "refine", "subdivide_facets", "write_gnuplot_mesh"]
