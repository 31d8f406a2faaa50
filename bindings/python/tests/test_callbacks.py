"""Functions of the caller: sizes and progress. Their exceptions come back as themselves."""

import sys
import threading
import time
import traceback

import numpy as np
import pytest

import pardel


class Own(Exception):
    """An exception that only these tests know."""


def fail(*_):
    raise Own("from the function")


def lengths_at(places):
    return 0.02 + 0.1 * places[:, 0]


@pytest.mark.parametrize("size", [lengths_at, lambda x, y: 0.02 + 0.1 * x], ids=["of arrays", "of numbers"])
def test_edges_are_no_longer_than_a_function_allows(square, size):
    made = pardel.mesh(square, size=size)
    assert pardel.check(square, made, size=size)
    assert not pardel.check(square, made, size=lambda x, y: 0.9 * (0.02 + 0.1 * x))


def test_both_kinds_of_functions_make_the_same_mesh(square):
    assert pardel.mesh(square, size=lengths_at).digest == pardel.mesh(square, size=lambda x, y: 0.02 + 0.1 * x).digest


def test_a_function_of_arrays_gets_places_of_shape_n_2_and_few_of_them_alone(square):
    shapes, places_of_numbers = [], []
    pardel.mesh(square, size=lambda places: shapes.append(places.shape) or lengths_at(places))
    pardel.mesh(square, size=lambda x, y: places_of_numbers.append((x, y)) or 0.02 + 0.1 * x)
    assert {shape[1:] for shape in shapes} == {(2,)}
    assert len(shapes) < len(places_of_numbers) / 5
    assert sum(shape[0] for shape in shapes) < 1.5 * len(places_of_numbers)


@pytest.mark.parametrize("options", [dict(grading=0.2), dict(max_edge=0.05), dict(conforming=True), dict(threads=2)])
def test_a_function_of_arrays_makes_the_mesh_of_one_of_numbers_with_other_bounds(plate, options):
    by_arrays = pardel.mesh(plate, size=lengths_at, **options)
    assert by_arrays.digest == pardel.mesh(plate, size=lambda x, y: 0.02 + 0.1 * x, **options).digest


def test_the_checker_asks_for_many_places_at_once(square):
    made, calls = pardel.mesh(square, max_area=1e-4), []
    pardel.check(square, made, size=lambda places: calls.append(len(places)) or np.ones(len(places)))
    assert calls == [len(made.triangles)]


def test_a_function_of_arrays_may_return_one_number(square):
    made = pardel.mesh(square, size=lambda places: 0.1)
    assert made.digest == pardel.mesh(square, size=lambda x, y: 0.1).digest


def test_a_number_bounds_all_edges(square):
    assert pardel.mesh(square, size=0.1).digest == pardel.mesh(square, max_edge=0.1).digest
    for size, edge in ((0.1, 0.3), (0.3, 0.1)):  # the smaller one counts
        assert pardel.mesh(square, size=size, max_edge=edge).digest == pardel.mesh(square, max_edge=0.1).digest


@pytest.mark.parametrize("wrong", [0, -1, np.nan, np.inf])
def test_a_wrong_length_at_a_point_is_named(square, wrong):
    with pytest.raises(pardel.UsageError, match=rf"size\[2\] is {wrong}.*; a finite number greater than 0"):
        pardel.mesh(square, size=[0.1, 0.1, wrong, 0.1])


def test_lengths_at_the_points_are_interpolated(square):
    lengths = np.array([0.02, 0.2, 0.2, 0.02])
    made = pardel.mesh(square, size=lengths)
    assert pardel.check(square, made, size=lengths)
    assert pardel.check(square, made, size=lambda x, y: 0.02 + 0.18 * x + 1e-12)


def test_lengths_at_the_points_stay_with_them_in_a_repair(square):
    points = np.concatenate([square.points, [(1, 0)]])  # the second point, twice
    segments = [(0, 1), (4, 2), (2, 3), (3, 0)]
    made = pardel.mesh(points, segments, size=[0.02, 0.2, 0.2, 0.02, 0.2], repair=True)
    assert made.digest == pardel.mesh(square.points, square.segments, size=[0.02, 0.2, 0.2, 0.02]).digest


def test_lengths_may_be_those_of_another_mesh(square):
    background = pardel.mesh(square, max_edge=0.3)
    lengths = 0.02 + 0.1 * background.points[:, 0]
    made = pardel.mesh(square, size=(background, lengths))
    assert pardel.check(square, made, size=(background, lengths))


def test_a_limit_on_gradation_makes_lengths_grow_slowly(square):
    sharp = [0.01, 1.0, 1.0, 1.0]
    assert len(pardel.mesh(square, size=sharp, grading=0.1).triangles) > len(pardel.mesh(square, size=sharp).triangles)


def test_feature_size_puts_edges_across_a_channel():
    channel = pardel.polygon([(0, 0), (10, 0), (10, 1), (0, 1)])
    made = pardel.mesh(channel, feature_size=4)
    assert len(made.triangles) > 4 * len(pardel.mesh(channel).triangles)
    assert pardel.check(channel, made, feature_size=4)


@pytest.mark.parametrize("threads", [1, 2])
def test_an_exception_of_a_size_function_comes_back_as_itself(square, threads):
    with pytest.raises(Own, match="from the function") as caught:
        pardel.mesh(square, size=fail, threads=threads)
    assert "fail" in [frame.name for frame in traceback.extract_tb(caught.value.__traceback__)]


def test_an_exception_of_a_function_of_arrays_comes_back_as_itself(square):
    with pytest.raises(Own):
        pardel.mesh(square, size=lambda places: fail())


def test_an_exception_after_many_calls_comes_back_as_itself(square):
    calls = []

    def later(x, y):
        calls.append(1)
        return fail() if len(calls) > 1000 else 0.01

    with pytest.raises(Own):
        pardel.mesh(square, size=later)
    assert len(calls) == 1001


def test_an_exception_of_a_size_function_comes_back_from_the_checker(square):
    with pytest.raises(Own):
        pardel.check(square, pardel.mesh(square), size=fail)


def test_an_exception_of_a_size_function_comes_back_from_a_refinement(square):
    with pytest.raises(Own):
        pardel.refine(pardel.mesh(square), size=fail)


def test_the_mesher_works_after_an_exception_of_a_function(square):
    with pytest.raises(Own):
        pardel.mesh(square, size=fail)
    assert pardel.mesh(square, size=lambda x, y: 0.2).report.goal_met


class WithoutNumber:
    def __repr__(self):
        return "W" * 100


@pytest.mark.parametrize("length, text", [
    (None, "None"), ("long", "'long', a str"), (1j, "1j, a complex"), ((1, 2), r"\(1, 2\), a tuple"),
    (np.ones(2), r"array\(\[1., 1.\]\), a ndarray"), (WithoutNumber(), r"W{60}\.\.\., a WithoutNumber"),
])
def test_a_length_that_is_no_number_is_a_type_error_that_shows_it(square, length, text):
    expected = f"^size returned {text}; it must return a number greater than 0$"
    for run in (pardel.mesh, lambda domain, size: pardel.check(domain, pardel.mesh(domain), size=size)):
        with pytest.raises(TypeError, match=expected):
            run(square, size=lambda x, y: length)


@pytest.mark.parametrize("lengths, text", [
    (None, "None"), (["long"], r"\['long'\], a list"), ("0.1", "'0.1', a str"), ({}, "{}, a dict"),
    (np.array([1j]), r"array\(\[0.\+1.j\]\), a ndarray"), ([[1], [1, 2]], r"\[\[1\], \[1, 2\]\], a list"),
])
def test_lengths_that_are_no_numbers_are_a_type_error_that_shows_them(square, lengths, text):
    expected = f"^size returned {text}; it must return numbers greater than 0, one per place$"
    for run in (pardel.mesh, lambda domain, size: pardel.check(domain, pardel.mesh(domain), size=size)):
        with pytest.raises(TypeError, match=expected):
            run(square, size=lambda places: lengths)


def test_an_exception_in_the_number_that_was_returned_comes_back_as_itself(square):
    class Number:
        def __float__(self):
            raise Own("from the number")

    with pytest.raises(Own, match="from the number"):
        pardel.mesh(square, size=lambda x, y: Number())


def test_lengths_may_be_numbers_of_any_kind(square):
    from fractions import Fraction

    whole, usual = (pardel.mesh(square, size=size).digest for size in (lambda x, y: 1, lambda x, y: 1.0))
    assert whole == usual == pardel.mesh(square, size=lambda places: [Fraction(1)] * len(places)).digest


def test_a_wrong_number_of_lengths_is_a_value_error(square):
    with pytest.raises(ValueError, match=r"size returned an array of shape \(3,\) for [0-9]+ places"):
        pardel.mesh(square, size=lambda places: np.ones(3))


@pytest.mark.parametrize("length", [0, -1.5, float("nan")])
def test_a_length_that_is_not_positive_is_a_usage_error_that_names_the_place(square, length):
    with pytest.raises(pardel.UsageError, match=r"^size returned .* at \("):
        pardel.mesh(square, size=lambda x, y: length)


def test_an_infinite_length_is_no_bound(square):
    assert pardel.mesh(square, size=lambda x, y: float("inf")).digest == pardel.mesh(square).digest


def test_progress_is_reported_with_growing_numbers(square):
    seen = []
    pardel.mesh(square, max_area=2e-6, progress=lambda triangles, estimate: seen.append((triangles, estimate)))
    triangles = [each[0] for each in seen]
    assert triangles and triangles == sorted(triangles)


def test_an_exception_of_progress_comes_back_as_itself(square):
    with pytest.raises(Own):
        pardel.mesh(square, max_area=1e-7, progress=fail)


def test_progress_ends_the_run_by_returning_false(square):
    start = time.monotonic()
    with pytest.raises(pardel.Cancelled):
        pardel.mesh(square, max_area=1e-9, progress=lambda *_: False)
    assert time.monotonic() - start < 2


def test_progress_may_be_a_bar_of_tqdm(square, monkeypatch):
    import sys
    import types

    class Bar:
        def __init__(self, **_):
            self.n, self.total = 0, None

        def update(self, more):
            self.n += more
            bars.append((self.n, self.total))

        def __enter__(self):
            return self

        def __exit__(self, *_):
            return None

    bars = []
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    pardel.mesh(square, max_area=2e-6, progress=True)
    assert bars and all(total is None or n <= total for n, total in bars)


def test_progress_that_is_no_function_is_a_usage_error(square):
    with pytest.raises(pardel.UsageError, match="progress is 3"):
        pardel.mesh(square, progress=3)


def test_functions_hold_no_reference_after_the_run(square):
    import weakref

    class Length:
        def __call__(self, x, y):
            return 0.1

    size = Length()
    gone = weakref.ref(size)
    pardel.mesh(square, size=size)
    del size
    assert gone() is None


def test_other_threads_run_while_a_size_function_is_asked(square):
    counted, ended, seen = [0], threading.Event(), set()

    def count():
        while not ended.wait(0.001):
            counted[0] += 1

    def size(x, y):
        seen.add(counted[0])
        return 0.005

    interval, deadline = sys.getswitchinterval(), time.monotonic() + 60
    sys.setswitchinterval(100)  # the interpreter takes the lock from no thread, so only the mesher gives it back
    other = threading.Thread(target=count)
    other.start()
    try:
        while len(seen) <= 5 and time.monotonic() < deadline:
            pardel.mesh(square, size=size)
    finally:
        ended.set()
        sys.setswitchinterval(interval)
        other.join()
    assert len(seen) > 5
