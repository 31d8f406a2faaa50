"""One run of a mesher on one domain, and what is wrong with the result."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Collection, Optional

import numpy as np
import numpy.typing as npt

from .._mesh import Mesh
from ..checking import Certificate, check
from ..domain import Domain
from ..errors import UsageError

Numbers = npt.NDArray[np.float64]
Segments = npt.NDArray[np.int32]
Mesher = Callable[[Numbers, Segments, Numbers, float], Any]
_LISTED = 5


@dataclass(frozen=True)
class Verdict:
    """What came of a run.

    kind: empty if the mesh is right; else ``raised``, ``returned`` (no mesh) or ``wrong`` (a wrong mesh).
    text: the reason, in lines. certificate: None if there was no mesh. error: what the mesher raised.
    """

    kind: str
    text: str
    certificate: Optional[Certificate] = None
    error: Optional[Exception] = None


def plain(domain: Domain) -> Domain:
    """The part of a domain that a mesher is given: no markers, attributes and regions."""
    return Domain(domain.points, domain.segments, holes=domain.holes)


def _mesh_of(returned: Any) -> Mesh:
    if isinstance(returned, Mesh):
        return Mesh(returned.points, returned.triangles)
    if not isinstance(returned, (tuple, list)) or len(returned) != 2:
        size = f" of {len(returned)}" if isinstance(returned, (tuple, list)) else ""
        raise UsageError(f"(points, triangles) is needed; this is a {type(returned).__name__}{size}")
    return Mesh(*returned)


def judged(mesher: Mesher, domain: Domain, min_angle: float, ignore: Collection[str]) -> Verdict:
    """Runs a mesher on a plain domain, and checks its mesh. KeyboardInterrupt and the like pass through."""
    arguments = domain.points.copy(), domain.segments.copy(), domain.holes.copy()
    try:
        returned = mesher(*arguments, min_angle)
    except Exception as error:  # any mistake of the mesher is a finding
        return Verdict("raised", f"the mesher raised {type(error).__name__}: {error}", error=error)
    try:
        mesh = _mesh_of(returned)
    except UsageError as error:
        return Verdict("returned", f"the mesher returned no mesh: {error}")
    certificate = check(domain, mesh, min_angle=min_angle)
    counted = {kind: count for kind, count in certificate.violation_counts.items() if kind not in ignore}
    if not counted:
        return Verdict("", "", certificate)
    listed = [each.text for each in certificate.violations if each.kind in counted]
    more = sum(counted.values()) - len(listed[:_LISTED])
    lines = [f"the mesh of {certificate.triangles} triangles is wrong:", *(f"  {text}" for text in listed[:_LISTED])]
    return Verdict("wrong", "\n".join(lines + ([f"  and {more} more"] if more > 0 else [])), certificate)
