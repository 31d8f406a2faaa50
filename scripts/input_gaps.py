"""Finds narrow gaps of a domain: the places where double precision has no room for a mesh of good quality."""
import math


def read_rows(path):
    """The numbers of a file of Triangle's formats, line by line, without comments."""
    with open(path) as file:
        lines = (line.partition("#")[0].split() for line in file)
        return [[float(word) for word in words] for words in lines if words]


def read_domain(path):
    """The points, by id, and the segments, as pairs of ids, of a .poly file that pardel wrote."""
    rows = read_rows(path)
    count = int(rows[0][0])
    points = {int(row[0]): (row[1], row[2]) for row in rows[1:count + 1]}
    segments = rows[count + 2:count + 2 + int(rows[count + 1][0])]
    return points, [(int(row[1]), int(row[2])) for row in segments]


def distance(p, a, b):
    """The distance of the point p from the segment a-b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square if square > 0 else 0.0
    t = min(max(t, 0.0), 1.0)
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def smallest_gap(domain, centre, radius):
    """The smallest distance between two input points, or between a point and a segment that does not end there, if both
    are at most `radius` away from the centre."""
    points, segments = domain
    near = [(v, p) for v, p in points.items() if math.dist(p, centre) <= radius]
    sides = [s for s in segments if distance(centre, points[s[0]], points[s[1]]) <= radius]
    gaps = [math.dist(p, q) for i, (_, p) in enumerate(near) for _, q in near[:i]]
    gaps += [distance(p, points[a], points[b]) for v, p in near for a, b in sides if v not in (a, b)]
    return min(gaps, default=math.inf)


def explains(domain, corners):
    """True if the input has a gap near the triangle that is too narrow for double precision. The mesher makes no edge
    shorter than 2^-42 of the largest coordinate. Around a gap of up to 1,000 such lengths not all bounds can hold."""
    narrow = 2.0 ** -32 * max(abs(c) for p in domain[0].values() for c in p)
    centre = tuple(sum(c) / 3 for c in zip(*corners))
    longest = max(math.dist(a, b) for a in corners for b in corners)
    # "Near" includes some triangles in between, because a triangle that misses a bound spoils those around it.
    return smallest_gap(domain, centre, 10 * (longest + narrow)) <= narrow
