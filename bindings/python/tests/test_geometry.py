"""pardel.geometry: shapes of shapely, of GeoJSON and of other programs as domains."""

import collections
import json
import tempfile

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel

shapely = pytest.importorskip("shapely.geometry")
ops = pytest.importorskip("shapely.ops")

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)]
WINDOW = [(1, 1), (1, 3), (3, 3), (3, 1), (1, 1)]
FRAME = {"type": "Polygon", "coordinates": [SQUARE, WINDOW]}


def feature(geometry, **properties):
    return {"type": "Feature", "geometry": geometry, "properties": properties}


def area(shapes, **options):
    return pardel.mesh(pardel.geometry(shapes, **options), min_angle=0, repair=True).area()


@st.composite
def boxes(draw):
    """Up to five boxes on a lattice, which may touch and overlap, each perhaps with a hole."""
    found = []
    for _ in range(draw(st.integers(1, 5))):
        x, y, width, height = (draw(st.integers(0, 8)), draw(st.integers(0, 8)), draw(st.integers(1, 6)),
                               draw(st.integers(1, 6)))
        box = shapely.box(x, y, x + width, y + height)
        if width > 2 and height > 2 and draw(st.booleans()):
            box = box.difference(shapely.box(x + 1, y + 1, x + width - 1, y + height - 1))
        found.append(box)
    return found


@given(boxes())
def test_the_mesh_of_polygons_covers_their_union_and_nothing_else(polygons):
    assert area(polygons) == pytest.approx(ops.unary_union(polygons).area)


@given(boxes())
def test_holes_and_regions_are_placed_strictly_inside(polygons):
    domain = pardel.geometry(polygons, attribute=[1] * len(polygons))
    union = ops.unary_union(polygons)
    assert all(not union.intersects(shapely.Point(place)) for place in domain.holes)
    assert all(union.contains(shapely.Point(place)) for place in domain.regions[:, :2])
    assert not any(each.exterior.intersects(shapely.Point(place)) for each in polygons
                   for place in domain.regions[:, :2])


@given(boxes(), st.data())
def test_a_geometry_is_the_same_domain_as_its_file(polygons, data):
    numbers = st.one_of(st.none(), st.integers(1, 9))
    features = [feature(shapely.mapping(each), attribute=data.draw(numbers), max_area=data.draw(numbers),
                        marker=data.draw(numbers), hole=data.draw(st.sampled_from([None, False, False, True])))
                for each in polygons]
    collection = {"type": "FeatureCollection", "features": features}
    assert written_and_read(collection) == pardel.geometry(collection)
    listed = pardel.geometry(polygons, **{name: [each["properties"][name] for each in features]
                                          for name in ("attribute", "max_area", "marker", "hole")})
    assert listed == pardel.geometry(collection)


def written_and_read(collection):
    with tempfile.NamedTemporaryFile("w", suffix=".geojson") as file:
        json.dump(collection, file)
        file.flush()
        return pardel.read(file.name)


@given(st.lists(st.integers(1, 3), min_size=9, max_size=9))
def test_cells_of_a_map_keep_their_attributes_and_share_their_borders(attributes):
    cells = [shapely.box(x, y, x + 1, y + 1) for x in range(3) for y in range(3)]
    domain = pardel.geometry(cells, attribute=attributes)
    assert (len(domain.points), len(domain.segments), len(domain.regions)) == (16, 24, 9)
    mesh = pardel.mesh(domain, min_angle=0)
    corners = mesh.points[mesh.triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2
    for attribute in set(attributes):
        of_attribute = mesh.region_attributes[mesh.regions] == attribute
        assert areas[of_attribute].sum() == pytest.approx(attributes.count(attribute))


def test_neighbours_with_other_corners_on_the_border_are_mended_if_asked():
    neighbours = [shapely.box(0, 0, 2, 2), shapely.box(2, 0, 4, 1), shapely.box(2, 1, 4, 2)]
    with pytest.raises(pardel.InvalidInput):
        pardel.mesh(neighbours)
    mesh = pardel.mesh(neighbours, repair=True)
    assert mesh.area() == pytest.approx(8) and len(mesh.domain.holes) == 0


def test_a_line_in_a_polygon_is_a_crack():
    crack = shapely.LineString([(1, 1), (2, 3)])
    mesh = pardel.mesh(shapely.GeometryCollection([shapely.box(0, 0, 4, 4), crack]), max_area=0.5)
    on_crack = [k for k in mesh.segments if all(crack.distance(shapely.Point(mesh.points[p])) < 1e-9 for p in k)]
    assert sum(np.hypot(*(mesh.points[a] - mesh.points[b])) for a, b in on_crack) == pytest.approx(crack.length)


@pytest.mark.parametrize("shape, points, segments", [
    (lambda: shapely.MultiPoint([(0, 0), (1, 0), (0, 1), (0, 0)]), 3, 0),
    (lambda: shapely.Point(3, 4), 1, 0),
    (lambda: shapely.LinearRing([(0, 0), (1, 0), (0, 1)]), 3, 3),
    (lambda: shapely.MultiLineString([[(0, 0), (1, 0)], [(1, 0), (0, 0)]]), 2, 1),
    (lambda: shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(1, 0, 2, 1)]), 6, 7),
    (lambda: shapely.Polygon([(0, 0, 5), (1, 0, 6), (0, 1, 7)]), 3, 3),
    (lambda: shapely.GeometryCollection(), 0, 0),
    (lambda: shapely.Polygon(), 0, 0),
    (lambda: shapely.GeometryCollection([shapely.GeometryCollection([shapely.Point(1, 1)])]), 1, 0),
])
def test_each_kind_of_geometry_is_read(shape, points, segments):
    domain = pardel.geometry(shape())
    assert (len(domain.points), len(domain.segments)) == (points, segments)


def test_some_positions_may_have_heights():
    line = {"type": "LineString", "coordinates": [(0, 0), (1, 0, 9), np.array([1, 1])]}
    assert pardel.geometry(line).points.tolist() == [[0, 0], [1, 0], [1, 1]]


def test_coordinates_may_be_an_array():
    ring = np.array(SQUARE, dtype=np.float32)
    assert pardel.geometry({"type": "Polygon", "coordinates": [ring]}) == pardel.geometry(shapely.Polygon(SQUARE))


def test_zeros_of_both_signs_are_one_point():
    assert len(pardel.geometry({"type": "MultiPoint", "coordinates": [(0.0, -0.0), (-0.0, 0.0)]}).points) == 1


class Frame:
    """What a GeoDataFrame shows of itself."""

    def __init__(self, features, is_geographic=False):
        self.features = features
        self.crs = type("CRS", (), {"is_geographic": is_geographic, "__str__": lambda self: "EPSG:4326"})()

    @property
    def __geo_interface__(self):
        return {"type": "FeatureCollection", "features": self.features}


def test_a_frame_names_the_columns_of_attributes_and_areas():
    frame = Frame([feature(shapely.mapping(shapely.box(0, 0, 1, 1)), soil=7, finest=0.01),
                   feature(shapely.mapping(shapely.box(1, 0, 2, 1)), soil=8, finest=None)])
    domain = pardel.geometry(frame, attribute="soil", max_area="finest")
    assert sorted(domain.regions[:, 2:].tolist()) == [[7.0, 0.01], [8.0, np.inf]]


def test_rows_of_a_frame_are_shapes():
    Row = collections.namedtuple("Row", "Index geometry soil")
    rows = [Row(0, shapely.box(0, 0, 1, 1), 7), Row(1, shapely.box(1, 0, 2, 1), 8)]
    assert sorted(pardel.geometry(rows, attribute="soil").regions[:, 2]) == [7, 8]
    assert pardel.mesh(rows[0]).area() == pytest.approx(1)


def test_degrees_are_refused_unless_the_frame_hides_them():
    frame = Frame([feature(FRAME)], is_geographic=True)
    with pytest.raises(pardel.UsageError, match="EPSG:4326: its coordinates are degrees"):
        pardel.mesh(frame)
    assert pardel.mesh(frame.__geo_interface__).area() == pytest.approx(12)


@pytest.mark.parametrize("shapes", [FRAME, shapely.shape(FRAME), [FRAME], (shapely.shape(FRAME),), feature(FRAME),
                                    np.array([shapely.shape(FRAME), None], dtype=object)[:1]])
def test_every_function_that_takes_a_domain_takes_shapes(shapes, tmp_path):
    mesh = pardel.mesh(shapes, max_area=0.5)
    assert pardel.check(shapes, mesh, max_area=0.5).valid
    assert not pardel.validate(shapes)
    assert pardel.repair(shapes).domain == pardel.geometry(shapes)
    assert pardel.delaunay(shapes).area() == pytest.approx(12)


def test_parts_of_a_domain_beside_shapes_are_a_usage_error():
    with pytest.raises(pardel.UsageError, match="holes cannot be given beside a domain"):
        pardel.mesh(FRAME, holes=[(2, 2)])


def test_a_file_of_geojson_is_read_and_meshed_by_its_path(tmp_path):
    file = tmp_path / "frame.geojson"
    file.write_text(json.dumps(feature(FRAME, attribute=3)))
    assert pardel.read(file) == pardel.geometry(FRAME, attribute=3)
    assert pardel.mesh(str(file)).area() == pytest.approx(12)


def test_a_wrong_place_in_a_file_is_named(tmp_path):
    file = tmp_path / "wrong.json"
    file.write_text('{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1]]]}')
    with pytest.raises(pardel.InvalidInput, match=r"wrong.json: coordinates\[0\]\[3\]: expected the first position"):
        pardel.read(file)
    file.write_text('{"type": "Polygon",\n,')
    with pytest.raises(pardel.InvalidInput, match="wrong.json:2:1"):
        pardel.read(file)


def test_polygons_that_are_apart_leave_a_gap():
    assert area([shapely.box(0, 0, 1, 1), shapely.box(2, 0, 3, 1)]) == pytest.approx(2)


def closed(ring):
    return [*ring, ring[0]]


rings = st.lists(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=3, max_size=6, unique=True).filter(
    lambda ring: shapely.Polygon(ring).is_valid)


@given(rings, rings)
def test_a_hole_that_does_not_lie_in_its_outline_is_named_and_others_are_meshed_or_cross_it(outline, hole):
    inside, around = shapely.Polygon(hole), shapely.Polygon(outline)
    shapes = {"type": "MultiPolygon", "coordinates": [[closed([(8, 8), (9, 8), (9, 9)])],
                                                      [closed(outline), closed(hole)]]}
    if around.contains_properly(inside) if hasattr(around, "contains_properly") else \
            around.contains(inside) and not around.boundary.intersects(inside.boundary):
        assert pardel.mesh(shapes).area() == pytest.approx(0.5 + around.area - inside.area)
    elif not around.intersects(inside) or inside.contains(around) and not inside.boundary.intersects(around.boundary):
        with pytest.raises(pardel.InvalidInput, match=r"^geometry 0\.coordinates\[1\]\[1\] is a hole that does not lie "
                                                      r"inside the outline of its polygon, "
                                                      r"geometry 0\.coordinates\[1\]\[0\]$"):
            pardel.mesh([shapes], repair=True)
        with pytest.raises(pardel.InvalidInput, match="inner polygon 0 does not lie inside the outline"):
            pardel.polygon(outline, hole)
    elif any(around.contains(shapely.Point(corner)) for corner in hole):
        pardel.geometry(shapes)  # it crosses the outline, or touches it: for the validation


def test_a_hole_outside_its_outline_in_a_file_is_named(tmp_path):
    file = tmp_path / "islands.geojson"
    far = [(x + 9, y) for x, y in WINDOW]
    file.write_text(json.dumps(feature({"type": "Polygon", "coordinates": [SQUARE, WINDOW, far]})))
    with pytest.raises(pardel.InvalidInput, match=r"islands.geojson: geometry.coordinates\[2\]: expected a hole inside "
                                                  "the first ring of the polygon, found a ring outside it"):
        pardel.read(file)


def test_a_hole_may_touch_its_outline_in_corners():
    outline = [(0, 0), (3, 0), (3, 1), (3, 3), (1, 3), (0, 3), (0, 2)]
    hole = [(3, 1), (1, 3), (0, 2)]  # all corners are on the outline, which has points there
    mesh = pardel.mesh({"type": "Polygon", "coordinates": [closed(outline), closed(hole)]}, min_angle=0)
    assert mesh.area() == pytest.approx(shapely.Polygon(outline).area - shapely.Polygon(hole).area)
