"""Gambit neutral files."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, TextIO, Tuple

import numpy as np

from ... import _pardel

if TYPE_CHECKING:
    from .mesh_info import MeshInfo

_TRIANGLE = 3  # the number of this element type
_END = "ENDOFSECTION\n"
_PER_LINE = 10


def write_neutral(info: MeshInfo, file: TextIO, conditions: Dict[Any, Tuple[str, int]],
                  periodicity: Optional[Tuple[int, Iterable[float]]], description: str) -> None:
    """Writes points, triangles, one group of all triangles, and boundary conditions on faces with given markers."""
    corners = np.array(info.elements)[:, :3]
    sets = _sets(info, conditions, periodicity)
    file.write(f"CONTROL INFO 2.1.2\n** GAMBIT NEUTRAL FILE\n{description}\nPROGRAM: pardel VERSION: "
               f"{_pardel.version}\n\n")
    counts = {"NUMNP": len(info.points), "NELEM": len(corners), "NGRPS": 1, "NBSETS": len(sets), "NDFCD": 2, "NDFVL": 2}
    file.write("".join(f"{name:>10}" for name in counts) + "\n" + "".join(f"{n:>10}" for n in counts.values()) + "\n")
    file.write(_END + "NODAL COORDINATES 2.1.2\n")
    for index, (x, y) in enumerate(np.array(info.points).tolist(), start=1):
        file.write(f"{index} {x!r} {y!r}\n")
    file.write(_END + "ELEMENTS/CELLS 2.1.2\n")
    for index, triangle in enumerate((corners + 1).tolist(), start=1):
        file.write(f"{index:8}{_TRIANGLE:3}{3:3} " + "".join(f"{point:8}" for point in triangle) + "\n")
    file.write(_END + f"ELEMENT GROUP 1.3.0\nGROUP:{1:11} ELEMENTS:{len(corners):11} MATERIAL:{1:11} NFLAGS: {0:11}\n"
               f"{'epsilon: 1':>32}\n{0:8}\n")
    for first in range(0, len(corners), _PER_LINE):
        last = min(first + _PER_LINE, len(corners))
        file.write("".join(f"{index:8}" for index in range(first + 1, last + 1)) + "\n")
    file.write(_END)
    for head, sides in sets:
        file.write("BOUNDARY CONDITIONS 2.1.2\n" + head)
        file.writelines(f"{triangle + 1:10}{_TRIANGLE:5}{side + 1:5}\n" for triangle, side in sides)
        file.write(_END)


def _sets(info: MeshInfo, conditions: Dict[Any, Tuple[str, int]],
          periodicity: Optional[Tuple[int, Iterable[float]]]) -> List[Tuple[str, List[Tuple[int, int]]]]:
    """The heads of the boundary conditions, and the triangles and sides where each holds."""
    if not conditions and periodicity is None:
        return []
    if not info.faces.allocated:
        warnings.warn("the mesh has no faces, so boundary conditions are not written; build(generate_faces=True) makes "
                      "them", stacklevel=4)
        return []
    sides: Dict[Any, Tuple[int, int]] = {}
    for triangle, (a, b, c) in enumerate(np.array(info.elements)[:, :3].tolist()):
        for side, ends in enumerate(((a, b), (b, c), (c, a))):
            sides.setdefault(frozenset(ends), (triangle, side))
    found = []
    heads = {markers: f"{name:>32}{1:8}%8d{0:8}{code:8}\n" for markers, (name, code) in conditions.items()}
    if periodicity is not None:
        heads[periodicity[0]] = "periodic " + " ".join(map(repr, periodicity[1])) + f"%8d{0:8}{0:8}\n"
    for markers, head in heads.items():
        wanted = markers if isinstance(markers, frozenset) else {markers}
        there = [sides[frozenset(face)] for face, marker in zip(np.array(info.faces).tolist(), info.face_markers)
                 if marker in wanted]
        if there:
            found.append((head % len(there), there))
    return found
