"""Tests of meshers and of checkers of meshes, with domains and meshes that Hypothesis draws.

`certify` runs any mesher that Python can call through families of domains, and checks each mesh in exact arithmetic.
`domains`, `meshes` and `faulty_meshes` are strategies for tests of one's own. Only this part of the package needs
Hypothesis.
"""

try:
    import hypothesis as _hypothesis  # noqa: F401
except ImportError as error:
    raise ImportError("pardel.testing needs the package hypothesis (pip install hypothesis, or the Debian package "
                      "python3-hypothesis)", name="hypothesis") from error

from .certifying import NotCertified, Summary, certify, replay
from .families import FAMILIES, domains
from .faults import FAULTS
from .meshes import Meshed, faulty_meshes, meshes

__all__ = ["FAMILIES", "FAULTS", "Meshed", "NotCertified", "Summary", "certify", "domains", "faulty_meshes", "meshes",
           "replay"]
