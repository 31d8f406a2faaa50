"""Files in all formats of the library. Ctrl-C ends reading and writing."""

from __future__ import annotations

from typing import Any, Union

from . import _pardel
from ._mesh import Mesh
from .domain import Domain, domain_of
from .mesh_like import mesh_of
from .paths import Path, text_of
from .shapes import is_shapes


def read(path: Path) -> Union[Domain, Mesh]:
    """Reads a domain (.poly, .geojson, .json, or .node without an .ele) or a mesh. The suffix determines the format.

    Meshes: .node and .ele, .msh, .vtu, .pvtu, .vtk, .off, .2dm, .gr3, .14. docs/formats.md has the details.
    Raises `FileError` if the file cannot be read, `InvalidInput` with the line if its content is wrong.
    """
    core = _pardel.read(text_of(path))
    return Domain._of(core) if isinstance(core, _pardel.Pslg) else Mesh._of(core)


def write(path: Path, mesh: Any, *, as_text: bool = False, second_order: bool = False) -> None:
    """Writes a mesh or a domain. The suffix determines the format. The file appears whole, or not at all.

    mesh: a `Domain` or a geometry for .poly and .svg; a mesh, in each form that `check` takes, for .node and .ele,
    .msh, .vtu, .vtk, .off, .2dm, .gr3, .14, .inp, .svg. as_text: a .msh without binary numbers.
    second_order: six nodes per triangle.
    Raises `FileError`; `UsageError` if the format cannot have it.

    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "square.vtu"
    >>> write(file, ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)]))
    >>> read(file)
    Mesh(4 points, 2 triangles)
    """
    file = text_of(path)
    if isinstance(mesh, Domain) or is_shapes(mesh):
        _pardel.write_domain(file, domain_of(mesh)._core)
    else:
        _pardel.write_mesh(file, mesh_of(mesh)._core, as_text, second_order)
