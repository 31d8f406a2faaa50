"""Strategies of Hypothesis for domains. All domains are valid, by construction; they shrink to few points and small
whole numbers."""

from __future__ import annotations

from typing import Dict, Iterable, List, Optional, Sequence, Tuple, Union

from hypothesis import strategies as st

from ..domain import Domain
from ..errors import UsageError
from ..validation import validate
from .drafts import Corners, Draft, Lattice, mapped
from .shapes import Place, simple_polygon, touch, turn

_SCALE = 6  # of polygons in whose triangles something is put, at places of a lattice
_LATTICE = [(i, j) for i in range(1, 5) for j in range(1, 6 - i)]


def _grid(reach: int) -> st.SearchStrategy[Place]:
    return st.tuples(st.integers(-reach, reach), st.integers(-reach, reach))


@st.composite
def _rings(draw: st.DrawFn, most: int = 10, reach: int = 8) -> List[Place]:
    """The corners of a simple polygon."""
    places = draw(st.lists(_grid(reach), min_size=3, max_size=most, unique=True))
    return simple_polygon(places, [draw(st.integers(0, k)) for k in range(len(places))])


@st.composite
def _scaled(draw: st.DrawFn) -> Draft:
    return Draft([(x * _SCALE, y * _SCALE) for x, y in draw(_rings(most=7, reach=4))])


def _polygons() -> st.SearchStrategy[Domain]:
    return _rings().map(lambda ring: Draft(ring).domain())


@st.composite
def _chosen(draw: st.DrawFn, draft: Draft, least: int, most: int) -> List[Tuple[Corners, Lattice]]:
    """Some triangles of a draft, each with one to six places of the lattice in it."""
    triangles = draft.triangles()
    chosen = draw(st.lists(st.integers(0, len(triangles) - 1), min_size=least, max_size=most, unique=True))
    lattice = st.lists(st.sampled_from(_LATTICE), min_size=1, max_size=6, unique=True)
    return [(draft.corners(triangles[k]), draw(lattice)) for k in chosen]


def _ring_in(corners: Corners, lattice: Lattice) -> List[Place]:
    """A polygon in a triangle, of places of the lattice if they are not on one line."""
    for chosen in (lattice, [(1, 1), (1, 2), (2, 1)]):
        places = mapped(corners, chosen)
        if any(turn(places[0], places[-1], place) for place in places):
            break
    return simple_polygon(places, [0] * len(places))


@st.composite
def _with_holes(draw: st.DrawFn) -> Draft:
    draft = draw(_scaled())
    for corners, lattice in draw(_chosen(draft, 1, 3)):
        ring = _ring_in(corners, lattice)
        if draw(st.booleans()) and not any(touch(corners[0], ring[0], a, b) for a, b in zip(ring[1:], ring[2:])) \
                and turn(corners[0], ring[0], ring[1]) != 0 != turn(corners[0], ring[0], ring[-1]):
            draft.add((corners[0], ring[0]))  # a segment from the hole to a corner
        draft.add_hole(ring)
    return draft


@st.composite
def _cracks(draw: st.DrawFn) -> Domain:
    draft = draw(_scaled())
    for corners, lattice in draw(_chosen(draft, 1, 3)):
        places = mapped(corners, lattice)
        path = simple_polygon(places, [0] * len(places)) if len(places) > 2 else places
        path = [place for place in path if place in places]
        hangs = draw(st.booleans()) and not any(touch(corners[0], path[0], *ends) for ends in zip(path[1:], path[2:]))
        if hangs and (len(path) < 2 or turn(corners[0], path[0], path[1]) != 0):
            path = [corners[0], *path]
        draft.add(path)
    return draft.domain()


@st.composite
def _regions(draw: st.DrawFn) -> Domain:
    draft = Draft(draw(_rings()))
    walls = {frozenset(ends) for ends in draft.segments}
    inner = sorted({(min(a, b), max(a, b)) for t in draft.triangles() for a, b in zip(t, (*t[1:], t[0]))
                    if frozenset((a, b)) not in walls})
    if inner:
        draft.segments += draw(st.lists(st.sampled_from(inner), min_size=1, unique=True))
    draft.add_regions()
    return draft.domain()


@st.composite
def _small_angles(draw: st.DrawFn) -> Domain:
    """Segments that leave one point in nearly the same direction; their ends are joined."""
    tip = st.tuples(st.integers(4, 200), st.integers(0, 8))
    tips: List[Place] = draw(st.lists(tip, min_size=2, max_size=6, unique=True))
    directions: List[Place] = []
    for end in sorted(tips, key=lambda end: end[1] / end[0]):
        if not directions or turn((0, 0), directions[-1], end) > 0:
            directions.append(end)
    if len(directions) < 2:
        directions.append((directions[0][0], directions[0][1] + 1))
    draft = Draft([(0, 0), *directions])
    for end in directions[1:-1]:
        if draw(st.booleans()):
            draft.add([(0, 0), end])
    return draft.domain()


def _nearly(number: float, units: int) -> float:
    """A number moved by a few of its units in the last place, of 1 if it is smaller."""
    return number + units * 2.0**-52 * max(abs(number), 1)


@st.composite
def _near_degenerate(draw: st.DrawFn) -> Domain:
    """Polygons with corners moved by rounding errors, with chains that are nearly straight, and narrow gaps."""
    ring: List[Place] = draw(_rings(most=6, reach=4))
    free: List[Place] = []
    domain = Draft(ring).domain()
    units, step = st.integers(-4, 4), st.sampled_from(["chain", "move", "gap"])
    for kind, index, right, up in draw(st.lists(st.tuples(step, st.integers(0, 9), units, units), min_size=1,
                                                max_size=4)):
        index %= len(ring)
        (x, y), (to_x, to_y) = ring[index], ring[(index + 1) % len(ring)]
        new, isolated = list(ring), list(free)
        if kind == "move":
            new[index] = _nearly(x, right), _nearly(y, up)
        elif kind == "chain":
            new.insert(index + 1, (_nearly((x + to_x) / 2, right), _nearly((y + to_y) / 2, up)))
        else:
            gap = 2.0**-(12 + up) * (1 if right % 2 else -1)
            isolated.append(((x + to_x) / 2 - gap * (to_y - y), (y + to_y) / 2 + gap * (to_x - x)))
        draft = Draft(new)
        for place in isolated:
            draft.add([place])
        if not validate(draft.domain(), threads=1):
            ring, free, domain = new, isolated, draft.domain()
    return domain


@st.composite
def _points(draw: st.DrawFn) -> Domain:
    """Points of a grid, so many of them are on one line or on one circle."""
    places = draw(st.lists(_grid(8), min_size=3, max_size=20, unique=True))
    if not any(turn(places[0], places[1], place) for place in places):
        places = simple_polygon(places, [0] * len(places))
    draft = Draft()
    for place in places:
        draft.add([place])
    return draft.domain()


@st.composite
def _large_offsets(draw: st.DrawFn) -> Domain:
    """Polygons with holes, far from the origin: their coordinates agree in most digits."""
    draft = draw(st.one_of(_rings().map(Draft), _with_holes()))
    power, right, up = draw(st.integers(3, 9)), draw(st.integers(-1, 1)), draw(st.integers(-1, 1))
    return draft.domain((right * 10.0**power, up * 10.0**power))


_STRATEGIES: Dict[str, st.SearchStrategy[Domain]] = {
    "points": _points(),
    "polygons": _polygons(),
    "holes": _with_holes().map(Draft.domain),
    "cracks": _cracks(),
    "regions": _regions(),
    "small_angles": _small_angles(),
    "near_degenerate": _near_degenerate(),
    "large_offsets": _large_offsets(),
}
FAMILIES: Tuple[str, ...] = tuple(_STRATEGIES)
Family = Union[str, st.SearchStrategy[Domain]]


def named(families: Optional[Union[Family, Iterable[Family]]]) -> Dict[str, st.SearchStrategy[Domain]]:
    """The strategies of families by name; those of the caller are named by their numbers."""
    if families is None:
        return dict(_STRATEGIES)
    given: Sequence[Family] = ([families] if isinstance(families, (str, st.SearchStrategy)) else list(families))
    if not given:
        raise UsageError("families is empty; at least one is needed")
    found: Dict[str, st.SearchStrategy[Domain]] = {}
    for index, family in enumerate(given):
        if isinstance(family, st.SearchStrategy):
            found[f"families[{index}]"] = family
        elif family in _STRATEGIES:
            found[family] = _STRATEGIES[family]
        else:
            raise UsageError(f"families[{index}] is {family!r}; the families are {', '.join(FAMILIES)}")
    return found


def domains(*families: Family) -> st.SearchStrategy[Domain]:
    """A strategy for domains of these families; without arguments, of all.

    The families, each a name in ``FAMILIES``; a strategy of your own for domains can stand beside them:
      points: points of a grid and no segments; the domain is their convex hull.
      polygons: simple polygons. holes: with one to three holes, some tied to the boundary by a segment.
      cracks: polygons with paths of segments inside that end in the domain, and with isolated points.
      regions: polygons that segments divide, with one place in each part.
      small_angles: segments that leave a point at small angles, down to a thousandth of a degree.
      near_degenerate: rounding errors in corners, chains that are nearly straight, points close to segments.
      large_offsets: polygons, with and without holes, up to 10**9 away from the origin.

    Each domain is valid (`pardel.validate`). Raises `UsageError` for a name that is not one of these.

    >>> import pardel
    >>> from hypothesis import given
    >>> @given(domains("polygons", "holes"))
    ... def test_areas(domain):
    ...     assert pardel.mesh(domain).area() > 0
    >>> test_areas()
    """
    return st.one_of(*named(families or None).values())
