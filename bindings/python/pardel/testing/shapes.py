"""Polygons and paths of points with integer coordinates. All tests are exact."""

from __future__ import annotations

from fractions import Fraction
from typing import List, Optional, Sequence, Tuple

Place = Tuple[float, float]
Places = Sequence[Place]


def turn(a: Place, b: Place, c: Place) -> int:
    """1 if a, b, c turn to the left, -1 if to the right, 0 if they are on one line. Exact for all doubles."""
    if not all(isinstance(number, int) for place in (a, b, c) for number in place):
        a, b, c = (_exact(place) for place in (a, b, c))
    twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (twice > 0) - (twice < 0)


def _exact(place: Place) -> Place:
    return Fraction(place[0]), Fraction(place[1])  # type: ignore[return-value]


def _is_ahead(at: Place, first: Place, second: Place) -> bool:
    """Whether two places lie in the same direction from a third one."""
    return turn(at, first, second) == 0 and (
        (first[0] - at[0]) * (second[0] - at[0]) + (first[1] - at[1]) * (second[1] - at[1]) > 0)


def _is_between(a: Place, b: Place, c: Place) -> bool:
    """Whether c, on the line through a and b, is on the segment from a to b."""
    return min(a[0], b[0]) <= c[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= c[1] <= max(a[1], b[1])


def touch(a: Place, b: Place, c: Place, d: Place) -> bool:
    """Whether the segments ab and cd have a place in common."""
    sides = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0:
        return True
    return ((sides[0] == 0 and _is_between(a, b, c)) or (sides[1] == 0 and _is_between(a, b, d)) or
            (sides[2] == 0 and _is_between(c, d, a)) or (sides[3] == 0 and _is_between(c, d, b)))


def _fits(ring: Places, edge: int, place: Place) -> bool:
    """Whether a polygon stays simple when a place is inserted on the way from corner `edge` to the next one."""
    count = len(ring)
    start, end = ring[edge], ring[(edge + 1) % count]
    if _is_ahead(place, start, end):
        return False
    before, after = ring[edge - 1], ring[(edge + 2) % count]
    if _is_ahead(start, before, place) or _is_ahead(end, after, place):
        return False
    for other in range(count):
        if other == edge:
            continue
        ends = ring[other], ring[(other + 1) % count]
        if start not in ends and touch(start, place, *ends) or end not in ends and touch(place, end, *ends):
            return False
        if turn(*ends, place) == 0 and _is_between(*ends, place):
            return False
    return True


def simple_polygon(places: Places, first_edges: Sequence[int]) -> List[Place]:
    """A polygon that does not touch itself, with most of the places as corners, at least three.

    It begins as a triangle, and each further place becomes a corner between two others, the first possible pair from
    the one that first_edges, one number per place, says. Places that fit nowhere are left out. If all places are on one
    line, the polygon is a triangle over the first two.
    """
    third = next((k for k in range(2, len(places)) if turn(places[0], places[1], places[k])), None)
    if third is None:
        (x, y), (to_x, to_y) = places[:2]
        return [places[0], places[1], (x - to_y + y, y + to_x - x)]
    ring = [places[0], places[1], places[third]]
    for place, first in zip(places[2:], first_edges[2:]):
        if place not in ring:
            fitting = [k % len(ring) for k in range(first, first + len(ring)) if _fits(ring, k % len(ring), place)]
            if fitting:
                ring.insert(fitting[0] + 1, place)
    return ring


def place_inside(a: Place, b: Place, c: Place) -> Optional[Place]:
    """A place strictly inside a triangle with as few digits as possible; None if no rounded centroid is inside."""
    middle = sum(p[0] for p in (a, b, c)) / 3, sum(p[1] for p in (a, b, c)) / 3
    side = turn(a, b, c)
    for digits in (0, 1, 2, 3, 17):
        place = round(middle[0], digits), round(middle[1], digits)
        if side == turn(a, b, place) == turn(b, c, place) == turn(c, a, place) != 0:
            return place
    return None
