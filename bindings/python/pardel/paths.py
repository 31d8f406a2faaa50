"""Arguments that are paths of files."""

from __future__ import annotations

import os
from typing import Any, Type, TypeVar, Union

from . import _pardel
from .errors import UsageError

Path = Union[str, "os.PathLike[str]"]
Core = TypeVar("Core")


def text_of(path: Any) -> str:
    """The path of a file as text; raises `UsageError` for anything else, for example where arguments are swapped."""
    if not isinstance(path, (str, bytes, os.PathLike)):
        raise UsageError(f"path is a {type(path).__name__}; the path of a file is needed")
    return os.fsdecode(path)


def read_as(core: Type[Core], path: Path, found: str, needed: str) -> Core:
    """What is in the file; raises `UsageError` if it is no `core`, for example "a domain" where "a mesh" is needed."""
    read: Any = _pardel.read(text_of(path))
    if not isinstance(read, core):
        raise UsageError(f"{text_of(path)} is {found}; {needed} is needed")
    return read
