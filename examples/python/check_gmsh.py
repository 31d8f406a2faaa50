"""Meshes a plate with the program gmsh, with three of its algorithms, and checks each mesh in exact arithmetic.

    python3 check_gmsh.py
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import pardel

OUTLINE = [(0, 0), (4, 0), (4, 3), (0, 3)]
WINDOW = [(1, 1), (2, 1), (2, 2), (1, 2)]
ALGORITHMS = {1: "MeshAdapt", 5: "Delaunay", 6: "Frontal-Delaunay"}


def geo(rings, length):
    """The domain in the language of Gmsh: the first ring is the outline, the others are holes."""
    lines, loops, count = [], [], 0
    for ring in rings:
        ids = [count + k + 1 for k in range(len(ring))]
        lines += [f"Point({k}) = {{{x!r}, {y!r}, 0, {length}}};" for k, (x, y) in zip(ids, ring)]
        lines += [f"Line({a}) = {{{a}, {b}}};" for a, b in zip(ids, ids[1:] + ids[:1])]
        lines.append(f"Curve Loop({len(loops) + 1}) = {{{', '.join(map(str, ids))}}};")
        loops.append(len(loops) + 1)
        count += len(ring)
    lines.append(f"Plane Surface(1) = {{{', '.join(map(str, loops))}}};")
    return "\n".join(lines) + "\n"


def gmsh_mesh(folder, rings, length, algorithm):
    """Runs gmsh, and reads what it wrote."""
    source, file = Path(folder) / "plate.geo", Path(folder) / "plate.msh"
    source.write_text(geo(rings, length))
    subprocess.run(["gmsh", "-2", "-v", "1", "-algo", {1: "meshadapt", 5: "del2d", 6: "front2d"}[algorithm],
                    "-o", file, source], check=True, stdout=subprocess.DEVNULL)
    return pardel.read(file)


def main():
    plate = pardel.polygon(OUTLINE, WINDOW)
    with tempfile.TemporaryDirectory() as folder:
        for algorithm, name in ALGORITHMS.items():
            mesh = gmsh_mesh(folder, [OUTLINE, WINDOW], 0.1, algorithm)
            found = pardel.check(plate, mesh, min_angle=0)
            broken = ", ".join(f"{count} times {kind}" for kind, count in found.violation_counts.items()) or "nothing"
            print(f"{name:16s} {found.triangles} triangles, smallest angle {found.extremes['min_angle'].value:.1f} "
                  f"degrees; wrong: {broken}")
            for violation in found.violations[:1]:
                print(f"    {violation.kind} at {violation.coordinates[0]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
