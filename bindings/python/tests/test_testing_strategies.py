"""pardel.testing: the strategies draw what they say."""

import numpy as np
import pytest
from hypothesis import Phase, find, given, settings

import pardel
import pardel.testing
from pardel.testing import domains, faulty_meshes, meshes

few = settings(max_examples=25)


@pytest.mark.parametrize("family", pardel.testing.FAMILIES)
def test_every_domain_of_a_family_is_valid_and_its_text_makes_it_again(family):
    @few
    @given(domains(family))
    def drawn(domain):
        assert pardel.validate(domain, threads=1) == ()
        again = eval(repr(domain), {"pardel": pardel})
        assert again == domain

    drawn()
    smallest = find(domains(family), lambda _: True, settings=settings(database=None))
    assert len(smallest.points) <= 6 and np.abs(smallest.points).max() <= 6


@pytest.mark.parametrize("family, has", [
    ("holes", lambda d: len(d.holes) == 3), ("points", lambda d: not len(d.segments) and len(d.points) == 9),
    ("regions", lambda d: len(d.regions) == 4), ("large_offsets", lambda d: np.abs(d.points).max() > 9e8),
    ("cracks", lambda d: np.bincount(d.segments.ravel()).min() == 1), ("polygons", lambda d: len(d.points) == 10),
    ("near_degenerate", lambda d: np.any((d.points % 0.5 != 0) & (np.abs(d.points % 0.5 - 0.25) > 0.2499999))),
    ("small_angles", lambda d: pardel.delaunay(d).quality().min_angle < 0.05)])
def test_a_family_has_what_it_is_for(family, has):
    assert find(domains(family), has, settings=settings(max_examples=5000, database=None, phases=[Phase.generate]))


@few
@given(meshes())
def test_right_meshes_are_right(case):
    assert case.fault == ""
    assert pardel.check(case.domain, (case.points, case.triangles), min_angle=case.min_angle)


@pytest.mark.parametrize("fault", pardel.testing.FAULTS)
def test_every_planted_fault_is_refused(fault):
    @few
    @given(faulty_meshes(fault))
    def drawn(case):
        assert case.fault == fault
        assert not pardel.check(case.domain, (case.points, case.triangles), min_angle=case.min_angle)

    drawn()


@few
@given(faulty_meshes())
def test_the_text_of_a_mesh_makes_it_again(case):
    names = {"pardel": pardel, "Meshed": pardel.testing.Meshed}
    again = eval(repr(case), names)
    assert np.array_equal(again.points, case.points, equal_nan=True) and again.fault == case.fault
    assert np.array_equal(again.triangles, case.triangles) and again.domain == case.domain


def test_the_name_of_a_fault_that_there_is_not_is_refused():
    with pytest.raises(pardel.UsageError, match="'x' is no fault; the faults are hole_filled"):
        find(faulty_meshes("x"), lambda _: True)
