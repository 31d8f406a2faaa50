"""Adaptive meshes: solve, estimate the error in each triangle, choose edge lengths at the points, and mesh again.

The problem is that of l_shape.py, but nothing tells the loop where the corner is. The estimate of a triangle is what
the gradient jumps at its edges; the new mesh has edges that would make all triangles contribute the same.

    python3 adaptive.py       (poisson.py and l_shape.py beside it have the elements and the problem)
"""

import numpy as np

import pardel
from l_shape import CORNERS, exact, exact_gradient
from poisson import errors, gradients, solve


def estimates(mesh, u):
    """One number per triangle: the square root of half the sum, over its inner edges, of (length * jump)^2."""
    slope = np.einsum("mi,mid->md", u[mesh.triangles], gradients(mesh)[1])
    squares = np.zeros(len(mesh.triangles))
    for k in range(3):  # the edge opposite corner k, and the triangle across it
        inner = np.flatnonzero(mesh.neighbors[:, k] >= 0)
        ends = mesh.points[mesh.triangles[inner][:, [(k + 1) % 3, (k + 2) % 3]]]
        along = ends[:, 1] - ends[:, 0]
        jump = slope[inner] - slope[mesh.neighbors[inner, k]]
        squares[inner] += (jump[:, 0] * along[:, 1] - jump[:, 1] * along[:, 0])**2  # length times the normal part
    return np.sqrt(squares / 2)


def new_lengths(mesh, estimate, target):
    """One length per point. The estimate of a triangle goes with its size to the power 1 to 2; half a step is safe."""
    corners = mesh.points[mesh.triangles]
    longest = np.linalg.norm(np.roll(corners, 1, axis=1) - corners, axis=2).max(axis=1)
    wanted = longest * np.clip(np.sqrt(target / np.maximum(estimate, 1e-300)), 0.4, 1.5)
    lengths = np.full(len(mesh.points), np.inf)
    np.minimum.at(lengths, mesh.triangles, wanted[:, None])
    return np.minimum(lengths, 0.5)


def adapt(domain, steps=5):
    """The loop. For each mesh: the number of triangles, the estimate, the true error of the gradient, the mesh."""
    mesh = pardel.mesh(domain, min_angle=30, max_edge=0.3)
    for _ in range(steps):
        u = solve(mesh, lambda x, y: 0 * x, exact)
        estimate = estimates(mesh, u)
        yield len(mesh.triangles), np.sqrt(np.sum(estimate**2)), errors(mesh, u, exact, exact_gradient)[1], mesh
        target = 0.5 * np.sqrt(np.mean(estimate**2))
        mesh = pardel.mesh(domain, min_angle=30, size=(mesh, new_lengths(mesh, estimate, target)))


if __name__ == "__main__":
    for count, estimate, error, mesh in adapt(pardel.polygon(CORNERS)):
        at_corner = np.linalg.norm(mesh.points[mesh.triangles[(mesh.triangles == 0).any(axis=1)]], axis=2).max()
        print(f"{count:6d} triangles, estimate {estimate:.4f}, error {error:.4f}, edges at the corner {at_corner:.5f}")
