"""The exceptions of the package, one class per kind of error of the library."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Sequence, Tuple

Coordinates = Tuple[float, float]


@dataclass(frozen=True)
class Problem:
    """One problem of a domain.

    kind: its kind, for example ``"crossing_segments"`` or ``"duplicate_points"``.
    ids: the points, segments, holes or regions concerned, counted from 0; the text says which they are.
    coordinates: (x, y) of the place.
    text: one sentence with the ids and the coordinates.
    """

    kind: str
    ids: Tuple[int, ...]
    coordinates: Coordinates
    text: str

    def __str__(self) -> str:
        return self.text


class Error(Exception):
    """The base class of all exceptions of the package."""


class UsageError(Error, ValueError):
    """An argument is wrong: its shape, its type, or a value out of range."""


class InvalidInput(Error, ValueError):
    """A domain or a mesh cannot be used.

    ``problems`` is a tuple of `Problem`; empty if the error is not about the points and segments of a domain.
    """

    def __init__(self, message: str, problems: Sequence[Problem] = ()) -> None:
        super().__init__(message)
        self.problems: Tuple[Problem, ...] = tuple(problems)


class FileError(Error, OSError):
    """A file could not be opened, read or written."""


class ResourceError(Error, MemoryError):
    """Not enough memory, or more triangles than their numbers can count."""


class Cancelled(Error):
    """The function ``progress`` returned False."""


class InternalError(Error, RuntimeError):
    """A self-check of the library failed: the library is wrong, not the input. Please report it."""


_CLASSES = {
    "usage": UsageError,
    "io": FileError,
    "resources": ResourceError,
    "cancelled": Cancelled,
    "internal": InternalError,
}
# What the library calls an argument, and what it is here.
_NAMES = (("Goal::size_slope", "size"), ("Goal::min_angle_deg", "min_angle"), ("Goal::feature_edges", "feature_size"),
          ("Goal::", ""), ("Options::", ""))


def problems_of(rows: Sequence[Tuple[str, Tuple[int, ...], Coordinates, str]]) -> Tuple[Problem, ...]:
    return tuple(Problem(*row) for row in rows)


def exception_of(kind: str, message: str,
                 problems: Sequence[Tuple[str, Tuple[int, ...], Coordinates, str]]) -> Error:
    """The exception for an error of the library; the module calls this."""
    for theirs, ours in _NAMES:
        message = message.replace(theirs, ours)
    if kind == "invalid_input":
        return InvalidInput(message, problems_of(problems))
    return _CLASSES[kind](message)
