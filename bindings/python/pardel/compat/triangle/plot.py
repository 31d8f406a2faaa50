"""Pictures of dictionaries, with matplotlib."""

from __future__ import annotations

from typing import Any, Mapping, Tuple

import numpy as np


def compare(plt: Any, A: Mapping[str, Any], B: Mapping[str, Any], figsize: Tuple[float, float] = (6, 3)) -> None:
    """Two dictionaries side by side in a new figure, on the axes of the first one. plt: matplotlib.pyplot."""
    _compare(plt, A, B, figsize, 1, 2)


def comparev(plt: Any, A: Mapping[str, Any], B: Mapping[str, Any], figsize: Tuple[float, float] = (3, 6)) -> None:
    """Like `compare`, one below the other."""
    _compare(plt, A, B, figsize, 2, 1)


def _compare(plt: Any, A: Mapping[str, Any], B: Mapping[str, Any], figsize: Tuple[float, float], rows: int,
             columns: int) -> None:
    plt.figure(figsize=figsize)
    first = plt.subplot(rows, columns, 1)
    plot(first, **A)
    limits = first.axis()
    shared = {"sharey": first} if rows == 1 else {"sharex": first}
    second = plt.subplot(rows, columns, 2, **shared)
    plot(second, **B)
    second.axis(limits)
    plt.tight_layout()


def plot(ax: Any, **kw: Any) -> None:
    """Draws what a dictionary has: vertices, triangles, segments, holes, edges and rays, regions, attributes.

    labels=True: numbers of the vertices, too. markers=True: their markers, from vertex_markers.
    """
    points = np.asarray(kw["vertices"], dtype=float)
    ax.set_aspect("equal")
    ax.scatter(*points.T, color="k")
    if kw.get("labels"):
        _write(ax, points, [str(k) for k in range(len(points))], color="k")
    if kw.get("markers"):
        _write(ax, points, [str(marker) for marker in np.ravel(kw["vertex_markers"])], color="k")
    if "segments" in kw:
        _lines(ax, points[np.asarray(kw["segments"])], color="r", linewidth=3, zorder=0)
    if "triangles" in kw:
        ax.triplot(points[:, 0], points[:, 1], np.asarray(kw["triangles"])[:, :3], "ko-")
    if "holes" in kw:
        ax.scatter(*np.asarray(kw["holes"], dtype=float).T, marker="x", color="r")
    if "edges" in kw:
        _lines(ax, points[np.asarray(kw["edges"])], color="k", linewidth=0.5)
        if "ray_origins" in kw and "ray_directions" in kw:
            _rays(ax, points[np.ravel(kw["ray_origins"])], np.asarray(kw["ray_directions"], dtype=float))
    if "regions" in kw:
        rows = np.asarray(kw["regions"], dtype=float)
        ax.scatter(rows[:, 0], rows[:, 1], marker="*", color="b")
        _write(ax, rows[:, :2], [f" {attribute:g}" for attribute in rows[:, 2]], color="b")
    if "triangle_attributes" in kw:
        middles = points[np.asarray(kw["triangles"])[:, :3]].mean(axis=1)
        ax.scatter(*middles.T, marker=".", color="m", zorder=1)
        _write(ax, middles, [f" {row[0]:g}" for row in np.asarray(kw["triangle_attributes"])], color="m")
    ax.get_xaxis().set_visible(False)
    ax.get_yaxis().set_visible(False)


def _lines(ax: Any, ends: Any, **style: Any) -> None:
    """ends: shape (n, 2, 2)."""
    from matplotlib.collections import LineCollection  # type: ignore[import]
    ax.add_collection(LineCollection(ends, **style))
    ax.autoscale_view()


def _rays(ax: Any, origins: Any, directions: Any) -> None:
    """To the border of the picture, and beyond. The limits of the axes stay."""
    limits = ax.axis()
    reach = np.hypot(limits[1] - limits[0], limits[3] - limits[2]) + np.abs(origins).max(initial=0)
    lengths = np.hypot(*directions.T)[:, None]
    _lines(ax, np.stack([origins, origins + 2 * reach * directions / lengths], axis=1), color="k", linewidth=0.5)
    ax.axis(limits)


def _write(ax: Any, places: Any, texts: Any, color: str) -> None:
    for (x, y), text in zip(places, texts):
        ax.text(x, y, text, color=color, va="center", clip_on=True)
