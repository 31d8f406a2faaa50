"""Loads the module `_pardel` so that threads that wait for others soon sleep.

GCC's OpenMP library lets a waiting thread check for work 300,000 times, some milliseconds, before it sleeps. On a machine
with other work, such threads take the time of those they wait for. The library reads its settings when it is loaded, so
they are set while the module is loaded, unless the user has set them. If another package has loaded the library before,
nothing changes.
"""

from __future__ import annotations

import os

_SPINS = "GOMP_SPINCOUNT"


def load() -> None:
    """Imports `_pardel`. The environment is the same afterwards."""
    decided = _SPINS in os.environ or "OMP_WAIT_POLICY" in os.environ
    if not decided:
        os.environ[_SPINS] = "1000"
    try:
        from . import _pardel  # noqa: F401
    finally:
        if not decided:
            del os.environ[_SPINS]


load()
