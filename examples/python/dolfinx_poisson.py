"""Gives a mesh and the markers of its boundary to DOLFINx (Debian: python3-dolfinx), and solves a problem of heat.

A square plate with a hole is kept at 0 degrees on the left and at 100 on the hole; the rest is insulated.

    python3 dolfinx_poisson.py
"""

import numpy as np
import ufl
from dolfinx import fem, mesh as dmesh
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI
from petsc4py.PETSc import ScalarType

import pardel

LEFT, HOLE = 4, 9


def plate():
    ring = [(0, 0), (4, 0), (4, 4), (0, 4)]
    hole = [(2 + 0.8 * np.cos(angle), 2 + 0.8 * np.sin(angle)) for angle in 2 * np.pi * np.arange(32) / 32]
    rings = pardel.polygon(ring, hole)
    return pardel.Domain(rings.points, rings.segments, holes=rings.holes, markers=[1, 2, 3, LEFT] + [HOLE] * 32)


def to_dolfinx(mesh):
    """The mesh of DOLFINx, and the tags of its facets: the markers of the segments."""
    element = ufl.Mesh(ufl.VectorElement("Lagrange", "triangle", 1))
    made = dmesh.create_mesh(MPI.COMM_SELF, mesh.triangles.astype(np.int64), mesh.points, element)
    made.topology.create_connectivity(1, 0)
    facets = made.topology.connectivity(1, 0).array.reshape(-1, 2)
    # The number that each vertex of DOLFINx had in our arrays.
    numbers = np.empty(made.topology.index_map(0).size_local, dtype=np.int64)
    numbers[made.topology.connectivity(2, 0).array] = np.array(made.geometry.input_global_indices)[
        made.geometry.dofmap.array]
    marker = {frozenset(ends): mark for ends, mark in zip(mesh.segments.tolist(), mesh.segment_markers.tolist())}
    tagged = [(k, marker[ends]) for k, ends in enumerate(map(frozenset, numbers[facets].tolist())) if ends in marker]
    which, tags = np.array(tagged, dtype=np.int32).T
    return made, dmesh.meshtags(made, 1, np.ascontiguousarray(which), np.ascontiguousarray(tags))


def main():
    made = pardel.mesh(plate(), min_angle=30, max_edge=0.1)
    domain, tags = to_dolfinx(made)
    space = fem.FunctionSpace(domain, ("Lagrange", 1))
    conditions = [fem.dirichletbc(ScalarType(value), fem.locate_dofs_topological(space, 1, tags.find(marker)), space)
                  for marker, value in ((LEFT, 0.0), (HOLE, 100.0))]
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    load = fem.Constant(domain, ScalarType(0)) * v * ufl.dx
    heat = LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx, load, bcs=conditions).solve()
    area, total = (fem.assemble_scalar(fem.form(part * ufl.dx)).real
                   for part in (fem.Constant(domain, ScalarType(1)), heat))
    print(f"{domain.topology.index_map(2).size_local} triangles, {len(tags.find(LEFT))} facets on the left, "
          f"{len(tags.find(HOLE))} on the hole")
    print(f"temperature from {heat.x.array.real.min():.1f} to {heat.x.array.real.max():.1f} degrees, "
          f"mean {total / area:.2f}")


if __name__ == "__main__":
    main()
