"""Triangle's files as dictionaries of arrays."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Optional, Union

import numpy as np
import numpy.typing as npt

from ...errors import FileError, InvalidInput

Dictionary = Dict[str, npt.NDArray[Any]]

_SUFFIXES = ("node", "ele", "poly", "area", "edge", "neigh")


def load(directory: Union[str, "os.PathLike[str]"], name: str) -> Dictionary:
    """What the files NAME.node, .ele, .poly, .area, .edge and .neigh in a folder have, as `loads` returns it.

    Raises `FileError` if there is none of them, or one cannot be read; `InvalidInput` with the line.
    """
    texts = {}
    for suffix in _SUFFIXES:
        file = os.path.join(directory, f"{name}.{suffix}")
        if os.path.exists(file):
            try:
                with open(file, encoding="utf-8") as text:
                    texts[suffix] = text.read()
            except (OSError, UnicodeDecodeError) as error:
                raise FileError(f"{file}: {error}") from None
    if not texts:
        raise FileError(f"{os.path.join(directory, name)}: there is no file with this name and one of the suffixes "
                        f"{', '.join(_SUFFIXES)}")
    return loads(**texts)


def loads(node: Optional[str] = None, ele: Optional[str] = None, poly: Optional[str] = None,
          area: Optional[str] = None, edge: Optional[str] = None, neigh: Optional[str] = None) -> Dictionary:
    """What the texts of Triangle's files have. Numbers of vertices and triangles begin at 0 in the arrays.

    Keys: those of `triangulate`; triangle_neighbors for `neigh`; ray_origins and ray_directions for rays in `edge`.
    Raises `InvalidInput` with the line.

    >>> loads(node="3 2 0 0  # a comment", ele=None)
    Traceback (most recent call last):
    pardel.errors.InvalidInput: the .node ends before vertex 0 of 3
    >>> loads(node="3 2 0 0\\n1 0 0\\n2 1 0\\n3 0 1", ele="1 3 0\\n1 1 2 3")["triangles"].tolist()
    [[0, 1, 2]]
    """
    data: Dictionary = {}
    base = 0
    if node:
        base = _points(_Records("node", node), data, base)
    in_poly = None if not poly else _Records("poly", poly)
    if in_poly is not None:
        base = _points(in_poly, data, base)
    if ele:
        _triangles(_Records("ele", ele), data, base)
    if in_poly is not None:
        _rest_of_poly(in_poly, data, base)
    if area:
        records = _Records("area", area)
        (count,) = records.header(1, [])
        _store(data, "triangle_max_area", records.table("triangle", count, 2)[:, 1:])
    if edge:
        _edges(_Records("edge", edge), data, base)
    if neigh:
        records = _Records("neigh", neigh)
        count, columns = records.header(1, [3])
        across = records.integers("triangle", count, 1 + columns)[:, 1:]
        _store(data, "triangle_neighbors", np.where(across < 0, -1, across - base).astype(np.int32))
    return data


class _Records:
    """The lines of a file with something on them, one after another. Comments are left out."""

    def __init__(self, suffix: str, text: str) -> None:
        self.suffix = suffix
        fields = [line.split("#")[0].split() for line in text.splitlines()]
        self._lines = [(number, line) for number, line in enumerate(fields, 1) if line]

    def __bool__(self) -> bool:
        return bool(self._lines)

    def header(self, needed: int, defaults: List[int]) -> List[int]:
        """Integers; those that the line lacks have defaults."""
        if not self._lines:
            raise InvalidInput(f"the .{self.suffix} ends before a header")
        number, line = self._lines.pop(0)
        numbers = [self._integer(number, field) for field in line[:needed + len(defaults)]]
        if len(numbers) < needed:
            raise InvalidInput(f"the .{self.suffix} has {len(numbers)} numbers on line {number}; {needed} are needed")
        return numbers + defaults[len(numbers) - needed:]

    def rows(self, what: str, count: int, columns: int, surplus: int = 0) -> List[List[str]]:
        """The fields of the next `count` lines: `columns`, and at most `surplus` ones that a line need not have."""
        found = []
        for k in range(count):
            if not self._lines:
                raise InvalidInput(f"the .{self.suffix} ends before {what} {k} of {count}")
            number, line = self._lines.pop(0)
            if len(line) < columns:
                raise InvalidInput(f"the .{self.suffix} has {len(line)} fields on line {number}; {columns} are needed")
            found.append(line[:columns + surplus])
            self._check(number, found[-1])
        return found

    def table(self, what: str, count: int, columns: int) -> npt.NDArray[np.float64]:
        return np.array(self.rows(what, count, columns), dtype=np.float64).reshape(count, columns)

    def integers(self, what: str, count: int, columns: int) -> npt.NDArray[np.int64]:
        return _whole(self.table(what, count, columns), f"a {what} of the .{self.suffix}")

    def all_lines(self) -> List[List[str]]:
        for number, line in self._lines:
            self._check(number, line)
        return [line for _, line in self._lines]

    def _check(self, number: int, fields: List[str]) -> None:
        for field in fields:
            try:
                float(field)
            except ValueError:
                raise InvalidInput(f"the .{self.suffix} has {field!r} on line {number}; a number is needed") from None

    def _integer(self, number: int, field: str) -> int:
        if not field.lstrip("+").isdigit():
            raise InvalidInput(f"the .{self.suffix} has {field!r} on line {number}; a number of things is needed")
        return int(field)


def _store(data: Dictionary, key: str, rows: npt.NDArray[Any]) -> None:
    """A key without rows is absent."""
    if rows.size:
        data[key] = np.ascontiguousarray(rows)


def _points(records: _Records, data: Dictionary, base: int) -> int:
    """Returns the number of the first vertex; `base` if there is none."""
    count, dimensions, attributes, markers = records.header(1, [2, 0, 0])
    if count == 0:
        return base
    if dimensions != 2:
        raise InvalidInput(f"the .{records.suffix} has points with {dimensions} coordinates; 2 are needed")
    rows = records.table("vertex", count, 3 + attributes + min(markers, 1))
    if rows[0, 0] not in (0, 1) or not np.array_equal(rows[:, 0], rows[0, 0] + np.arange(count)):
        raise InvalidInput(f"the .{records.suffix} has vertices whose numbers are not 0, 1, 2, ... or 1, 2, 3, ...")
    data["vertices"] = np.ascontiguousarray(rows[:, 1:3])
    _store(data, "vertex_attributes", rows[:, 3:3 + attributes])
    _store(data, "vertex_markers", rows[:, 3 + attributes:].astype(np.int32))
    return int(rows[0, 0])


def _triangles(records: _Records, data: Dictionary, base: int) -> None:
    count, nodes, attributes = records.header(1, [3, 0])
    rows = records.table("triangle", count, 1 + nodes + attributes)
    _store(data, "triangles", (_whole(rows[:, 1:1 + nodes], "a triangle of the .ele") - base).astype(np.int32))
    _store(data, "triangle_attributes", rows[:, 1 + nodes:])


def _whole(numbers: npt.NDArray[np.float64], what: str) -> npt.NDArray[np.int64]:
    whole = numbers.astype(np.int64)
    if not np.array_equal(whole, numbers):
        raise InvalidInput(f"{what} has a number that is not an integer")
    return whole


def _rest_of_poly(records: _Records, data: Dictionary, base: int) -> None:
    count, markers = records.header(1, [0])
    rows = records.integers("segment", count, 3 + min(markers, 1))
    _store(data, "segments", (rows[:, 1:3] - base).astype(np.int32))
    _store(data, "segment_markers", rows[:, 3:].astype(np.int32))
    (count,) = records.header(1, [])
    _store(data, "holes", records.table("hole", count, 3)[:, 1:])
    if not records:
        return
    (count,) = records.header(1, [])
    # One number after the place is the attribute and the largest area.
    lines = [line if len(line) == 5 else [*line, line[3]] for line in records.rows("region", count, 4, surplus=1)]
    _store(data, "regions", np.array(lines, dtype=np.float64).reshape(count, 5)[:, 1:])


def _edges(records: _Records, data: Dictionary, base: int) -> None:
    """Edges, and rays: a ray has -1 instead of its second end, and then a direction."""
    count, markers = records.header(1, [0])
    lines = records.all_lines()[:count]
    short = [line for line in lines if len(line) < (5 if len(line) > 2 and line[2] == "-1" else 3 + min(markers, 1))]
    if len(lines) < count or short:
        raise InvalidInput(f"the .edge has fewer than {count} edges, or one with too few fields")
    edges = [line for line in lines if line[2] != "-1"]
    rays = [line for line in lines if line[2] == "-1"]
    of_edges = np.array([line[:3 + min(markers, 1)] for line in edges], dtype=np.float64)
    of_rays = np.array([line[:5] for line in rays], dtype=np.float64)
    if edges:
        _store(data, "edges", (of_edges[:, 1:3] - base).astype(np.int32))
        _store(data, "edge_markers", of_edges[:, 3:].astype(np.int32))
    if rays:
        _store(data, "ray_origins", (of_rays[:, 1:2] - base).astype(np.int32))
        _store(data, "ray_directions", of_rays[:, 3:])
