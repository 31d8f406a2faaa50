"""The named domains that examples, tests and benchmarks share."""

from __future__ import annotations

from typing import Dict, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _pardel
from .domain import Domain, DomainLike, domain_of
from .errors import UsageError
from .scalars import number, whole


def generate(kind: str, n: int = 0, *, seed: int = 1) -> Domain:
    """A named domain, as the command ``pardel generate`` writes it: a pipe, a key, a coast, random points, and so on.

    kind: a key of `generators`. n: the size, if the domain has one: how many points, teeth, cells or decades of radii;
    0: the usual one. seed: of a random domain. A seed gives the same domain on every machine.
    Raises `UsageError` for an unknown kind, with all that are known, or a size out of range.

    >>> generate("pipe")
    Domain(620 points, 620 segments, 7 holes)
    """
    if not isinstance(kind, str):
        raise UsageError(f"kind is {kind!r}; the name of a domain is needed")
    return Domain._of(_pardel.generate(kind, whole("n", n), _seed(seed)))


def _seed(seed: int) -> int:
    if isinstance(seed, bool) or not isinstance(seed, (int, np.integer)) or not 0 <= int(seed) < 2**64:
        raise UsageError(f"seed is {seed!r}; an integer from 0 to 2**64 - 1 is needed")
    return int(seed)


def generators() -> Dict[str, Optional[Tuple[int, int, int]]]:
    """The domains that `generate` knows, each with its least, its greatest and its usual size; None: it has one size.

    >>> generators()["comb"]
    (1, 100000, 16)
    """
    return dict(_pardel.sizes_of_kinds())


def radial_sizes(domain: DomainLike, ratio: float = 0.02) -> npt.NDArray[np.float64]:
    """Edge lengths at the points of a domain that grow with the distance from the origin: `ratio` times this distance.

    At the origin it is the length at the nearest other point. For ``generate("radial")``, and as ``size`` of `mesh`.

    >>> float(radial_sizes([(0, 0), (1, 0), (0, 2)], 0.5)[0])
    0.5
    """
    share = number("ratio", ratio)
    if not 0 < share < float("inf"):
        raise UsageError(f"ratio is {share}; a finite number greater than 0 is needed")
    return _pardel.radial_sizes(domain_of(domain)._core, share)
