"""The convex hull as segments, and a mesh of what is inside it."""
import matplotlib.pyplot as plt

import pardel.compat.triangle as tr

dots = tr.get_data("dots")
points = dots["vertices"]
segments = tr.convex_hull(points)

tr.plot(plt.axes(), vertices=points, segments=segments)
plt.show()
mesh = tr.triangulate(dict(vertices=points, segments=segments), "pqa0.02")
by_switch = tr.triangulate(dots, "c")
