"""Points in a mesh: in which triangles they lie, and what values are there."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import _pardel, arrays
from .errors import UsageError
from .scalars import number, whole


def locate(core: _pardel.HeldMesh, points: npt.ArrayLike, threads: int) -> npt.NDArray[np.int32]:
    return _pardel.locate(core, arrays.numbers("points", points, 2), whole("threads", threads))


def interpolate(core: _pardel.HeldMesh, values: npt.ArrayLike, points: npt.ArrayLike, outside: float,
                threads: int) -> npt.NDArray[np.float64]:
    count = len(core.points)
    shape = arrays.shape("values", values)
    if len(shape) not in (1, 2) or shape[0] != count:
        raise UsageError(f"values has the shape {shape}; ({count},) or ({count}, k) is needed, one row per point of "
                         f"the mesh")
    columns = shape[1] if len(shape) == 2 else 1
    rows = arrays.numbers("values", np.reshape(values, (count, columns)), columns)
    found = _pardel.interpolate(core, rows, arrays.numbers("points", points, 2), number("outside", outside),
                                whole("threads", threads))
    return found if len(shape) == 2 else found[:, 0]
