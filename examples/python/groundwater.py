"""A grid of triangles for a groundwater model with wells, a river and two aquifers, as MODFLOW 6 reads it (DISV).

`disv` returns the lists that flopy.mf6.ModflowGwfdisv takes as `vertices` and `cell2d`; `write_disv` writes the file
that mf6 reads. Cells are triangles, so use the option XT3D of the package NPF.

    python3 groundwater.py [FILE.disv]
"""

import sys

import numpy as np

import pardel

OUTLINE = [(0, 0), (2000, 0), (2000, 1200), (0, 1200)]  # metres
RIVER = [(0, 900), (500, 700), (900, 760), (1400, 500), (2000, 560)]
FAULT_LINE = [(1100, 0), (900, 760)]  # with a part of the river, the border between the aquifers
WELLS = [(400, 300), (1500, 900), (1650, 250)]
ON_RIVER, ON_FAULT = 2, 3
CONDUCTIVITIES = {1: 12.0, 2: 0.8}  # metres per day, by aquifer


def domain_and_lengths():
    """The domain with markers and regions, and the length of edges at each point: 8 m at wells, 40 m at the river."""
    points = [*OUTLINE, *RIVER, FAULT_LINE[0], *WELLS]
    index = {place: k for k, place in enumerate(points)}
    ring = [(0, 0), (1100, 0), (2000, 0), (2000, 560), (2000, 1200), (0, 1200), (0, 900)]
    lines = [(ring + ring[:1], 1), (RIVER, ON_RIVER), (FAULT_LINE, ON_FAULT)]
    segments = [(index[a], index[b]) for line, _ in lines for a, b in zip(line, line[1:])]
    markers = [marker for line, marker in lines for _ in line[1:]]
    regions = [(100, 100, 1), (1900, 100, 2), (1000, 1100, 1)]  # a place in each face, and its aquifer
    lengths = [8 if place in WELLS else 40 if place in RIVER else 120 for place in points]
    return pardel.Domain(points, segments, markers=markers, regions=regions), lengths


def disv(mesh):
    """The lists vertices and cell2d, counted from 0; the corners of a cell are clockwise."""
    vertices = [[k, x, y] for k, (x, y) in enumerate(mesh.points.tolist())]
    centres = mesh.points[mesh.triangles].mean(axis=1).tolist()
    cell2d = [[k, x, y, 3, a, c, b] for k, ((x, y), (a, b, c)) in enumerate(zip(centres, mesh.triangles.tolist()))]
    return vertices, cell2d


def write_disv(path, vertices, cell2d, top=50.0, bottom=0.0):
    """Writes the file of a grid with one layer. Numbers count from 1 there."""
    blocks = {
        "OPTIONS": ["LENGTH_UNITS meters"],
        "DIMENSIONS": ["NLAY 1", f"NCPL {len(cell2d)}", f"NVERT {len(vertices)}"],
        "GRIDDATA": ["TOP", f"CONSTANT {top}", "BOTM LAYERED", f"CONSTANT {bottom}"],
        "VERTICES": [f"{k + 1} {x!r} {y!r}" for k, x, y in vertices],
        "CELL2D": [f"{k + 1} {x!r} {y!r} {n} " + " ".join(str(c + 1) for c in corners)
                   for k, x, y, n, *corners in cell2d],
    }
    with open(path, "w") as file:
        for name, lines in blocks.items():
            file.write(f"BEGIN {name}\n" + "".join(f"  {line}\n" for line in lines) + f"END {name}\n\n")


def main(arguments):
    domain, lengths = domain_and_lengths()
    mesh = pardel.mesh(domain, min_angle=30, size=lengths, grading=0.2)
    vertices, cell2d = disv(mesh)
    aquifers = mesh.region_attributes[mesh.regions].astype(int)
    conductivity = np.array([CONDUCTIVITIES[aquifer] for aquifer in aquifers])  # one number per cell, for NPF
    river = set(mesh.segments[mesh.segment_markers == ON_RIVER].ravel().tolist())
    at_river = [k for k, corners in enumerate(mesh.triangles.tolist()) if len(river & set(corners)) == 2]
    first_well = len(domain.points) - len(WELLS)  # the points of the domain come first, in their order
    at_wells = [int((mesh.triangles == first_well + k).any(axis=1).sum()) for k in range(len(WELLS))]
    print(f"{len(vertices)} vertices, {len(cell2d)} cells; right: {pardel.check(domain, mesh, min_angle=30).valid}")
    for value in sorted(set(conductivity.tolist())):
        print(f"{np.sum(conductivity == value)} cells with a conductivity of {value} metres per day")
    print(f"{len(at_river)} cells beside the river, {at_wells} cells around the wells")
    if arguments:
        write_disv(arguments[0], vertices, cell2d)


if __name__ == "__main__":
    main(sys.argv[1:])
