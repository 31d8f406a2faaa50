"""Plots with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from .errors import UsageError

if TYPE_CHECKING:
    from ._mesh import Mesh
    from .domain import Domain

Numbers = npt.NDArray[np.float64]
By = Union[None, str, npt.ArrayLike]

_LABELS = {"quality": "smallest angle in degrees", "angle": "largest angle in degrees", "size": "longest edge",
           "region": "attribute of the region"}


def plot_mesh(mesh: Mesh, ax: Any, by: By, edges: bool, segments: bool, colorbar: bool, **options: Any) -> Any:
    values, label = _values(mesh, by)
    axes = _axes(ax)
    x, y, corners = mesh.points[:, 0], mesh.points[:, 1], np.ascontiguousarray(mesh.triangles)
    if len(corners):
        lines = {"edgecolors": "#40546b", "linewidth": _width(len(corners))} if edges else {}
        if values is None:
            values, options = np.zeros(len(corners)), {"cmap": _plain(), **options}
        if len(values) == len(mesh.points):
            drawn = axes.tripcolor(x, y, corners, values, shading="gouraud", **options)
            if edges:
                axes.triplot(x, y, corners, color=lines["edgecolors"], linewidth=lines["linewidth"])
        else:
            drawn = axes.tripcolor(x, y, corners, facecolors=values, **{**lines, **options})
        if label is not None and colorbar:
            axes.figure.colorbar(drawn, ax=axes, label=label)
    if segments:
        _add_lines(axes, mesh.points, mesh.segments)
    return _finished(axes)


def plot_domain(domain: Domain, ax: Any, points: bool, **options: Any) -> Any:
    axes = _axes(ax)
    _add_lines(axes, domain.points, domain.segments, **options)
    if points:
        axes.plot(*domain.points.T, ".", color="#205090", markersize=3)
    if len(domain.holes):
        axes.plot(*domain.holes.T, "x", color="#c02020")
    for x, y, attribute, _ in domain.regions:
        axes.plot(x, y, "D", color="#208040", markersize=4)
        axes.annotate(f"{attribute:g}", (x, y), xytext=(5, 3), textcoords="offset points")
    return _finished(axes)


def _axes(ax: Any) -> Any:
    if ax is not None:
        if not hasattr(ax, "add_collection"):
            raise UsageError(f"ax is a {type(ax).__name__}; axes of matplotlib are needed; what the colours of a mesh "
                             f"show is the argument by")
        return ax
    try:
        from matplotlib import pyplot  # type: ignore[import]
    except ImportError:
        raise UsageError("plot needs the package matplotlib; draw and write make pictures without it") from None
    return pyplot.gca()


def _plain() -> Any:
    from matplotlib.colors import ListedColormap  # type: ignore[import]

    return ListedColormap(["#dfe8f2"])


def _width(triangles: int) -> float:
    """Thinner lines for more triangles."""
    return float(np.clip(20 / np.sqrt(triangles), 0.05, 0.8))


def _add_lines(axes: Any, points: Numbers, ends: npt.NDArray[np.int32], **options: Any) -> None:
    from matplotlib.collections import LineCollection  # type: ignore[import]

    if len(ends):
        axes.add_collection(LineCollection(points[ends], **{"color": "#202020", "linewidth": 1.2, **options}))


def _finished(axes: Any) -> Any:
    axes.set_aspect("equal")
    axes.autoscale_view()
    return axes


def _values(mesh: Mesh, by: By) -> Tuple[Optional[Numbers], Optional[str]]:
    """One number per triangle or per point, and what they are."""
    if by is None:
        return None, None
    if isinstance(by, str):
        if by not in _LABELS:
            raise UsageError(f"by is {by!r}; it must be one of {', '.join(_LABELS)}, or an array")
        return _measured(mesh, by), _LABELS[by]
    try:
        values = np.asarray(by, dtype=np.float64)
    except (TypeError, ValueError):
        raise UsageError("by is not an array of numbers") from None
    if values.shape not in ((len(mesh.triangles),), (len(mesh.points),)):
        raise UsageError(f"by has the shape {values.shape}; ({len(mesh.triangles)},) is needed, one number per "
                         f"triangle, or ({len(mesh.points)},), one per point")
    return values, ""


def _measured(mesh: Mesh, by: str) -> Numbers:
    if by == "region":
        known = np.append(mesh.region_attributes, 0.0)  # the index -1, no region, is the last one
        return known[mesh.regions] if len(mesh.regions) else np.zeros(len(mesh.triangles))
    corners = mesh.points[mesh.triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    if by == "size":
        return np.asarray(np.hypot(sides[..., 0], sides[..., 1]).max(axis=1, initial=0))
    back = -np.roll(sides, 1, axis=1)
    cross = sides[..., 0] * back[..., 1] - sides[..., 1] * back[..., 0]
    angles = np.degrees(np.arctan2(np.abs(cross), (sides * back).sum(axis=2)))
    return np.asarray(angles.min(axis=1, initial=180) if by == "quality" else angles.max(axis=1, initial=0))
