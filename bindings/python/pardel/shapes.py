"""The shapes of other programs: geometries with ``__geo_interface__``, their features, and lists of them."""

from __future__ import annotations

import os
from typing import Any, Callable, Iterator, List, Mapping, NamedTuple, Tuple

import numpy as np

from .arrays import Numbers
from .errors import UsageError

# As in src/bind_shapes.cpp.
POINTS, LINE, OUTER_RING, INNER_RING = range(4)

_MOST_LEVELS = 16


class Part(NamedTuple):
    """Points, a line or a ring of a shape; rings of holes follow their outer ring. item: the shape that it is of."""

    kind: int
    coordinates: Numbers
    item: int
    place: str


class Item(NamedTuple):
    """A geometry with the properties of its feature. number: its index in the list that was given."""

    properties: Mapping[str, Any]
    number: int
    place: str


def _has_interface(value: Any) -> bool:
    """Asks the class first: to compute the coordinates of a geometry takes long."""
    return hasattr(type(value), "__geo_interface__") or hasattr(value, "__geo_interface__")


def is_shape(value: Any) -> bool:
    """True for a geometry, a feature or a collection, also as a dict, and for a row of a GeoDataFrame."""
    if isinstance(value, Mapping):
        return "type" in value
    return _has_interface(value) or _has_interface(getattr(value, "geometry", None))


def is_shapes(value: Any) -> bool:
    """True for a shape, and for a list, a tuple or an array of objects that begins with one."""
    if is_shape(value):
        return True
    has_objects = isinstance(value, (list, tuple)) or getattr(getattr(value, "dtype", None), "kind", None) == "O"
    return has_objects and len(value) > 0 and is_shape(next(iter(value)))


def parts_of(shapes: Any) -> Tuple[List[Part], List[Item]]:
    """All parts, and the items to which they belong. Raises `UsageError` with the place of what is wrong."""
    reader = _Reader()
    if isinstance(shapes, (str, os.PathLike)):
        raise UsageError("a geometry is needed, and this is text: pardel.read reads the domain in a file, and "
                         "json.loads and shapely.wkt.loads make geometries of text")
    if is_shape(shapes):
        reader.read(shapes, "the geometry", {}, None, 0)
    else:
        try:
            members = list(shapes)
        except TypeError:
            raise UsageError(f"a geometry is needed: an object with __geo_interface__, a dict of GeoJSON, or a list of "
                             f"them; this is a {type(shapes).__name__}") from None
        for number, shape in enumerate(members):
            reader.read(shape, f"geometry {number}", {}, number, 0)
    return reader.parts, reader.items


def _refuse_degrees(value: Any, place: str) -> None:
    if getattr(getattr(value, "crs", None), "is_geographic", False) is True:
        raise UsageError(f"{place} has the coordinate system {value.crs}: its coordinates are degrees, in which angles "
                         f"and lengths have no meaning; project it first, for example with "
                         f"to_crs(frame.estimate_utm_crs()), or give its __geo_interface__ to mesh in degrees")


class _Reader:
    def __init__(self) -> None:
        self.parts: List[Part] = []
        self.items: List[Item] = []

    def read(self, shape: Any, place: str, properties: Mapping[str, Any], number: Any, level: int) -> None:
        """number: the index of the shape in the list that was given; None: features of a collection count."""
        if level > _MOST_LEVELS:
            raise UsageError(f"{place} has more than {_MOST_LEVELS} collections in each other")
        _refuse_degrees(shape, place)
        if not isinstance(shape, Mapping) and not _has_interface(shape):
            return self._read_row(shape, place, number, level)
        if getattr(shape, "is_empty", False) is True:
            return None
        known = shape if isinstance(shape, Mapping) else shape.__geo_interface__
        if not isinstance(known, Mapping):
            raise UsageError(f"{place} has a __geo_interface__ that is a {type(known).__name__}; a dict is needed")
        kind = known.get("type")
        if kind == "FeatureCollection":
            for k, feature in enumerate(_listed(known, "features", place)):
                self.read(feature, f"{place}.features[{k}]", {}, k if number is None else number, level + 1)
        elif kind == "Feature":
            if known.get("geometry") is not None:
                self.read(known["geometry"], f"{place}.geometry", _properties(known, place), number, level + 1)
        elif kind == "GeometryCollection":
            for k, each in enumerate(_listed(known, "geometries", place)):
                self.read(each, f"{place}.geometries[{k}]", properties, number, level + 1)
        else:
            self._read_geometry(kind, known, place, Item(properties, 0 if number is None else number, place))
        return None

    def _read_row(self, row: Any, place: str, number: Any, level: int) -> None:
        """A row of a GeoDataFrame: a pandas.Series, or a named tuple."""
        geometry = getattr(row, "geometry", None)
        if not _has_interface(geometry):
            raise UsageError(f"{place} is a {type(row).__name__}; an object with __geo_interface__ or a dict of "
                             f"GeoJSON is needed")
        self.read(geometry, place, row._asdict() if hasattr(row, "_asdict") else row, number, level + 1)

    def _read_geometry(self, kind: Any, known: Mapping[str, Any], place: str, item: Item) -> None:
        readers: Mapping[Any, Tuple[Callable[[Any, str, int], None], int]] = {
            "Point": (self._read_point, 0), "MultiPoint": (self._read_points, 0),
            "LineString": (self._read_line, 0), "LinearRing": (self._read_line, 0),
            "MultiLineString": (self._read_line, 1),
            "Polygon": (self._read_polygon, 0), "MultiPolygon": (self._read_polygon, 1)}
        if kind not in readers:
            raise UsageError(f"{place} has the type {kind!r}; one of {', '.join(readers)}, GeometryCollection, Feature "
                             f"or FeatureCollection is needed")
        self.items.append(item)
        read, depth = readers[kind]
        coordinates, at = _listed(known, "coordinates", place), f"{place}.coordinates"
        if depth == 0:
            read(coordinates, at, len(self.items) - 1)
        else:
            for each, its_place in _each(coordinates, at):
                read(each, its_place, len(self.items) - 1)

    def _read_point(self, coordinates: Any, place: str, item: int) -> None:
        self.parts.append(Part(POINTS, _positions([coordinates], place, "a position"), item, place))

    def _read_points(self, coordinates: Any, place: str, item: int) -> None:
        if len(coordinates) > 0:
            self.parts.append(Part(POINTS, _positions(coordinates, place, "positions"), item, place))

    def _read_line(self, coordinates: Any, place: str, item: int) -> None:
        line = _positions(coordinates, place, "a line")
        if len(line) < 2:
            raise UsageError(f"{place} has {len(line)} positions; a line needs two")
        self.parts.append(Part(LINE, line, item, place))

    def _read_polygon(self, coordinates: Any, place: str, item: int) -> None:
        for k, (each, its_place) in enumerate(_each(coordinates, place)):
            ring = _positions(each, its_place, "a ring")
            if len(ring) < 4 or not np.array_equal(ring[0], ring[-1]):
                raise UsageError(f"{its_place} is no ring; a ring has at least four positions, and ends where it "
                                 f"begins")
            self.parts.append(Part(INNER_RING if k else OUTER_RING, ring[:-1], item, its_place))


def _properties(feature: Mapping[str, Any], place: str) -> Mapping[str, Any]:
    properties = feature.get("properties")
    if properties is None:
        return {}
    if not hasattr(properties, "get"):
        raise UsageError(f"{place}.properties is a {type(properties).__name__}; a dict is needed")
    return properties  # type: ignore[no-any-return]


def _listed(known: Mapping[str, Any], key: str, place: str) -> Any:
    found = known.get(key)
    if isinstance(found, (str, bytes, Mapping)) or not hasattr(found, "__len__"):
        raise UsageError(f"{place}.{key} is a {type(found).__name__}; a list is needed")
    return found


def _each(coordinates: Any, place: str) -> Iterator[Tuple[Any, str]]:
    for k, each in enumerate(coordinates):
        if not hasattr(each, "__len__"):
            raise UsageError(f"{place}[{k}] is a {type(each).__name__}; a list of positions is needed")
        yield each, f"{place}[{k}]"


def _positions(coordinates: Any, place: str, what: str) -> Numbers:
    """Shape (n, 2). A third coordinate is left out."""
    try:
        if any(isinstance(each, str) for each in coordinates[0]):
            raise ValueError
        try:
            array = np.asarray(coordinates, dtype=np.float64)[:, :2]
        except ValueError:  # some positions have a height, and others have none
            array = np.asarray([each[:2] for each in coordinates], dtype=np.float64)
    except (TypeError, ValueError, LookupError):
        array = np.empty(0)
    if array.ndim != 2 or array.shape[1] != 2:
        raise UsageError(f"{place} is not {what}; a position is two or three numbers")
    wrong = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if wrong.size:
        raise UsageError(f"{place}[{wrong[0]}] has a coordinate that is not finite")
    return array
