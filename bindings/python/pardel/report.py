"""What the mesher says about a run."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any, Dict, Mapping, Tuple

from .errors import Coordinates


@dataclass(frozen=True)
class Exemption:
    """A triangle that does not keep the bounds.

    reason: ``nestled`` or ``seditious`` (a small angle between segments makes it unavoidable), ``budget``
    (max_vertices), ``min_edge``, ``precision`` (no double splits it), ``kept_segment``.
    apex: the point of the domain with the small angle, or -1; angle: this angle in degrees.
    """

    triangle: int
    reason: str
    apex: int
    angle: float


@dataclass(frozen=True)
class Gap:
    """A place of the domain that is much narrower than its surroundings, which costs many small triangles."""

    kind: str
    points: Tuple[int, ...]
    segment: int
    distance: float
    surroundings: float
    coordinates: Coordinates
    text: str


@dataclass(frozen=True)
class Report:
    """How a mesh was made.

    goal_met: all bounds hold, except where a small angle of the domain makes this impossible.
    inserted, segment_splits: the numbers of new points inside faces and on segments. refused: how often a point was
    not inserted because an edge would have become too short. laid: equilateral triangles of ``interior="fill"``;
    restarts: how often this filling was given up. exempt: the triangles that miss a bound. gaps: the narrow places.
    repairs: what ``repair=True`` changed, one sentence each. The times are in seconds.
    """

    goal_met: bool
    inserted: int
    segment_splits: int
    refused: int
    laid: int
    restarts: int
    exempt: Tuple[Exemption, ...]
    gaps: Tuple[Gap, ...]
    repairs: Tuple[str, ...]
    validate_seconds: float
    triangulate_seconds: float
    refine_seconds: float

    @property
    def exempt_counts(self) -> Dict[str, int]:
        """The number of exempt triangles by reason."""
        return dict(Counter(each.reason for each in self.exempt))


def report_of(found: Mapping[str, Any]) -> Report:
    values = dict(found)
    values["exempt"] = tuple(Exemption(*row) for row in found["exempt"])
    values["gaps"] = tuple(Gap(*row) for row in found["gaps"])
    return Report(**values)
