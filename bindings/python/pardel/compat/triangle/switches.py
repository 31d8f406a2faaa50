"""Triangle's switches: letters, each followed by its number, such as ``pq30a0.1D``."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Dict, Optional, Tuple

from ...errors import UsageError
from ...goal import Test


@dataclass
class Switches:
    """What the switches ask for. The comments name the switch."""

    poly: bool = False                 # p
    refine: bool = False               # r
    quality: bool = False              # q, a or D: points may be added
    min_angle: float = 0               # q; 20 for q without a number
    max_area: Optional[float] = None   # a with a number
    areas: bool = False                # a without a number: areas of regions, or triangle_max_area with r
    region_attributes: bool = False    # A
    convex_hull: bool = False          # c
    conforming: bool = False           # D, or its old name L
    jettison: bool = False             # j
    edges: bool = False                # e
    neighbors: bool = False            # n
    no_markers: bool = False           # B
    no_poly: bool = False              # P
    no_node: bool = False              # N
    no_ele: bool = False               # E
    no_holes: bool = False             # O
    second_order: bool = False         # o2
    splits: int = 0                    # Y: 1, YY: 2
    max_new_points: Optional[int] = None  # S; 0 without a number
    check: bool = False                # C
    refine_if: Optional[Test] = None   # u, which has no letter here: a function


_LARGEST_ANGLE = 45

_FLAGS: Dict[str, Tuple[str, ...]] = {
    "p": ("poly",), "r": ("refine",), "A": ("region_attributes",), "c": ("convex_hull",), "j": ("jettison",),
    "e": ("edges",), "n": ("neighbors",), "B": ("no_markers",), "P": ("no_poly",), "N": ("no_node",),
    "E": ("no_ele",), "O": ("no_holes",), "C": ("check",), "D": ("quality", "conforming"),
    "L": ("quality", "conforming"),
}
# z, Q: the wrapper always sets them. v: `voronoi` returns the diagram. V: nothing is printed. g, I: about files.
# i, F, l, s, X: they choose among Triangle's own algorithms; predicates are exact here.
_WITHOUT_EFFECT = "zQvVgIiFlsX"
_REFUSED = {"u": "a test of triangles that Triangle has to be compiled with; pardel.mesh(refine_if=function) has one",
            "w": "a weighted Delaunay triangulation", "W": "a weighted Delaunay triangulation",
            "h": "the help of the program"}
# As in Triangle, digits and points; and an exponent, which Python writes for small numbers.
_NUMBER = re.compile(r"([0-9.]+)([eE][+-]?[0-9]+)?")


def parsed(opts: str) -> Switches:
    """Raises `UsageError` that names the switch. Blanks and hyphens have no meaning."""
    if not isinstance(opts, str):
        raise UsageError(f"opts is {opts!r}; a string of switches is needed")
    switches, place = Switches(), 0
    while place < len(opts):
        letter, place = opts[place], place + 1
        if letter in _FLAGS:
            for name in _FLAGS[letter]:
                setattr(switches, name, True)
        elif letter in "qaS":
            place = _with_number(switches, letter, opts, place)
        elif letter == "o":
            if opts[place:place + 1] == "2":
                switches.second_order, place = True, place + 1
        elif letter == "Y":
            switches.splits += 1
        elif letter in _REFUSED:
            raise UsageError(f"opts {opts!r}: the switch {letter} is not supported: {_REFUSED[letter]}")
        elif letter not in _WITHOUT_EFFECT and letter not in " -":
            raise UsageError(f"opts {opts!r}: {letter!r} is not a switch of Triangle")
    return _combined(switches, opts)


def _with_number(switches: Switches, letter: str, opts: str, place: int) -> int:
    found = _NUMBER.match(opts, place)
    if letter == "S":
        digits = re.compile("[0-9]*").match(opts, place)
        assert digits is not None
        switches.max_new_points = int(digits.group() or 0)
        return digits.end()
    switches.quality = True
    if found is None:
        if letter == "a":
            switches.areas = True
        else:
            switches.min_angle = 20
        return place
    try:
        value = float(found.group())
    except ValueError:
        raise UsageError(f"opts {opts!r}: {found.group()!r} after the switch {letter} is not a number") from None
    if letter == "q" and value <= _LARGEST_ANGLE:
        switches.min_angle = value
    elif letter == "q":
        raise UsageError(f"opts {opts!r}: the smallest angle after the switch q is at most {_LARGEST_ANGLE} degrees")
    elif value > 0:
        switches.max_area = value
    else:
        raise UsageError(f"opts {opts!r}: the largest area after the switch a must be greater than 0")
    return found.end()


def _combined(switches: Switches, opts: str) -> Switches:
    """Without the switches that have no effect beside others."""
    if switches.refine and switches.check:
        raise UsageError(f"opts {opts!r}: the switch C is not supported beside r; pardel.check checks any mesh")
    if not switches.refine and not switches.poly:
        switches.areas = False
    if switches.refine or not switches.poly:
        switches.region_attributes = False
    return switches
