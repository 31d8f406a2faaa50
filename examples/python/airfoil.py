"""Meshes the air around a NACA 0012 airfoil: short edges on the airfoil, longer ones away from it.

    python3 airfoil.py [FILE.vtu]
"""

import sys

import numpy as np

import pardel

HALF = 60      # points on each side of the airfoil; its chord has the length 1
RADIUS = 20.0  # of the far boundary, a polygon of 64 corners
GROWTH = 0.15  # how much longer edges become per unit of distance


def naca0012(count):
    """The corners of the airfoil, from the trailing edge over the upper side and back; dense at both ends."""
    x = 0.5 * (1 + np.cos(np.pi * np.arange(count + 1) / count))
    y = 0.6 * (0.2969 * np.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)  # closed at x = 1
    y[0] = 0
    upper, lower = np.column_stack([x, y]), np.column_stack([x, -y])
    return np.vstack([upper, lower[-2:0:-1]])


def wind_tunnel():
    """The domain, and one length per point: as long as the sides of the polygons there."""
    airfoil = naca0012(HALF)
    angles = 2 * np.pi * np.arange(64) / 64
    far = RADIUS * np.column_stack([np.cos(angles), np.sin(angles)]) + (0.5, 0)
    domain = pardel.polygon(far, airfoil)
    sides = [np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1) for ring in (far, airfoil)]
    lengths = np.concatenate([np.maximum(side, np.roll(side, 1)) for side in sides])
    return domain, lengths * (1 + 1e-9)  # a side of exactly this length may stay


def main(arguments):
    domain, lengths = wind_tunnel()
    mesh = pardel.mesh(domain, min_angle=30, size=lengths, grading=GROWTH)
    certificate = pardel.check(domain, mesh, min_angle=30, size=lengths, grading=GROWTH)
    extremes = certificate.extremes
    print(f"{len(mesh.points)} points, {len(mesh.triangles)} triangles")
    print(f"edges from {extremes['min_edge'].value:.4f} to {extremes['max_edge'].value:.2f} chords")
    print(f"smallest angle {extremes['min_angle'].value:.1f} degrees, at ({extremes['min_angle'].coordinates[0]:.2f}, "
          f"{extremes['min_angle'].coordinates[1]:.2f})")
    print(f"every bound holds: {certificate.valid}")
    if arguments:
        pardel.write(arguments[0], mesh)


if __name__ == "__main__":
    main(sys.argv[1:])
