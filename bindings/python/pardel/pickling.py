"""Pickled and copied meshes."""

from __future__ import annotations

import copy
from typing import Any, Dict, Optional, Tuple

from . import _pardel
from .domain import Domain
from .errors import UsageError

# Of the pickled form. A later form gets another number, and this one is still read.
_FORM = 1


def reduced(mesh: Any) -> Tuple[Any, ...]:
    """What ``pickle`` needs: a function and its arguments."""
    rest = {name: value for name, value in vars(mesh).items() if name != "_core"}
    return restored, (type(mesh), _FORM, _pardel.state_of(mesh._core), mesh.domain, rest)


def restored(cls: Any, form: int, state: Dict[str, Any], domain: Optional[Domain], rest: Dict[str, Any]) -> Any:
    """The mesh that was pickled."""
    if form != _FORM:
        raise UsageError(f"the mesh was pickled by a later version of pardel, in form {form}; this one reads form "
                         f"{_FORM}")
    mesh = cls.__new__(cls)
    vars(mesh).update(rest)
    mesh._core = _pardel.mesh_of_state(state, None if domain is None else domain._core)
    return mesh


def copied(mesh: Any) -> Any:
    """Another mesh with the same memory: a mesh never changes."""
    other = object.__new__(type(mesh))
    vars(other).update(vars(mesh))
    return other


def deeply_copied(mesh: Any, memo: Dict[int, Any]) -> Any:
    """The same, and copies of attributes that the caller has added."""
    other = memo[id(mesh)] = object.__new__(type(mesh))
    shared = ("_core", "_report")
    for name, value in vars(mesh).items():
        setattr(other, name, value if name in shared else copy.deepcopy(value, memo))
    return other
