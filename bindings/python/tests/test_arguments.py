"""Wrong arguments give messages that name them. Nothing is printed, and the process never ends."""

import numpy as np
import pytest

import pardel

POINTS = [(0, 0), (1, 0), (1, 1), (0, 1)]
SEGMENTS = [(0, 1), (1, 2), (2, 3), (3, 0)]

WRONG = {
    "points of one dimension": (dict(points=[0, 1, 2]), r"points has the shape \(3,\); \(n, 2\) is needed"),
    "points in space": (dict(points=[(0, 0, 0), (1, 0, 0), (0, 1, 0)]), r"points has the shape \(3, 3\)"),
    "points of text": (dict(points=[("a", "b")]), "points has the dtype <U1; real numbers are needed"),
    "complex points": (dict(points=np.zeros((3, 2), complex)), "points has the dtype complex128"),
    "points of objects": (dict(points=[(None, 1)]), "points has the dtype object"),
    "points in rows of different lengths": (dict(points=[(0, 0), (1,)]), "points is not an array"),
    "segments of three points": (dict(segments=[(0, 1, 2)]), r"segments has the shape \(1, 3\); \(n, 2\) is needed"),
    "a segment to a point beyond": (dict(segments=[(0, 4)]), r"segments\[0\] has the point 4; the points are 0 to 3"),
    "a segment to a negative point": (dict(segments=[(0, 1), (1, -1)]), r"segments\[1\] has the point -1"),
    "segments of fractions": (dict(segments=[(0, 0.5)]), "segments has numbers that are not integers"),
    "too few markers": (dict(markers=[1]), r"markers has the shape \(1,\); \(4,\) is needed, one marker per segment"),
    "a marker that is one too large": (dict(markers=[1, 2, 3, 2**31]), "markers has a number that is no 32-bit integer"),
    "a marker that is one too small": (dict(markers=[1, 2, 3, -2**31 - 1]),
                                       "markers has a number that is no 32-bit integer"),
    "a marker beyond 32 bits": (dict(markers=[1, 2, 3, 2**40]), "markers has a number that is no 32-bit integer"),
    "too many point markers": (dict(point_markers=[1] * 5), "point_markers has the shape"),
    "attributes of one dimension": (dict(attributes=[1, 2, 3, 4]), r"attributes has the shape \(4,\); \(4, k\)"),
    "too few attributes": (dict(attributes=[(1,), (2,)]), "attributes has 2 rows; 4 are needed"),
    "holes of one dimension": (dict(holes=[0.5, 0.5]), r"holes has the shape \(2,\)"),
    "regions of different lengths": (dict(regions=[(0, 0), (1, 0, 0)]), "regions is not an array"),
    "regions of five columns": (dict(regions=[(0, 0, 0, 0, 0)]), r"regions has the shape \(1, 5\)"),
    "a negative angle": (dict(min_angle=-1), "the minimum angle must lie between 0 and 33 degrees, not -1"),
    "an angle above 33 degrees": (dict(min_angle=40), "40"),
    "an angle of text": (dict(min_angle="wide"), "min_angle is 'wide'; a number is needed"),
    "no area": (dict(max_area=0), "area"),
    "an area that is not a number": (dict(max_area=float("nan")), "area"),
    "a negative edge": (dict(max_edge=-1), "edge"),
    "a size of zero": (dict(size=0), "size is 0.0; a number greater than 0 is needed"),
    "too few sizes": (dict(size=[1, 2]), r"size has the shape \(2,\); \(4,\) is needed, one number per point"),
    "a negative size": (dict(size=[1, 1, -1, 1]), r"size\[2\] is -1.0"),
    "a size of text": (dict(size="small"), "size is 'small'; a number, .* or the path of a file with lengths is needed"),
    "a size on no mesh": (dict(size=(3.5 + 1j, [1])), "a mesh is needed"),
    "a gradation of zero": (dict(grading=0), "grad"),
    "too large a feature size": (dict(feature_size=1e9), "the edges across narrow places must lie between 0 and 1e6"),
    "negative threads": (dict(threads=-1), "threads is -1; an integer from 0"),
    "threads of text": (dict(threads="all"), "threads is 'all'"),
    "a fraction of vertices": (dict(max_vertices=1.5), "max_vertices is 1.5"),
    "an unknown placement": (dict(placement="best"), "placement is 'best'; it must be one of circumcentre, off_centre"),
    "an unknown interior": (dict(interior="empty"), "interior is 'empty'; it must be one of refine, fill, automatic"),
    "a negative snapping distance": (dict(snap=-1), "snap"),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_argument_is_named(what, capfd):
    arguments, message = WRONG[what]
    with pytest.raises(pardel.UsageError, match=message) as caught:
        pardel.mesh(**{"points": POINTS, "segments": SEGMENTS, **arguments})
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, pardel.Error)
    assert "::" not in str(caught.value)
    assert capfd.readouterr() == ("", "")


INVALID = {
    "a coordinate that is not a number": ([(0, 0), (1, np.nan), (1, 1)], None, "non_finite_coordinate", (1,)),
    "an infinite coordinate": ([(0, 0), (1, 0), (1, np.inf)], None, "non_finite_coordinate", (2,)),
    "a huge coordinate": ([(0, 0), (1, 0), (1, 1e300)], None, "coordinate_out_of_range", (2,)),
    "equal points": ([(0, 0), (1, 0), (0, 0), (0, 1)], None, "duplicate_points", (0, 2)),
    "a segment from a point to itself": (POINTS, [*SEGMENTS, (2, 2)], "zero_length_segment", (4,)),
    "the same segment twice": (POINTS, [*SEGMENTS, (1, 0)], "duplicate_segments", (0, 4)),
    "an open outline": (POINTS, SEGMENTS[:3], "unclosed_outline", None),
    "points on one line": ([(0, 0), (1, 1), (2, 2)], None, "all_points_collinear", None),
    "no points": ([], None, "all_points_collinear", None),
    "a point on a segment": ([*POINTS, (0.5, 0)], SEGMENTS, "point_on_segment", (4, 0)),
}


@pytest.mark.parametrize("what", INVALID)
def test_an_invalid_domain_is_refused_with_kind_and_ids(what, capfd):
    points, segments, kind, ids = INVALID[what]
    with pytest.raises(pardel.InvalidInput) as caught:
        pardel.mesh(points, segments)
    first = caught.value.problems[0]
    assert first.kind == kind and (ids is None or first.ids == ids)
    assert first.text in [each.text for each in pardel.validate(points, segments)]
    assert str(first) == first.text and first.text.endswith(".")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("dtype", ["f4", "f8", "i4", "u1", ">f8", "f2"])
@pytest.mark.parametrize("layout", ["rows", "columns", "part", "reversed"])
def test_points_may_have_any_real_dtype_and_layout(dtype, layout):
    points = np.array(POINTS, dtype)
    if layout == "columns":
        points = np.asfortranarray(points)
    elif layout == "part":
        points = np.concatenate([points, points], axis=1)[:, 1:3][:, ::-1]
    elif layout == "reversed":
        points = points[::-1].copy()[::-1]
    assert np.array_equal(pardel.Domain(points, SEGMENTS).points, POINTS)


@pytest.mark.parametrize("dtype", ["i1", "i4", "u4", "i8", "u8", "f8"])
def test_segments_may_have_any_dtype_of_whole_numbers(dtype):
    assert pardel.Domain(POINTS, np.array(SEGMENTS, dtype)).segments.tolist() == [list(each) for each in SEGMENTS]


def test_markers_may_be_a_column_as_wrappers_of_triangle_have_them():
    assert pardel.Domain(POINTS, SEGMENTS, markers=[[1], [2], [3], [4]]).markers.tolist() == [1, 2, 3, 4]


def test_parts_of_a_domain_cannot_be_given_beside_a_domain(square):
    with pytest.raises(pardel.UsageError, match="holes cannot be given beside a domain"):
        pardel.mesh(square, holes=[(0.5, 0.5)])


def test_a_domain_has_no_default_markers():
    domain = pardel.Domain(POINTS, SEGMENTS)
    assert domain.markers is None and domain.point_markers is None


def test_regions_may_leave_out_attribute_and_area():
    rows = pardel.Domain(POINTS, SEGMENTS, regions=[(0.5, 0.5)]).regions
    assert rows.tolist() == [[0.5, 0.5, 0, np.inf]]


def test_equal_domains_are_equal(square):
    assert square == pardel.Domain(square.points, square.segments, markers=square.markers)
    assert square != pardel.Domain(square.points, square.segments) and square != 3


def test_a_domain_can_be_pickled(plate):
    import pickle

    assert pickle.loads(pickle.dumps(plate)) == plate


def test_a_polygon_may_be_closed_by_its_first_corner():
    assert pardel.polygon([(0, 0), (1, 0), (0, 1), (0, 0)]) == pardel.polygon([(0, 0), (1, 0), (0, 1)])


def test_a_polygon_of_two_corners_is_refused():
    with pytest.raises(pardel.UsageError, match="a polygon has 2 corners; at least 3 are needed"):
        pardel.polygon([(0, 0), (1, 0)])


def test_a_hole_of_any_shape_is_cut_out():
    cross = [(1, 1), (2, 1.9), (3, 1), (2.1, 2), (3, 3), (2, 2.1), (1, 3), (1.9, 2)]
    domain = pardel.polygon([(0, 0), (4, 0), (4, 4), (0, 4)], cross)
    x, y = np.array(cross).T
    area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    assert pardel.delaunay(domain).area() == pytest.approx(16 - area)


def test_a_valid_domain_has_no_problems(plate):
    assert pardel.validate(plate) == ()


def test_an_open_outline_is_no_problem_of_a_convex_hull():
    assert pardel.validate(POINTS, SEGMENTS[:3], convex_hull=True) == ()
    assert pardel.mesh(POINTS, SEGMENTS[:3], convex_hull=True).area() == pytest.approx(1)


def test_repair_says_what_it_changed(crossing):
    repaired = pardel.repair(crossing)
    assert pardel.validate(repaired.domain) == () and repaired.log
    assert repaired.point_map.tolist() == [0, 1, 2, 3]
    assert set(repaired.segment_map.tolist()) == {0, 1, 2, 3}


def test_repair_changes_nothing_of_a_valid_domain(plate):
    repaired = pardel.repair(plate)
    assert repaired.domain == plate and repaired.log == ()


def test_repair_of_nothing_is_refused():
    with pytest.raises(pardel.InvalidInput):
        pardel.repair([(0, 0), (np.nan, 0), (0, 1)])


MISTAKES = {
    "the mesh before the path": (lambda mesh: pardel.write(mesh, "plate.vtu"), "path is a Mesh; the path of a file"),
    "the mesh before the path of a picture": (lambda mesh: pardel.draw(mesh, "plate.svg"), "path is a Mesh"),
    "a number for a path": (lambda mesh: pardel.read(3), "path is a int; the path of a file is needed"),
    "the mesh before the domain": (lambda mesh: pardel.check(mesh, mesh.domain), "this is a Mesh; a domain is needed"),
    "a mesh for a domain": (lambda mesh: pardel.mesh(mesh), "this is a Mesh; a domain is needed"),
    "a dict for points": (lambda mesh: pardel.mesh({"vertices": POINTS}), "points is a dict; an array"),
    "inner polygons in a list": (lambda mesh: pardel.polygon(POINTS, [POINTS]), "each one is an argument"),
    "the path of a file for a geometry": (lambda mesh: pardel.geometry("a.geojson"), "pardel.read reads the domain"),
    "a colour for the axes": (lambda mesh: mesh.plot("quality"), "ax is a str; axes of matplotlib are needed"),
    "a domain in a format of meshes": (lambda mesh: pardel.write("plate.vtu", mesh.domain), "'.vtu' is not a format"),
    "a domain as GeoJSON": (lambda mesh: pardel.write("plate.geojson", mesh.domain), "these are .poly and .svg"),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_frequent_mistake_gets_a_message_that_says_what_is_needed(mistake, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    act, message = MISTAKES[mistake]
    with pytest.raises(pardel.UsageError, match=message):
        act(pardel.mesh(POINTS, SEGMENTS))
    assert not list(tmp_path.iterdir())
