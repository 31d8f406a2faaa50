"""Meshes a steel bracket with an inlay of aluminium, which are drawn with shapely: united, cut, rounded, intersected.

    python3 bracket.py [FILE.vtu]
"""

import sys

import numpy as np
from shapely.geometry import LineString, Point, box

import pardel

BOLTS = [(15, 15), (15, 85), (105, 15)]  # millimetres
BOLT_RADIUS, FILLET, FINEST, COARSEST = 5.0, 8.0, 0.8, 6.0
STEEL, ALUMINIUM = 1, 2


def bracket():
    """The two parts: polygons that share a border and do not overlap."""
    arms = box(0, 0, 30, 100).union(box(0, 0, 120, 30))
    outline = arms.buffer(FILLET).buffer(-2 * FILLET).buffer(FILLET)  # rounds both kinds of corners
    slot = LineString([(50, 15), (80, 15)]).buffer(4)
    for place in BOLTS:
        outline = outline.difference(Point(place).buffer(BOLT_RADIUS))
    body = outline.difference(slot)
    inlay = body.intersection(box(5, 35, 25, 65))
    return body.difference(inlay), inlay


def around_bolts():
    """Where edges are short, as `sources` takes them: the rims of the bolts, with a length."""
    rims = [Point(place).buffer(BOLT_RADIUS) for place in BOLTS]
    return pardel.Sources.of(rims, length=FINEST)


def main(arguments):
    parts = bracket()
    domain = pardel.geometry(parts, attribute=[STEEL, ALUMINIUM])
    bounds = dict(min_angle=30, max_edge=COARSEST, sources=around_bolts(), grading=0.2)
    mesh = pardel.mesh(domain, **bounds)
    print(f"{len(mesh.points)} points, {len(mesh.triangles)} triangles; right: "
          f"{pardel.check(domain, mesh, **bounds).valid}")
    corners = mesh.points[mesh.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = 0.5 * (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    materials = mesh.region_attributes[mesh.regions]
    for material, name, part in zip((STEEL, ALUMINIUM), ("steel", "aluminium"), parts):
        print(f"{name}: {areas[materials == material].sum():.1f} square millimetres, drawn {part.area:.1f}")
    lengths = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    print(f"edges from {lengths.min():.2f} to {lengths.max():.2f} millimetres")
    if arguments:
        mesh.save(arguments[0])


if __name__ == "__main__":
    main(sys.argv[1:])
