"""Solves -(u_xx + u_yy) = f with linear elements on finer and finer meshes of the unit square.

The error falls as theory says: by 4 in the mean square when the edges are halved, its gradient by 2.

    python3 poisson.py
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

import pardel

# A rule that integrates polynomials of degree 4: weights, and places as weights of the corners.
_A, _B = 0.445948490915965, 0.091576213509771
PLACES = np.array([np.roll((1 - 2 * c, c, c), k) for c in (_A, _B) for k in range(3)])
WEIGHTS = np.repeat([0.223381589678011, 0.109951743655322], 3)


def gradients(mesh):
    """The areas of all triangles, and the gradients of the three hat functions on each: shapes (m,) and (m, 3, 2)."""
    corners = mesh.points[mesh.triangles]
    opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)  # the edge across from each corner
    twice = opposite[:, 0, 0] * opposite[:, 1, 1] - opposite[:, 0, 1] * opposite[:, 1, 0]
    return twice / 2, np.stack([-opposite[:, :, 1], opposite[:, :, 0]], axis=2) / twice[:, None, None]


def solve(mesh, f, boundary):
    """The values of the solution at the points; `f` and `boundary` are functions of x and y."""
    areas, slopes = gradients(mesh)
    local = areas[:, None, None] * np.einsum("mid,mjd->mij", slopes, slopes)
    rows, columns = np.repeat(mesh.triangles, 3, axis=1).ravel(), np.tile(mesh.triangles, 3).ravel()
    matrix = coo_matrix((local.ravel(), (rows, columns))).tocsr()
    at = np.einsum("qi,mid->mqd", PLACES, mesh.points[mesh.triangles])
    load = np.zeros(len(mesh.points))
    values = f(*np.moveaxis(at, 2, 0))
    np.add.at(load, mesh.triangles, areas[:, None] * np.einsum("q,mq,qi->mi", WEIGHTS, values, PLACES))
    u = np.zeros(len(mesh.points))
    fixed = np.unique(mesh.segments)
    free = np.setdiff1d(np.unique(mesh.triangles), fixed)
    u[fixed] = boundary(*mesh.points[fixed].T)
    u[free] = spsolve(matrix[free][:, free], load[free] - matrix[free][:, fixed] @ u[fixed])
    return u


def errors(mesh, u, exact, exact_gradient):
    """The error in the mean square, and that of the gradient."""
    areas, slopes = gradients(mesh)
    x, y = np.moveaxis(np.einsum("qi,mid->mqd", PLACES, mesh.points[mesh.triangles]), 2, 0)
    of_value = exact(x, y) - u[mesh.triangles] @ PLACES.T
    of_gradient = np.stack(exact_gradient(x, y), axis=2) - np.einsum("mi,mid->md", u[mesh.triangles], slopes)[:, None]
    return [float(np.sqrt(np.sum(areas[:, None] * WEIGHTS * square)))
            for square in (of_value**2, np.sum(of_gradient**2, axis=2))]


def study(lengths=(0.1, 0.05, 0.025, 0.0125)):
    """For each length of edges: the number of triangles and the two errors."""
    pi, sin, cos = np.pi, np.sin, np.cos
    square = pardel.polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    for length in lengths:
        mesh = pardel.mesh(square, min_angle=30, max_edge=length)
        u = solve(mesh, lambda x, y: 2 * pi**2 * sin(pi * x) * sin(pi * y), lambda x, y: 0 * x)
        yield (length, len(mesh.triangles), *errors(mesh, u, lambda x, y: sin(pi * x) * sin(pi * y), lambda x, y: (
            pi * cos(pi * x) * sin(pi * y), pi * sin(pi * x) * cos(pi * y))))


if __name__ == "__main__":
    print("  edge  triangles  error of u  rate  of gradient  rate")
    before = None
    for length, triangles, value, gradient in study():
        rates = [f"{np.log2(old / new):5.2f}" for old, new in zip(before or (), (value, gradient))] or ["     ", ""]
        print(f"{length:6.4f}  {triangles:9d}    {value:.2e} {rates[0]}     {gradient:.2e} {rates[1]}".rstrip())
        before = value, gradient
