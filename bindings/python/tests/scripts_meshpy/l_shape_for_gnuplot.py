"""An L, written for gnuplot: its triangles, and its facets."""
import pardel.compat.meshpy.triangle as triangle

info = triangle.MeshInfo()
info.set_points([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
info.set_facets([(i, (i + 1) % 6) for i in range(6)])
mesh = triangle.build(info, max_volume=0.1, verbose=False)
triangle.write_gnuplot_mesh("triangles.dat", mesh)
triangle.write_gnuplot_mesh("facets.dat", mesh, facets=True)
with open("triangles.dat") as file:
    blocks = file.read().strip().split("\n\n")
