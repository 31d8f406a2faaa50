"""What the mesher says about a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Iterator, Mapping, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

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


class Exemptions(Sequence[Exemption]):
    """The triangles that miss a bound, in ascending order: a sequence of `Exemption`, which are made when asked for.

    triangles: shape (k,), int32: all their indices.
    """

    def __init__(self, triangles: npt.NDArray[np.int32], reasons: npt.NDArray[np.uint8], apexes: npt.NDArray[np.int32],
                 angles: npt.NDArray[np.float64], names: Tuple[str, ...]) -> None:
        self.triangles = triangles
        self._reasons, self._apexes, self._angles, self._names = reasons, apexes, angles, names

    def __len__(self) -> int:
        return len(self.triangles)

    @overload
    def __getitem__(self, which: int) -> Exemption: ...

    @overload
    def __getitem__(self, which: slice) -> Tuple[Exemption, ...]: ...

    def __getitem__(self, which: Union[int, slice]) -> Union[Exemption, Tuple[Exemption, ...]]:
        if isinstance(which, slice):
            return tuple(self[k] for k in range(*which.indices(len(self))))
        return Exemption(int(self.triangles[which]), self._names[self._reasons[which]], int(self._apexes[which]),
                         float(self._angles[which]))

    def __iter__(self) -> Iterator[Exemption]:
        return (self[k] for k in range(len(self)))

    def counts(self) -> Dict[str, int]:
        """Their number by reason."""
        found = np.bincount(self._reasons, minlength=len(self._names))
        return {name: int(count) for name, count in zip(self._names, found) if count}

    def __repr__(self) -> str:
        return f"Exemptions({self.counts()})"


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
    restarts: how often this filling was given up. fail_test: the triangles for which ``refine_if`` is still True.
    exempt: the triangles that miss a bound. gaps: the narrow places. repairs: what ``repair=True`` changed, one
    sentence each. The times are in seconds.
    """

    goal_met: bool
    inserted: int
    segment_splits: int
    refused: int
    laid: int
    restarts: int
    fail_test: int
    exempt: Exemptions
    gaps: Tuple[Gap, ...]
    repairs: Tuple[str, ...]
    validate_seconds: float
    triangulate_seconds: float
    refine_seconds: float

    @property
    def exempt_counts(self) -> Dict[str, int]:
        """The number of exempt triangles by reason."""
        return self.exempt.counts()


def report_of(found: Mapping[str, Any]) -> Report:
    values = dict(found)
    values["exempt"] = Exemptions(*found["exempt"])
    values["gaps"] = tuple(Gap(*row) for row in found["gaps"])
    return Report(**values)
