"""Two closed curves, joined with np.vstack, and a place in the hole."""
import matplotlib.pyplot as plt
import numpy as np

import pardel.compat.triangle as tr


def circle(count, radius):
    i = np.arange(count)
    theta = i * 2 * np.pi / count
    points = np.stack([np.cos(theta), np.sin(theta)], axis=1) * radius
    return points, np.stack([i, i + 1], axis=1) % count


outer_points, outer = circle(30, 1.4)
inner_points, inner = circle(16, 0.6)
A = dict(vertices=np.vstack([outer_points, inner_points]), segments=np.vstack([outer, inner + outer.shape[0]]),
         holes=[[0, 0]])
B = tr.triangulate(A, "qpa0.05")
tr.compare(plt, A, B)
plt.show()
