"""Small pictures for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._mesh import Mesh
    from .domain import Domain

Numbers = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]

# The longer side of a picture; the most triangles that are drawn; the most lines or dots.
SIDE = 480
MOST_TRIANGLES = 3000
MOST_LINES = 10_000


def svg_of_mesh(mesh: Mesh) -> Optional[str]:
    """All triangles, coloured by region; of a mesh with more than MOST_TRIANGLES only the segments, and a sentence.

    None for a mesh of arrays with an index that is out of range.
    """
    points, triangles, segments, regions = mesh.points, mesh.triangles, mesh.segments, mesh.regions
    if len(triangles) and not (triangles.min() >= 0 and triangles.max() < len(points)):
        return None
    picture = _Picture(points)
    if len(triangles) > MOST_TRIANGLES:
        picture.lines(points, segments)
        picture.say(f"{len(points):,} points, {len(triangles):,} triangles; only segments are drawn")
        return picture.text()
    of_region = regions if len(regions) == len(triangles) else np.full(len(triangles), -1)
    for region in np.unique(of_region):
        picture.triangles(points, triangles[of_region == region], int(region))
    picture.lines(points, segments)
    return picture.text()


def svg_of_domain(domain: Domain) -> str:
    """Segments, points (if they are few), holes as crosses and regions as diamonds."""
    points, segments = domain.points, domain.segments
    picture = _Picture(points)
    picture.lines(points, segments)
    if len(points) <= MOST_TRIANGLES:
        picture.marks(points, "h0", 'stroke="#205090" stroke-width="4" stroke-linecap="round"')
    elif len(segments) == 0:
        picture.say(f"{len(points):,} points")
    picture.marks(domain.holes, "m-4 -4l8 8m0 -8l-8 8", 'stroke="#c02020" stroke-width="2"')
    picture.marks(domain.regions[:, :2], "m0 -4l4 4l-4 4l-4 -4z", 'stroke="#208040" stroke-width="2"')
    return picture.text()


class _Picture:
    def __init__(self, points: Numbers) -> None:
        finite = points[np.isfinite(points).all(axis=1)]
        self._low = finite.min(axis=0) if len(finite) else np.zeros(2)
        self._high = finite.max(axis=0) if len(finite) else np.zeros(2)
        # Divided first, because the extent of doubles can be too large for a double.
        extent = float((self._high / SIDE - self._low / SIDE).max())
        self._unit = extent if extent > 0 else 1.0
        self._size = (self._high / self._unit - self._low / self._unit)
        self._body: List[str] = []
        self._margin, self._foot = 8, 0

    def _at(self, places: Numbers) -> Numbers:
        """Places in the picture, up to a tenth of a pixel. The y axis points upwards."""
        x = places[..., 0] / self._unit - self._low[0] / self._unit
        y = self._high[1] / self._unit - places[..., 1] / self._unit
        with np.errstate(invalid="ignore"):
            return np.asarray(np.round(np.stack([x, y], axis=-1), 1) + self._margin)

    def triangles(self, points: Numbers, corners: Indices, region: int) -> None:
        at = self._at(points[corners])
        hue = (210 + (region + 1) * 137) % 360
        path = "".join(f"M{a:g} {b:g}L{c:g} {d:g}L{e:g} {f:g}Z" for a, b, c, d, e, f in at.reshape(-1, 6).tolist())
        self._body.append(f'<path d="{path}" fill="hsl({hue},60%,88%)" stroke="#7088a0" stroke-width="0.4"/>')

    def lines(self, points: Numbers, ends: Indices) -> None:
        """Without those that are not longer than a tenth of a pixel, or drawn already."""
        at = self._at(points[ends]).reshape(-1, 4)
        at = np.unique(at[np.isfinite(at).all(axis=1)], axis=0)
        at = at[(at[:, :2] != at[:, 2:]).any(axis=1)]
        if len(at) > MOST_LINES:
            at = np.unique(np.round(at), axis=0)
        if len(at) > MOST_LINES:
            return self.say(f"{len(ends):,} segments")
        path = "".join(f"M{a:g} {b:g}L{c:g} {d:g}" for a, b, c, d in at.tolist())
        return self._body.append(f'<path d="{path}" fill="none" stroke="#202020" stroke-width="1.2" '
                                 f'stroke-linecap="round"/>')

    def marks(self, places: Numbers, shape: str, style: str) -> None:
        at = np.unique(self._at(places[np.isfinite(places).all(axis=1)]), axis=0)[:MOST_LINES]
        path = "".join(f"M{x:g} {y:g}{shape}" for x, y in at.tolist())
        self._body.append(f'<path d="{path}" fill="none" {style}/>')

    def say(self, sentence: str) -> None:
        self._foot += 20
        height = self._size[1] + 2 * self._margin + self._foot
        self._body.append(f'<text x="{self._margin}" y="{height - 6:.0f}" font-family="sans-serif" '
                          f'font-size="13">{sentence}</text>')

    def _extent(self) -> Tuple[int, int]:
        width, height = np.ceil(self._size + 2 * self._margin)
        return (int(max(width, SIDE if self._foot else 0)), int(height) + self._foot)

    def text(self) -> str:
        width, height = self._extent()
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                f'viewBox="0 0 {width} {height}"><rect width="100%" height="100%" fill="white"/>'
                + "".join(self._body) + "</svg>")
