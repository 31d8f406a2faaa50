"""Arguments that are paths of files."""

from __future__ import annotations

import os
from typing import Any, Type, TypeVar, Union

from . import _pardel
from .errors import UsageError

Path = Union[str, "os.PathLike[str]"]
Core = TypeVar("Core")


def read_as(core: Type[Core], path: Path, found: str, needed: str) -> Core:
    """What is in the file; raises `UsageError` if it is no `core`, for example "a domain" where "a mesh" is needed."""
    read: Any = _pardel.read(os.fspath(path))
    if not isinstance(read, core):
        raise UsageError(f"{os.fspath(path)} is {found}; {needed} is needed")
    return read
