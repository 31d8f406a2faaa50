"""Domains made of polygons."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from .domain import Domain
from .errors import InvalidInput, UsageError


def polygon(outline: npt.ArrayLike, *inner: npt.ArrayLike) -> Domain:
    """The domain inside a polygon, without the polygons inside it.

    outline, inner: shape (n, 2): the corners in their order, in either direction, each once or with the first one again
    at the end. The inner ones become holes.

    Raises `UsageError` for a wrong shape, and `InvalidInput` for an inner polygon that crosses itself or lies
    outside the outline.

    >>> polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (2, 1), (2, 2)])
    Domain(7 points, 7 segments, 1 holes)
    """
    rings = [_ring(ring) for ring in (outline, *inner)]
    for k, ring in enumerate(rings[1:]):
        if _pardel.lies_outside(ring, rings[0]):
            raise InvalidInput(f"inner polygon {k} does not lie inside the outline")
    starts = np.cumsum([0, *map(len, rings)])
    ends = [np.stack([start + np.arange(len(ring)), start + np.roll(np.arange(len(ring)), -1)], axis=1)
            for start, ring in zip(starts, rings)]
    holes = [_place_inside(ring) for ring in rings[1:]]
    return Domain(np.concatenate(rings), np.concatenate(ends), holes=holes or None)


def _ring(corners: npt.ArrayLike) -> arrays.Numbers:
    if len(arrays.shape("a polygon", corners)) == 3:
        raise UsageError("a polygon is a list of polygons; each one is an argument: polygon(outline, first, second)")
    ring = arrays.numbers("a polygon", corners, 2)
    if len(ring) > 1 and np.array_equal(ring[0], ring[-1]):
        ring = ring[:-1]
    if len(ring) < 3:
        raise UsageError(f"a polygon has {len(ring)} corners; at least 3 are needed")
    return ring


def _place_inside(ring: arrays.Numbers) -> arrays.Numbers:
    """The centroid of the largest triangle of the polygon."""
    goal = _pardel.Goal()
    goal.min_angle = 0
    core, _ = _pardel.mesh(polygon(ring)._core, goal, _pardel.Options(), _pardel.Sizes(), False, None, None)
    corners = core.points[core.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    largest = np.argmax(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    place: arrays.Numbers = corners[largest].mean(axis=0)
    return place
