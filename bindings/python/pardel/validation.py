"""Validation and repair of domains."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _pardel
from .domain import Domain, DomainLike, domain_of
from .errors import Problem, problems_of


def validate(domain: DomainLike, segments: Optional[npt.ArrayLike] = None, *, holes: Optional[npt.ArrayLike] = None,
             regions: Optional[npt.ArrayLike] = None, markers: Optional[npt.ArrayLike] = None,
             convex_hull: bool = False, threads: int = 0) -> Sequence[Problem]:
    """All problems of a domain; none if it can be meshed. Exact: there is no tolerance.

    domain: a `Domain`, the path of a file, or points with the other arguments of `Domain`.
    convex_hull: the domain is the convex hull of the points, and an open outline is no problem.
    Raises `UsageError`, `FileError`. O(n log n) for n points and segments.

    >>> crossing = Domain([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (2, 3)])
    >>> for problem in validate(crossing):
    ...     print(problem.kind, problem.ids, problem.coordinates)
    crossing_segments (0, 1) (1.0, 1.0)
    """
    core = domain_of(domain, segments, holes=holes, regions=regions, markers=markers)._core
    return problems_of(_pardel.problems_of(core, convex_hull, threads))


@dataclass(frozen=True)
class Repaired:
    """What `repair` made.

    domain: the repaired domain. log: the changes, one sentence each; empty if nothing changed.
    point_map: shape (n,), int32: the new index of each old point. segment_map: one old segment per new segment, -1 for
    a side of the convex hull. snap: the distance that was used, in the unit of the coordinates.
    moved_points, bent_segments: how many were moved; farthest: how far, at most.
    """

    domain: Domain
    log: Tuple[str, ...]
    point_map: npt.NDArray[np.int32]
    segment_map: npt.NDArray[np.int32]
    snap: float
    moved_points: int
    bent_segments: int
    farthest: float
    convex_hull: bool


def repair(domain: DomainLike, segments: Optional[npt.ArrayLike] = None, *, snap: Optional[float] = None,
           convex_hull: bool = False, **parts: Any) -> Repaired:
    """Makes a valid domain of one with duplicate points, crossing or overlapping segments, or tiny gaps.

    snap: gaps below this distance are closed, in the unit of the coordinates; 0: only equal points are merged; None:
    gaps that are narrower than about 4e-12 of the coordinates there.
    Raises `UsageError`; `InvalidInput` if a coordinate is not finite, or if no domain is left.

    >>> crossing = Domain([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    >>> repair(crossing).domain
    Domain(5 points, 6 segments)
    """
    made = _pardel.repair(domain_of(domain, segments, **parts)._core, snap, convex_hull)
    return Repaired(domain=Domain._of(made.pop("domain")), **made)
