"""Strategies of Hypothesis for meshes: right ones, and ones with one fault."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from hypothesis import assume
from hypothesis import strategies as st

from ..domain import Domain
from ..errors import UsageError
from ..meshing import mesh
from .code import rows_of
from .drafts import Draft
from .families import Family, domains
from .faults import ANGLE, FAULTS, PLANTED


@dataclass(frozen=True, eq=False, repr=False)
class Meshed:
    """A domain, a mesh of it, and the least angle in degrees that was asked for. fault: its name; empty: no fault."""

    domain: Domain
    points: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]
    min_angle: float
    fault: str = ""

    def __repr__(self) -> str:
        return (f"Meshed({self.domain!r}, {rows_of(self.points)}, {rows_of(self.triangles)}, "
                f"min_angle={self.min_angle:g}, fault={self.fault!r})")


_ANGLES = st.sampled_from([0, 20.7, 28])


@st.composite
def meshes(draw: st.DrawFn, *families: Family) -> Meshed:
    """A strategy for right meshes of domains of these families; without arguments, of all.

    >>> import pardel
    >>> from hypothesis import given
    >>> @given(meshes("polygons"))
    ... def test_right_meshes_are_accepted(case):
    ...     assert pardel.check(case.domain, (case.points, case.triangles), min_angle=case.min_angle)
    >>> test_right_meshes_are_accepted()
    """
    domain, min_angle = draw(domains(*families)), draw(_ANGLES)
    made = mesh(domain, min_angle=min_angle, threads=1)
    return Meshed(domain, made.points, made.triangles.astype(np.int64), min_angle)


@st.composite
def _rectangles(draw: st.DrawFn) -> Domain:
    """Rectangles with points inside: the only angles between segments are right."""
    width, height = draw(st.integers(2, 12)), draw(st.integers(2, 12))
    draft = Draft([(0, 0), (width, 0), (width, height), (0, height)])
    for place in draw(st.lists(st.tuples(st.integers(1, width - 1), st.integers(1, height - 1)), max_size=4)):
        draft.add([place])
    return draft.domain()


@st.composite
def faulty_meshes(draw: st.DrawFn, *faults: str) -> Meshed:
    """A strategy for meshes that have one of these faults; without arguments, of all. ``FAULTS`` has their names:

    hole_filled, segment_ignored (no edges join its ends), point_moved (one point of the domain, by 1 down to a rounding
    error), edge_flipped (it is not Delaunay), gap (a triangle is missing), clockwise (one triangle, or all),
    triangle_doubled, small_angle (below min_angle where nothing prevents it), far_point (with a triangle outside the
    domain), triangles_cross, bad_index, not_a_number (or infinite).

    A checker must refuse each of them. Raises `UsageError` for a name that is not one of these.

    >>> import pardel
    >>> from hypothesis import given
    >>> @given(faulty_meshes("gap", "clockwise"))
    ... def test_wrong_meshes_are_refused(case):
    ...     assert not pardel.check(case.domain, (case.points, case.triangles), min_angle=case.min_angle)
    >>> test_wrong_meshes_are_refused()
    """
    unknown = [name for name in faults if name not in PLANTED]
    if unknown:
        raise UsageError(f"{unknown[0]!r} is no fault; the faults are {', '.join(FAULTS)}")
    name = draw(st.sampled_from(faults or FAULTS))
    fault, families = PLANTED[name]
    of: Any = _rectangles() if families is None else domains(*families)
    domain, min_angle = draw(of), draw(_ANGLES) if families is not None else ANGLE
    planted = fault(draw, domain, mesh(domain, min_angle=min_angle, threads=1))
    assume(planted is not None)
    assert planted is not None
    return Meshed(domain, *planted, min_angle, name)
