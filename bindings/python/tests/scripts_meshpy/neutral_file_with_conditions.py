"""A channel in a Gambit neutral file, with conditions at its ends."""
import pardel.compat.meshpy.triangle as triangle

INFLOW, WALL, OUTFLOW = 1, 2, 3
info = triangle.MeshInfo()
info.set_points([(0, 0), (5, 0), (5, 1), (0, 1)])
info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)], [WALL, OUTFLOW, WALL, INFLOW])
mesh = triangle.build(info, max_volume=0.05, generate_faces=True)
with open("channel.neu", "w") as file:
    mesh.write_neu(file, bc={INFLOW: ("inflow", 6), OUTFLOW: ("outflow", 7), WALL: ("wall", 24)})
with open("channel.neu") as file:
    lines = file.read().splitlines()
