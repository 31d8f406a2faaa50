"""pardel: guaranteed-quality triangle meshes of planar domains, on all threads, and an exact checker for any mesh.

>>> import pardel
>>> plate = pardel.polygon([(0, 0), (4, 0), (4, 3), (0, 3)], [(1, 1), (2, 1), (2, 2), (1, 2)])
>>> made = pardel.mesh(plate, min_angle=30, max_area=0.05)
>>> pardel.check(plate, made, min_angle=30, max_area=0.05).valid
True
"""

from . import loading as _loading  # first: it decides how the threads of `_pardel` wait
from ._mesh import Mesh, Quality
from ._pardel import version as __version__
from .checking import Certificate, Extreme, Violation, check
from .diagram import Voronoi, voronoi
from .domain import Domain
from .errors import Cancelled, Error, FileError, InternalError, InvalidInput, Problem, ResourceError, UsageError
from .files import read, write
from .generating import generate, generators, radial_sizes
from .geometry import geometry
from .meshing import convex_hull, delaunay, mesh, refine
from .pictures import draw
from .polygons import polygon
from .raster import Raster
from .report import Exemption, Exemptions, Gap, Report
from .simplices import Simplices
from .sources import Sources
from .validation import Repaired, repair, validate

__all__ = [
    "Cancelled", "Certificate", "Domain", "Error", "Exemption", "Exemptions", "Extreme", "FileError", "Gap",
    "InternalError", "InvalidInput", "Mesh", "Problem", "Quality", "Raster", "Repaired", "Report", "ResourceError",
    "Simplices", "Sources", "UsageError", "Violation", "Voronoi", "__version__", "check", "convex_hull", "delaunay",
    "draw", "generate", "generators", "geometry", "mesh", "polygon", "radial_sizes", "read", "refine", "repair",
    "validate", "voronoi", "write",
]
