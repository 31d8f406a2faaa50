"""Explains triangles that miss a bound by the gaps of the domain that `pardel doctor` names."""
import math


def read_rows(path):
    """The numbers of a file of Triangle's formats, line by line, without comments."""
    with open(path) as file:
        lines = (line.partition("#")[0].split() for line in file)
        return [[float(word) for word in words] for words in lines if words]


def read_domain(path):
    """The points and the segments, by id, of a .poly file that pardel wrote. A segment is a pair of ids."""
    rows = read_rows(path)
    count = int(rows[0][0])
    points = {int(row[0]): (row[1], row[2]) for row in rows[1:count + 1]}
    segments = rows[count + 2:count + 2 + int(rows[count + 1][0])]
    return points, {int(row[0]): (int(row[1]), int(row[2])) for row in segments}


def narrow_width(points):
    """The width of gaps that are too narrow for double precision. The mesher makes no edge shorter than 2^-42 of the
    largest coordinate. Around a gap of up to 1,000 such lengths not all bounds can hold."""
    return 2.0 ** -32 * max(abs(c) for p in points.values() for c in p)


def distance(p, a, b):
    """The distance of the point p from the segment a-b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square if square > 0 else 0.0
    t = min(max(t, 0.0), 1.0)
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def runs_along(domain, gap, centre, radius):
    """True if the place is between the segment of a gap and a segment that ends at the point of the gap."""
    points, segments = domain
    if gap["kind"] != "point_near_segment":
        return False

    def is_near(segment):
        return distance(centre, *(points[end] for end in segment)) <= radius

    return is_near(segments[gap["segment"]]) and any(is_near(s) for s in segments.values() if gap["points"][0] in s)


def width_at(domain, gap, place):
    """The width of the gap at a place. If the sides of the gap meet, they are a wedge, and it shrinks to the apex."""
    points, segments = domain
    if gap["kind"] != "point_near_segment":
        return gap["distance"]
    point = gap["points"][0]
    for apex in segments[gap["segment"]]:
        if any({point, apex} == set(s) for s in segments.values()):
            return gap["distance"] * math.dist(place, points[apex]) / math.dist(points[point], points[apex])
    return gap["distance"]


def explains(domain, gap, corners):
    """True if the gap is near the triangle with these corners, and too narrow there."""
    centre = tuple(sum(c) / 3 for c in zip(*corners))
    if width_at(domain, gap, centre) > narrow_width(domain[0]):
        return False
    longest = max(math.dist(a, b) for a in corners for b in corners)
    # "Near" includes some triangles in between, because a triangle that misses a bound spoils those around it.
    radius = 10 * (longest + gap["distance"])
    return math.dist(gap["where"], centre) <= radius or runs_along(domain, gap, centre, radius)
