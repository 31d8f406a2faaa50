"""Examples with the names of Triangle's classic ones. The figures are pardel's own."""

from __future__ import annotations

from typing import Callable, Dict, List, Tuple

from ...errors import UsageError
from . import figures
from .result import Dictionary
from .triangulation import triangulate

# A name, of which the mesh is made, and the switches that make it.
_MESHES: Dict[str, Tuple[str, str]] = {
    "A.1": ("A", "p"),
    "box.1": ("box", "pc"), "box.2": ("box.1", "rpa0.2"), "box.3": ("box.2", "rpa0.05"),
    "box.4": ("box.3", "rpa0.0125"),
    "diamond_02_00009.1": ("diamond_02_00009", ""),
    "double_hex.1": ("double_hex", "p"), "double_hex.2": ("double_hex", "pqYa0.0015"),
    "double_hex2.1": ("double_hex2", "p"), "double_hex2.2": ("double_hex2", "pqYa0.006"),
    "double_hex3.1": ("double_hex3", "pqa0.0015"),
    "face.1": ("face", "p"), "la.1": ("la", "pqaA"),
    "spiral.1": ("spiral", ""), "spiral.q.1": ("spiral", "q"), "spiral.r.1": ("spiral", "q32.5"),
    "square_circle_hole.1": ("square_circle_hole", "p"),
}
_FIGURES: Dict[str, Callable[[], Dictionary]] = {
    "A": figures.letter, "box": figures.box, "diamond_02_00009": figures.diamond, "dots": figures.dots,
    "double_hex": lambda: figures.double_hex(18, 2), "double_hex2": lambda: figures.double_hex(9, 1),
    "double_hex3": lambda: figures.double_hex(1, 1), "ell": figures.ell, "face": figures.face, "la": figures.layers,
    "spiral": figures.spiral, "square_circle_hole": figures.square_with_circle,
}


def get_data(name: str) -> Dictionary:
    """An example as a dictionary for `triangulate`.

    A, box, diamond_02_00009, dots, double_hex, double_hex2, double_hex3, ell, face, la, spiral, square_circle_hole; and
    meshes of them, such as A.1, box.1 to box.4 and spiral.q.1. Raises `UsageError` with all names for another one.

    >>> sorted(get_data("A"))
    ['holes', 'segment_markers', 'segments', 'vertices']
    """
    if name in _MESHES:
        origin, opts = _MESHES[name]
        return triangulate(get_data(origin), opts)
    if name not in _FIGURES:
        raise UsageError(f"there is no example {name!r}; the names are {', '.join(names())}")
    return _FIGURES[name]()


def names() -> List[str]:
    """The names of all examples."""
    return sorted([*_FIGURES, *_MESHES])


def show_data(name: str) -> None:
    """Shows an example in a window of matplotlib."""
    import matplotlib.pyplot as plt  # type: ignore[import]

    from .plot import plot
    plot(plt.axes(), **get_data(name))
    plt.show()
