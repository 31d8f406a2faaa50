"""What the tests share: domains, and the settings of Hypothesis."""

import os
import tempfile

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis.configuration import set_hypothesis_home_dir

import pardel

# Nothing is left in the folder of the tests.
_home = tempfile.TemporaryDirectory()
set_hypothesis_home_dir(_home.name)
# The same cases in each run. PARDEL_EXAMPLES sets their number per property.
settings.register_profile("pardel", deadline=None, derandomize=True, database=None,
                          max_examples=int(os.environ.get("PARDEL_EXAMPLES", "60")),
                          suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much])
settings.load_profile("pardel")


@pytest.fixture
def square():
    """The unit square; the markers of its sides are 1 to 4."""
    return pardel.Domain([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)], markers=[1, 2, 3, 4])


@pytest.fixture
def plate():
    """A square with a square hole."""
    return pardel.polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)])


@pytest.fixture
def crossing():
    """Two segments that cross at (1, 1)."""
    return pardel.Domain([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (1, 2), (2, 3), (3, 0)])


@pytest.fixture
def random_points():
    return np.random.default_rng(7).random((500, 2))
