"""Explains triangles that miss a bound by the gaps of the domain that `pardel doctor` names."""
import math


def read_rows(path):
    """The numbers of a file of Triangle's formats, line by line, without comments."""
    with open(path) as file:
        lines = (line.partition("#")[0].split() for line in file)
        return [[float(word) for word in words] for words in lines if words]


def read_points(path):
    """The points of a .poly file that pardel wrote."""
    rows = read_rows(path)
    return [(row[1], row[2]) for row in rows[1:int(rows[0][0]) + 1]]


def narrow_gaps(gaps, points):
    """The gaps that are too narrow for double precision. The mesher makes no edge shorter than 2^-42 of the largest
    coordinate. Around a gap of up to 1,000 such lengths not all bounds can hold."""
    narrow = 2.0 ** -32 * max(abs(c) for p in points for c in p)
    return [gap for gap in gaps if gap["distance"] <= narrow]


def explains(gaps, corners):
    """True if one of the gaps is near the triangle with these corners."""
    centre = tuple(sum(c) / 3 for c in zip(*corners))
    longest = max(math.dist(a, b) for a in corners for b in corners)
    # "Near" includes some triangles in between, because a triangle that misses a bound spoils those around it.
    return any(math.dist(gap["where"], centre) <= 10 * (longest + gap["distance"]) for gap in gaps)
