"""The figures of the examples."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence, Tuple

import numpy as np
import numpy.typing as npt

Dictionary = Dict[str, npt.NDArray[Any]]
Places = Sequence[Tuple[float, float]]


def _domain(loops: Sequence[Places], holes: Places = ()) -> Dictionary:
    """Closed polygons. The sides of the first one have the marker 1, those of the next ones 2, 3 and so on."""
    segments: List[Tuple[int, int]] = []
    markers: List[int] = []
    for k, loop in enumerate(loops):
        first, count = len(segments), len(loop)
        segments += [(first + i, first + (i + 1) % count) for i in range(count)]
        markers += [k + 1] * count
    figure = dict(vertices=np.concatenate([np.asarray(loop, dtype=np.float64) for loop in loops]),
                  segments=np.array(segments, dtype=np.int32),
                  segment_markers=np.array(markers, dtype=np.int32).reshape(-1, 1))
    if holes:
        figure["holes"] = np.array(holes, dtype=np.float64)
    return figure


def _ring(x: float, y: float, radius: float, corners: int, per_side: int = 1, height: float = 1) -> Places:
    """A regular polygon, with points on its sides; `height`: its height divided by its width."""
    angles = 2 * np.pi * np.arange(corners + 1) / corners
    ends = np.stack([x + radius * np.cos(angles), y + radius * height * np.sin(angles)], axis=1)
    return _divided(ends.tolist(), per_side)


def _divided(closed: List[List[float]], per_side: int) -> Places:
    """The points of a closed polyline, each side divided into equal parts."""
    return [(a[0] + (b[0] - a[0]) * k / per_side, a[1] + (b[1] - a[1]) * k / per_side)
            for a, b in zip(closed, closed[1:]) for k in range(per_side)]


def letter() -> Dictionary:
    """The capital letter A, with a hole."""
    outline = [(0, 0), (2, 0), (2.75, 2.5), (5.25, 2.5), (6, 0), (8, 0), (5, 10), (3, 10)]
    return _domain([outline, [(3.3, 4.25), (4.7, 4.25), (4, 7)]], [(4, 5)])


def box() -> Dictionary:
    """A square of 3 by 3 with a square hole of 1 by 1."""
    return _domain([[(0, 0), (3, 0), (3, 3), (0, 3)], [(1, 1), (2, 1), (2, 2), (1, 2)]], [(1.5, 1.5)])


def dots() -> Dictionary:
    """100 points in a disk, as the seeds of a sunflower."""
    k = np.arange(100) + 0.5
    radius, angle = np.sqrt(k / 100), k * np.pi * (3 - np.sqrt(5))
    return dict(vertices=np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1))


def diamond() -> Dictionary:
    """Nine points in a diamond."""
    return dict(vertices=np.array([(0, -0.9), (-0.45, -0.3), (0.5, -0.35), (-0.85, 0.05), (0.1, 0.05), (0.8, 0.1),
                                   (-0.35, 0.5), (0.3, 0.55), (0.02, 0.9)]))


def spiral() -> Dictionary:
    """Points on a spiral of Archimedes."""
    angle = np.sqrt(np.arange(2, 17) * 6.0)
    return dict(vertices=np.concatenate([[(0.0, 0.0)], np.stack([angle * np.cos(angle), angle * np.sin(angle)],
                                                                axis=1)]))


def double_hex(per_side: int, per_side_of_hole: int) -> Dictionary:
    """The unit square with two hexagonal holes, and points on its sides."""
    square = _divided([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], per_side)
    holes = [(0.25, 0.75), (0.6, 0.4)]
    return _domain([square, *(_ring(x, y, 0.1, 6, per_side_of_hole) for x, y in holes)], holes)


def square_with_circle() -> Dictionary:
    """A square with a circular hole beside its middle."""
    square = _divided([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]], 10)
    return _domain([square, _ring(0.2, 0.1, 0.4, 32)], [(0.2, 0.1)])


def face() -> Dictionary:
    """A face: two eyes and a mouth are holes, the nose is an open polyline."""
    mouth = [(-0.5, -0.4), (-0.25, -0.6), (0, -0.66), (0.25, -0.6), (0.5, -0.4), (0.22, -0.48), (0, -0.5),
             (-0.22, -0.48)]
    figure = _domain([_ring(0, 0, 1, 40, height=1.2), _ring(-0.38, 0.35, 0.16, 12, height=0.6),
                      _ring(0.38, 0.35, 0.16, 12, height=0.6), mouth], [(-0.38, 0.35), (0.38, 0.35), (0, -0.58)])
    first = len(figure["vertices"])
    nose = [(0.02, 0.25), (-0.12, -0.1), (0.08, -0.12)]
    figure["vertices"] = np.concatenate([figure["vertices"], nose])
    figure["segments"] = np.concatenate([figure["segments"], np.array([(first, first + 1), (first + 1, first + 2)],
                                                                      dtype=np.int32)])
    figure["segment_markers"] = np.concatenate([figure["segment_markers"], np.array([[5], [5]], dtype=np.int32)])
    return figure


def ell() -> Dictionary:
    """An L of twelve unit squares, each cut into two triangles: 21 vertices, 24 triangles."""
    places = [(i, j) for j in range(5) for i in range(5) if i <= 2 or j <= 2]
    number = {place: k for k, place in enumerate(places)}
    triangles = []
    for i, j in places:
        corners = [number.get(place, -1) for place in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
        if min(corners) >= 0:
            triangles += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return dict(vertices=np.array(places, dtype=np.float64), triangles=np.array(triangles, dtype=np.int32))


def layers() -> Dictionary:
    """Four layers of soil below a bent surface. The regions have the largest areas 40, 20, 10 and 5."""
    x = np.linspace(0, 100, 11)
    heights = [0 * x, 12 + 3 * np.sin(x / 20), 22 + 0.05 * x, 32 + 4 * np.cos(x / 25), 45 + 2 * np.sin(x / 9)]
    count = len(x)
    segments, markers = [], []
    for k in range(5):
        segments += [(k * count + i, k * count + i + 1) for i in range(count - 1)]
        markers += [1 if k in (0, 4) else k + 1] * (count - 1)
    for k in range(4):
        for i in (0, count - 1):
            segments.append((k * count + i, (k + 1) * count + i))
            markers.append(1)
    middle = count // 2
    regions = [(x[middle], (heights[k][middle] + heights[k + 1][middle]) / 2, k + 1, 40 / 2 ** k) for k in range(4)]
    return dict(vertices=np.concatenate([np.stack([x, y], axis=1) for y in heights]),
                segments=np.array(segments, dtype=np.int32),
                segment_markers=np.array(markers, dtype=np.int32).reshape(-1, 1),
                regions=np.array(regions, dtype=np.float64))
