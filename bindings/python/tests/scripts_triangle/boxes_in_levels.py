"""The classic example: a box, its triangulation, and three refinements of it."""
import pardel.compat.triangle as tr

box = tr.get_data("box")
levels = [tr.triangulate(box, opts="pc")]
for area in (0.2, 0.05, 0.0125):
    levels.append(tr.triangulate(levels[-1], opts=f"rpa{area}"))
sizes = [(len(level["vertices"]), len(level["triangles"])) for level in levels]
stored = tr.get_data("box.4")
assert stored["triangles"].shape == levels[-1]["triangles"].shape
