"""Progress of the mesher, for people."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

from .errors import UsageError

# Called with the number of triangles so far and the estimated final number, which is 0 while it is not known.
Progress = Union[None, bool, Callable[[int, float], Optional[bool]]]


@contextmanager
def reporting(progress: Progress) -> Iterator[Optional[Callable[[int, float], Optional[bool]]]]:
    """The function to call; for True one that draws a bar of tqdm."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        with _bar() as bar:
            yield _drawing(bar)
    elif callable(progress):
        yield progress
    else:
        raise UsageError(f"progress is {progress!r}; a function, True or None is needed")


def _bar() -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import]
    except ImportError:
        raise UsageError("progress=True needs the package tqdm; or give a function") from None
    return tqdm(unit=" triangles", unit_scale=True)


def _drawing(bar: Any) -> Callable[[int, float], None]:
    def draw(triangles: int, estimate: float) -> None:
        bar.total = max(triangles, int(estimate)) or None
        bar.update(triangles - bar.n)

    return draw
