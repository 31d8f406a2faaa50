"""Arguments that are single numbers, with a message that names the argument where they are not."""

from __future__ import annotations

from typing import Any

import numpy as np

from .errors import UsageError


def number(name: str, value: Any) -> float:
    """A real number."""
    if isinstance(value, (str, bytes)):
        raise UsageError(f"{name} is {value!r}; a number is needed")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise UsageError(f"{name} is {value!r}; a number is needed") from None


def whole(name: str, value: Any) -> int:
    """A number of things."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not 0 <= int(value) < 2**31:
        raise UsageError(f"{name} is {value!r}; an integer from 0 to 2147483647 is needed")
    return int(value)
