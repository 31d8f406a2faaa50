"""pardel: guaranteed-quality triangle meshes of planar domains, on all threads, and an exact checker for any mesh.

>>> import pardel
>>> plate = pardel.polygon([(0, 0), (4, 0), (4, 3), (0, 3)], [(1, 1), (2, 1), (2, 2), (1, 2)])
>>> made = pardel.mesh(plate, min_angle=30, max_area=0.05)
>>> pardel.check(plate, made, min_angle=30, max_area=0.05).valid
True
"""

from ._mesh import Mesh, Quality
from ._pardel import version as __version__
from .checking import Certificate, Extreme, Violation, check
from .diagram import Voronoi, voronoi
from .domain import Domain
from .errors import Cancelled, Error, FileError, InternalError, InvalidInput, Problem, ResourceError, UsageError
from .files import read, write
from .meshing import convex_hull, delaunay, mesh, refine
from .polygons import polygon
from .report import Exemption, Exemptions, Gap, Report
from .validation import Repaired, repair, validate

__all__ = [
    "Cancelled", "Certificate", "Domain", "Error", "Exemption", "Exemptions", "Extreme", "FileError", "Gap",
    "InternalError", "InvalidInput", "Mesh", "Problem", "Quality", "Repaired", "Report", "ResourceError", "UsageError",
    "Violation", "Voronoi", "__version__", "check", "convex_hull", "delaunay", "mesh", "polygon", "read", "refine",
    "repair", "validate", "voronoi", "write",
]
