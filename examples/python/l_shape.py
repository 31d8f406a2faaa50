"""The corner of an L-shaped domain spoils the rate of convergence, and a graded mesh restores it.

u = r^(2/3) sin(2/3 angle) has no curvature bound at the corner. Uniform meshes of N triangles give an error of the
gradient of N^(-1/3); edges that shrink as h sqrt(r) towards the corner give N^(-1/2), as on a square.

    python3 l_shape.py        (poisson.py beside it has the elements)
"""

import numpy as np

import pardel
from poisson import errors, solve

CORNERS = [(0, 0), (1, 0), (1, 1), (-1, 1), (-1, -1), (0, -1)]


def polar(x, y):
    return np.hypot(x, y), np.arctan2(y, x) % (2 * np.pi)


def exact(x, y):
    r, angle = polar(x, y)
    return r**(2 / 3) * np.sin(2 / 3 * angle)


def exact_gradient(x, y):
    r, angle = polar(x, y)
    return -2 / 3 * r**(-1 / 3) * np.sin(angle / 3), 2 / 3 * r**(-1 / 3) * np.cos(angle / 3)


def study(meshes):
    """The number of triangles of each mesh, and the error of the gradient on it."""
    for mesh in meshes:
        u = solve(mesh, lambda x, y: 0 * x, exact)
        yield len(mesh.triangles), errors(mesh, u, exact, exact_gradient)[1]


def uniform(domain, lengths=(0.2, 0.1, 0.05, 0.025)):
    return (pardel.mesh(domain, min_angle=30, max_edge=length) for length in lengths)


def graded(domain, lengths=(0.2, 0.1, 0.05, 0.025)):
    """Near the corner, edges have the length h sqrt(r), but at least h^2."""
    return (pardel.mesh(domain, min_angle=30, size=lambda x, y: h * max((x * x + y * y)**0.25, h)) for h in lengths)


def rates(rows):
    """The exponents of N between one row and the next."""
    return [np.log(old[1] / new[1]) / np.log(new[0] / old[0]) for old, new in zip(rows, rows[1:])]


if __name__ == "__main__":
    domain = pardel.polygon(CORNERS)
    for name, meshes in (("uniform", uniform(domain)), ("graded", graded(domain))):
        rows = list(study(meshes))
        for (triangles, error), rate in zip(rows, [None, *rates(rows)]):
            print(f"{name:8s} {triangles:6d} triangles, error of the gradient {error:.4f}"
                  + (f", N^-{rate:.2f}" if rate else ""))
