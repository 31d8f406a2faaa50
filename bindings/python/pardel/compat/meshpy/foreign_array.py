"""The arrays of a `MeshInfo`."""

from __future__ import annotations

from typing import Any, Iterator, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ...errors import UsageError

Row = Union[float, int, List[Any]]


class ForeignArray:
    """Rows of `unit` numbers, with a length that is set by `resize`; MeshPy gives this name to its arrays.

    An array that belongs to another one, as markers of points belong to the points, has its length. It has no numbers
    before `setup`: reading them is a RuntimeError, and `allocated` is False. Rows of one number are numbers, others are
    lists. ``numpy.array`` makes an array of shape (n, unit) or (n,).

    >>> points = ForeignArray("points", float, 2)
    >>> points.resize(2)
    >>> points[1] = (3, 4)
    >>> points[1, 1], list(points)
    (4.0, [[0.0, 0.0], [3.0, 4.0]])
    """

    def __init__(self, name: str, kind: type, unit: int, master: Optional[ForeignArray] = None) -> None:
        self._name, self._kind, self._unit, self._master = name, kind, unit, master
        self._tied: List[ForeignArray] = []
        self._rows: Optional[npt.NDArray[Any]] = None
        if master is None:
            self._rows = self._zeros(0)
        else:
            master._tied.append(self)

    @property
    def unit(self) -> int:
        """The numbers of a row."""
        return self._unit

    @property
    def allocated(self) -> bool:
        """True if there are numbers."""
        return self._rows is not None and self._unit > 0 and (self._master is not None or len(self._rows) > 0)

    def __len__(self) -> int:
        if self._master is not None:
            return len(self._master)
        return 0 if self._rows is None else len(self._rows)

    def resize(self, new_size: int) -> None:
        """Sets the number of rows. New rows are zero."""
        if self._master is not None:
            raise RuntimeError(f"{self._name} has the length of {self._master._name}; resize that")
        if new_size < 0:
            raise ValueError(f"{self._name}: the length {new_size} is negative")
        self._resize(new_size)
        for tied in self._tied:
            if tied._rows is not None:
                tied._resize(new_size)

    def setup(self) -> None:
        """Gives numbers, zeros, to an array that belongs to another one."""
        if self._rows is None:
            self._rows = self._zeros(len(self))

    def deallocate(self) -> None:
        """Takes the numbers away, and the rows of an array that belongs to no other one."""
        self._rows = None if self._master is not None else self._zeros(0)
        for tied in self._tied:
            tied.deallocate()

    def __getitem__(self, index: Any) -> Any:
        rows = self._numbers()
        if isinstance(index, tuple):
            return rows[self._place(index)].item()
        if isinstance(index, slice):
            return rows[index].tolist()
        return rows[self._row(index)].tolist()

    def __setitem__(self, index: Any, value: Any) -> None:
        rows = self._numbers()
        if isinstance(index, tuple):
            rows[self._place(index)] = self._checked(value)
            return
        row = self._row(index)
        if self._unit != 1 and len(value) != self._unit:
            raise ValueError(f"{self._name}[{row}]: the value must be a sequence of length {self._unit}")
        rows[row] = self._checked(value)

    def __iter__(self) -> Iterator[Row]:
        return iter(self._numbers().tolist())

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        return np.array(self._numbers(), dtype=dtype)

    def set_all(self, values: Any) -> None:
        """Takes these rows; an array that belongs to no other one gets their number."""
        if not isinstance(values, np.ndarray):
            values = list(values)
        if self._master is None:
            self.resize(len(values))
        else:
            self.setup()
        if len(values) != len(self):
            raise ValueError(f"{self._name}: {len(values)} values are given; {len(self)} are needed")
        try:
            rows = self._checked(values)
        except ValueError:  # rows of different lengths, or no numbers
            rows = np.empty(())
        if rows.shape == self._shape(len(values)):
            self._rows = rows
            return
        for index, value in enumerate(values):  # finds the row that is wrong
            self[index] = value

    def set_unit(self, unit: int) -> None:
        """Changes the numbers of a row. What was there is lost."""
        self._unit = unit
        if self._rows is not None:
            self._rows = self._zeros(len(self))

    def _checked(self, value: Any) -> npt.NDArray[Any]:
        """A copy with the type of the array."""
        numbers = np.asarray(value)
        if numbers.dtype.kind not in "iufb" and numbers.size:
            raise UsageError(f"{self._name}: {value!r} is given; numbers are needed")
        if self._kind is float:
            return np.array(numbers, dtype=np.float64)
        whole = numbers.astype(np.int32)
        if not np.array_equal(whole, numbers):
            raise UsageError(f"{self._name}: 32-bit integers are needed")
        return whole

    def _shape(self, size: int) -> Tuple[int, ...]:
        return (size,) if self._unit == 1 else (size, self._unit)

    def _zeros(self, size: int) -> npt.NDArray[Any]:
        return np.zeros(self._shape(size), dtype=np.float64 if self._kind is float else np.int32)

    def _resize(self, size: int) -> None:
        rows = self._zeros(size)
        if self._rows is not None:
            kept = min(size, len(self._rows))
            rows[:kept] = self._rows[:kept]
        self._rows = rows

    def _numbers(self) -> npt.NDArray[Any]:
        if self._rows is None:
            raise RuntimeError(f"{self._name} is not allocated; setup() allocates it")
        return self._rows

    def _row(self, index: Any) -> int:
        row = int(index.__index__())
        size = len(self)
        if not -size <= row < size:
            raise IndexError(f"{self._name}: the index {row} is out of bounds; the length is {size}")
        return row % size

    def _place(self, index: Tuple[Any, ...]) -> Tuple[int, ...]:
        if len(index) != 2:
            raise IndexError(f"{self._name}: an index of two numbers is needed, not of {len(index)}")
        row, column = self._row(index[0]), int(index[1].__index__())
        if not 0 <= column < self._unit:
            raise IndexError(f"{self._name}: the index {column} is out of bounds; rows have {self._unit} numbers")
        return (row,) if self._unit == 1 else (row, column)
