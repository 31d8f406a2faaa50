"""A right mesher, and meshers with one mistake each."""

import numpy as np

import pardel


def right(points, segments, holes, min_angle):
    made = pardel.mesh(points, segments, holes=holes, min_angle=min_angle, threads=1)
    return made.points.copy(), made.triangles.astype(np.int64)


def drops_a_hole(points, segments, holes, min_angle):
    return right(points, segments, holes[1:], min_angle)


def ignores_a_segment(points, segments, holes, min_angle):
    try:
        return right(points, segments[:-1], holes, min_angle)
    except pardel.InvalidInput:  # it was a part of the boundary
        return right(points, segments, holes, min_angle)


def moves_a_point(points, segments, holes, min_angle):
    made, triangles = right(points, segments, holes, min_angle)
    made[len(points) - 1, 0] += 1e-12 * (1 + abs(made[len(points) - 1, 0]))
    return made, triangles


def flips_an_edge(points, segments, holes, min_angle):
    made = pardel.mesh(points, segments, holes=holes, min_angle=min_angle, threads=1)
    triangles, constrained = made.triangles.astype(np.int64), {frozenset(ends) for ends in made.segments.tolist()}
    for first, k in np.argwhere(made.neighbors >= 0):
        c, a, b = np.roll(triangles[first], -k)
        second = made.neighbors[first, k]
        (d,) = set(triangles[second].tolist()) - {a, b}
        left = [np.linalg.det([made.points[q] - made.points[c], made.points[r] - made.points[c]])
                for q, r in ((a, d), (d, b))]
        if min(left) > 1e-9 and frozenset((a, b)) not in constrained:
            triangles[first], triangles[second] = (c, a, d), (c, d, b)
            break
    return made.points, triangles


def leaves_a_gap(points, segments, holes, min_angle):
    made, triangles = right(points, segments, holes, min_angle)
    return made, triangles[1:] if len(triangles) > 5 else triangles


def turns_a_triangle(points, segments, holes, min_angle):
    made, triangles = right(points, segments, holes, min_angle)
    triangles[-1] = triangles[-1, ::-1]
    return made, triangles


def doubles_a_triangle(points, segments, holes, min_angle):
    made, triangles = right(points, segments, holes, min_angle)
    return made, np.vstack([triangles, np.roll(triangles[:1], 1, axis=1)])


def misses_the_angle(points, segments, holes, min_angle):
    return right(points, segments, holes, min_angle - 4)


def has_a_point_far_outside(points, segments, holes, min_angle):
    made, triangles = right(points, segments, holes, min_angle)
    low = made[:, 1].min()
    a, b, c = next((t[k], t[k - 2], t[k - 1]) for t in triangles for k in range(3) if made[t[k], 1] == low)
    return np.vstack([made, (made[a, 0], low - 1e6)]), np.vstack([triangles, (a, len(made), b)])


def crosses_triangles(points, segments, holes, min_angle):
    made, triangles = right(points, segments, holes, min_angle)
    if len(made) > len(points):
        made[-1] += 3 * (made[triangles[0]].mean(axis=0) - made[-1])
    return made, triangles
