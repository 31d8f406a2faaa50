"""pardel.generate: the named domains of the program."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel


@pytest.mark.parametrize("kind", pardel.generators())
def test_each_generated_domain_is_valid(kind):
    sizes = pardel.generators()[kind]
    domain = pardel.generate(kind, 0 if sizes is None else max(sizes[0], min(sizes[1], 50)))
    assert not pardel.validate(domain) and len(domain.points) > 2


@given(st.integers(1, 2**64 - 1), st.integers(3, 200))
def test_a_seed_gives_the_same_points_each_time(seed, n):
    points = pardel.generate("points", n, seed=seed)
    assert points == pardel.generate("points", n, seed=seed)
    assert points != pardel.generate("points", n, seed=seed - 1)
    assert len(points.points) == n


def test_the_usual_size_is_that_of_zero():
    sizes = {kind: size for kind, size in pardel.generators().items() if size and size[2] <= 1000}
    assert sizes
    for kind, (_, _, usual) in sizes.items():
        assert pardel.generate(kind) == pardel.generate(kind, usual)


def test_a_generated_domain_is_meshed():
    pipe = pardel.generate("pipe")
    assert set(pipe.markers) == {1, 2, 3}
    assert pardel.check(pipe, pardel.mesh(pipe)).valid


def test_radial_sizes_grow_with_the_distance():
    radial = pardel.generate("radial", 3)
    sizes = pardel.radial_sizes(radial, ratio=0.25)
    distance = np.hypot(*radial.points.T)
    innermost = distance[distance > 0].min()
    assert sizes == pytest.approx(0.25 * np.maximum(distance, innermost))
    assert pardel.check(radial, pardel.mesh(radial, size=sizes), size=sizes).valid


@pytest.mark.parametrize("arguments, message", [
    (("lake",), "no domain named 'lake'. Known are: .*pipe"),
    ((3,), "kind is 3; the name of a domain is needed"),
    (("pipe", 7), "'pipe' has no size to choose"),
    (("comb", 10**6), "size of 'comb' must be from 1 to 100000"),
    (("comb", -1), "n is -1"),
    (("comb", 1.5), "n is 1.5"),
])
def test_a_wrong_kind_or_size_is_named(arguments, message):
    with pytest.raises(pardel.UsageError, match=message):
        pardel.generate(*arguments)


@pytest.mark.parametrize("seed", [-1, 2**64, 0.5, True, "one"])
def test_a_wrong_seed_is_named(seed):
    with pytest.raises(pardel.UsageError, match="seed is"):
        pardel.generate("points", seed=seed)


@pytest.mark.parametrize("ratio", [0, -1, float("nan"), float("inf"), "fine"])
def test_a_wrong_ratio_is_named(ratio):
    with pytest.raises(pardel.UsageError, match="ratio is"):
        pardel.radial_sizes(pardel.generate("radial"), ratio)
