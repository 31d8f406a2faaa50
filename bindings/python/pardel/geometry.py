"""Domains made of the shapes of other programs."""

from __future__ import annotations

import math
from typing import Any, List, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _pardel
from .domain import Domain
from .errors import InvalidInput, UsageError
from .shapes import Item, Part, parts_of

# The name of a property; a number for all; one number per geometry of the list, None or not a number for none.
Of = Union[None, str, float, Sequence[Optional[float]], npt.ArrayLike]


def geometry(shapes: Any, *, attribute: Of = None, max_area: Of = None, marker: Of = None, hole: Of = None) -> Domain:
    """The domain of geometries of shapely, of features of GeoJSON, or of anything else with ``__geo_interface__``.

    shapes: a geometry, a feature or a collection; a GeoDataFrame or a row of one; the dict of one of these; or a list.
        Polygons and lines draw segments, points are points of the domain, and so a line inside a polygon is a crack.
        The domain is the union of the polygons; what they leave out inside is a hole. Without polygons, lines bound it.
        Equal points become one, and so do the sides that polygons share. Heights are left out.
    attribute, max_area: the attribute and the largest area of the region that a polygon makes; of polygons that cover
        each other, the last one counts. marker: that of the sides; of a shared side, the first that is not 0.
        hole: True for a polygon that is a hole, whatever else covers it.
        Each is the name of a property of the features, a number for all, or a list with one number per geometry of
        `shapes`; None or not a number: none. By default, the property of the same name counts, as in a file.

    The same domain as that of a GeoJSON file (docs/formats.md). Sides that cross or overlap are problems of the domain,
    which ``repair=True`` of `mesh` mends. Each function that takes a domain takes shapes, too, with the defaults above.
    Coordinates are those of the plane. Raises `UsageError` with the place of what is wrong; also for a GeoDataFrame
    whose coordinates are degrees. O(n log n).

    >>> field = {"type": "Polygon", "coordinates": [[(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)]]}
    >>> wood = {"type": "Polygon", "coordinates": [[(4, 0), (8, 0), (8, 4), (4, 4), (4, 0)]]}
    >>> geometry([field, wood], attribute=[1, 2], max_area=[0.1, 0.5])
    Domain(6 points, 7 segments, 2 regions)
    """
    parts, items = parts_of(shapes)
    return Domain._of(_pardel.domain_of_shapes(_arrays(parts, items, [
        _whole("marker", _numbers("marker", marker, items)),
        np.nan_to_num(_numbers("hole", hole, items)) != 0,
        _numbers("attribute", attribute, items),
        _positive("max_area", _numbers("max_area", max_area, items), items),
        np.full(len(items), math.nan)])))


def lengths_of(shapes: Any, length: Of) -> _pardel.Places:
    """The places of shapes that have a length."""
    parts, items = parts_of(shapes)
    lengths = _positive("length", _numbers("length", length, items), items)
    none = np.full(len(items), math.nan)
    return _pardel.Places.of_shapes(_arrays(parts, items, [none, np.zeros(len(items)), none, none, lengths]))


def _arrays(parts: List[Part], items: List[Item], properties: List[npt.NDArray[Any]]) -> _pardel.Shapes:
    coordinates = np.concatenate([np.empty((0, 2))] + [part.coordinates for part in parts])
    shapes = _pardel.Shapes(coordinates, np.cumsum([0] + [len(part.coordinates) for part in parts]),
                            np.array([part.kind for part in parts], dtype=np.int64),
                            np.array([part.item for part in parts], dtype=np.int64),
                            np.stack([each.astype(np.float64) for each in properties], axis=1))
    wrong = _pardel.hole_outside(shapes)
    if wrong is not None:
        place = parts[wrong].place
        raise InvalidInput(f"{place} is a hole that does not lie inside the outline of its polygon, {place.rpartition('[')[0]}[0]")
    return shapes


def _numbers(name: str, of: Of, items: List[Item]) -> npt.NDArray[np.float64]:
    """One number per item; not a number: none."""
    if of is None or isinstance(of, str):
        return _of_property(of if isinstance(of, str) else name, items, name, of is not None)
    try:
        values = np.asarray([math.nan if each is None else each for each in of]
                            if isinstance(of, (list, tuple)) else of, dtype=np.float64)
    except (TypeError, ValueError):
        raise UsageError(f"{name} is {of!r}; the name of a property, a number, or a list of numbers is "
                         f"needed") from None
    if values.ndim == 0:
        return np.full(len(items), values)
    needed = 1 + max((item.number for item in items), default=-1)
    if values.ndim != 1 or len(values) < needed:
        raise UsageError(f"{name} has the shape {values.shape}; ({needed},) is needed, one number per geometry")
    return values[[item.number for item in items]]


def _of_property(key: str, items: List[Item], name: str, is_asked: bool) -> npt.NDArray[np.float64]:
    found = [item.properties.get(key) for item in items]
    if is_asked and items and not any(key in item.properties for item in items):
        known = sorted({str(each) for item in items for each in item.properties.keys()})
        raise UsageError(f"{name} is {key!r}, and no feature has this property; "
                         + (f"there are {', '.join(known)}" if known else "the features have no properties"))
    return np.array([_number(value, key, item) for value, item in zip(found, items)], dtype=np.float64)


def _number(value: Any, key: str, item: Item) -> float:
    if value is None:
        return math.nan
    if not isinstance(value, (str, bytes)):
        try:
            return float(value)
        except (TypeError, ValueError):
            pass
    raise UsageError(f"{item.place}: the property {key!r} is {value!r}; a number is needed")


def _whole(name: str, values: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    given = values[~np.isnan(values)]
    wrong = np.flatnonzero((given != np.floor(given)) | (np.abs(given) > np.iinfo(np.int32).max))
    if wrong.size:
        raise UsageError(f"{name} has the number {given[wrong[0]]}, which is no 32-bit integer")
    return values


def _positive(name: str, values: npt.NDArray[np.float64], items: List[Item]) -> npt.NDArray[np.float64]:
    wrong = np.flatnonzero((values <= 0) | (np.isinf(values) & (name == "length")))
    if wrong.size:
        place = items[wrong[0]].place
        raise UsageError(f"{name} of {place} is {values[wrong[0]]}; a {'finite ' if name == 'length' else ''}"
                         f"number greater than 0 is needed")
    return values
