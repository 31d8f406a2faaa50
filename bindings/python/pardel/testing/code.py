"""Domains and arrays as Python code that makes equal ones."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from ..domain import Domain


def _number(value: float) -> str:
    """The shortest text of a double that is read as the same double."""
    if value != value or value in (float("inf"), -float("inf")):
        return f'float("{value}")'
    return str(int(value)) if value == int(value) and abs(value) < 2**53 else repr(float(value))


def rows_of(rows: npt.NDArray[Any]) -> str:
    """An array of shape (n, k) as a list of tuples."""
    return "[" + ", ".join("(" + ", ".join(map(_number, row)) + ")" for row in rows.tolist()) + "]"


def code_of(domain: Domain, with_regions: bool = False) -> str:
    """The arguments of `pardel.Domain` without those that are empty; markers and attributes are left out."""
    parts = [rows_of(domain.points)]
    if len(domain.segments) or len(domain.holes):
        parts.append(rows_of(domain.segments))
    if len(domain.holes):
        parts.append(f"holes={rows_of(domain.holes)}")
    if with_regions and len(domain.regions):
        parts.append(f"regions={rows_of(domain.regions)}")
    return ", ".join(parts)
