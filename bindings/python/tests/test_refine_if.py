"""A function of the caller that says which triangles must be refined."""

import weakref

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel


class Own(Exception):
    """An exception that only these tests know."""


def fail(*_):
    raise Own("from the function")


def is_large_near_the_origin(corners, area):
    return area > 1e-4 + 0.01 * np.hypot(*corners.mean(axis=0))


def test_triangles_are_refined_until_the_function_is_true_for_none(square):
    made = pardel.mesh(square, refine_if=is_large_near_the_origin)
    assert made.report.goal_met and made.report.fail_test == 0
    assert pardel.check(square, made, refine_if=is_large_near_the_origin)
    assert len(made.triangles) > 10 * len(pardel.mesh(square).triangles)


def test_the_checker_lists_the_triangles_for_which_the_function_is_true(square):
    made = pardel.mesh(square, max_area=0.01)
    found = pardel.check(square, made, refine_if=lambda corners, area: corners[0, 0] < 0.5)
    left = [t for t, corners in enumerate(made.points[made.triangles]) if corners[:, 0].min() < 0.5]
    assert sorted(violation.ids[0] for violation in found.violations) == left
    assert found.violation_counts == {"user_test": len(left)} and not found.valid
    assert "must be refined, as the test of the user says" in found.violations[0].text


def test_the_function_gets_counter_clockwise_corners_from_the_least_one_and_their_area(square):
    seen = []

    def look(corners, area):
        assert corners.shape == (3, 2) and corners.dtype == np.float64 and isinstance(area, float)
        (ax, ay), (bx, by), (cx, cy) = corners
        seen.append(area == ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2 and tuple(corners[0]) == min(
            map(tuple, corners)))
        corners[:] = 0  # its own copy
        return area > 0.01

    pardel.check(square, pardel.mesh(square, refine_if=look), refine_if=look)
    assert len(seen) > 100 and all(seen)


def test_the_mesh_does_not_depend_on_the_number_of_threads(square):
    digests = {pardel.mesh(square, refine_if=is_large_near_the_origin, threads=threads).digest for threads in (0, 1, 2)}
    assert len(digests) == 1


def test_a_mesh_is_refined_and_then_stays(square):
    fine = pardel.refine(pardel.mesh(square), refine_if=is_large_near_the_origin)
    assert pardel.check(square, fine, refine_if=is_large_near_the_origin)
    assert pardel.refine(fine, refine_if=is_large_near_the_origin).digest == fine.digest


def test_it_holds_beside_a_function_of_sizes(square):
    made = pardel.mesh(square, size=lambda x, y: 0.02 + 0.1 * y, refine_if=is_large_near_the_origin)
    assert pardel.check(square, made, size=lambda x, y: 0.02 + 0.1 * y, refine_if=is_large_near_the_origin)
    assert pardel.check(square, made, size=lambda places: 0.02 + 0.1 * places[:, 1],
                        refine_if=is_large_near_the_origin)


def test_the_interior_is_not_filled_beside_it(square):
    made = pardel.mesh(square, max_area=1e-3, refine_if=lambda corners, area: False, interior="fill")
    assert made.report.laid == 0 and pardel.mesh(square, max_area=1e-3, interior="fill").report.laid > 0


def test_a_function_that_is_always_true_ends_at_the_limit_on_points(square):
    report = pardel.mesh(square, refine_if=lambda corners, area: True, max_vertices=500).report
    assert report.fail_test == len(report.exempt) > 900 and report.exempt_counts == {"budget": report.fail_test}
    assert not report.goal_met


def test_a_function_that_is_always_true_ends_at_the_shortest_edge(square):
    made = pardel.mesh(square, refine_if=lambda corners, area: True, min_edge=0.05)
    assert made.report.exempt_counts == {"min_edge": made.report.fail_test} and made.report.fail_test > 300


@pytest.mark.parametrize("run", [
    lambda square: pardel.mesh(square, refine_if=fail), lambda square: pardel.mesh(square, refine_if=fail, threads=2),
    lambda square: pardel.refine(pardel.mesh(square), refine_if=fail),
    lambda square: pardel.check(square, pardel.mesh(square), refine_if=fail)],
    ids=["mesh", "threads", "refine", "check"])
def test_an_exception_comes_back_as_itself(square, run):
    with pytest.raises(Own, match="from the function"):
        run(square)
    assert pardel.mesh(square).report.goal_met


def test_an_exception_after_many_calls_ends_the_run(square):
    calls = []

    def later(corners, area):
        calls.append(1)
        return fail() if len(calls) > 1000 else area > 1e-5

    with pytest.raises(Own):
        pardel.mesh(square, refine_if=later)
    assert len(calls) == 1001


@pytest.mark.parametrize("answer, message", [(None, "refine_if returned None"), (np.array([True, False]), "ambiguous")])
def test_an_answer_that_is_neither_true_nor_false_is_an_error(square, answer, message):
    with pytest.raises((TypeError, ValueError), match=message):
        pardel.mesh(square, refine_if=lambda corners, area: answer)


@pytest.mark.parametrize("call", [
    pardel.mesh, lambda square, **test: pardel.refine(pardel.mesh(square), **test),
    lambda square, **test: pardel.check(square, pardel.mesh(square), **test)], ids=["mesh", "refine", "check"])
def test_something_that_is_no_function_is_refused(square, call):
    with pytest.raises(pardel.UsageError, match="refine_if is 3; a function of the corners"):
        call(square, refine_if=3)


def test_the_function_is_not_held_after_the_run(square):
    class Test:
        def __call__(self, corners, area):
            return area > 0.1

    test = Test()
    gone = weakref.ref(test)
    pardel.check(square, pardel.mesh(square, refine_if=test), refine_if=test)
    del test
    assert gone() is None


@given(st.floats(0.002, 0.2), st.floats(0, 2), st.sampled_from([0, 20.7, 30]))
def test_any_bound_on_areas_that_depends_on_the_place_is_kept(least, growth, angle):
    def test(corners, area):
        return area > least + growth * corners[:, 0].min() ** 2

    domain = pardel.polygon([(0, 0), (3, 0), (1, 1), (0, 2)])
    made = pardel.mesh(domain, refine_if=test, min_angle=angle)
    assert made.report.goal_met and pardel.check(domain, made, refine_if=test, min_angle=angle)
