"""How many steps from triangle to triangle it takes from one end of a domain to all others."""
import numpy as np

import pardel.compat.triangle as tr

A = tr.get_data("double_hex3")
mesh = tr.triangulate(A, "pqa0.002n")
neighbors = mesh["neighbors"]

steps = np.full(len(neighbors), -1)
steps[0], front = 0, [0]
while front:
    following = []
    for t in front:
        for other in neighbors[t]:
            if other != -1 and steps[other] < 0:
                steps[other] = steps[t] + 1
                following.append(other)
    front = following
boundary_sides = np.count_nonzero(neighbors == -1)
