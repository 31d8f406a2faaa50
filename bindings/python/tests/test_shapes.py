"""Wrong shapes, and wrong keywords of pardel.geometry, give messages that name the place."""

import pytest

import pardel

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)]
WINDOW = [(1, 1), (1, 3), (3, 3), (3, 1), (1, 1)]
FRAME = {"type": "Polygon", "coordinates": [SQUARE, WINDOW]}
BOX = {"type": "Polygon", "coordinates": [[(4, 0), (5, 0), (5, 1), (4, 1), (4, 0)]]}


def feature(geometry, **properties):
    return {"type": "Feature", "geometry": geometry, "properties": properties}


WRONG = {
    "a number": (3, "a geometry is needed"),
    "no shape in a list": ([FRAME, 3], "geometry 1 is a int"),
    "an unknown type": ({"type": "Circle"}, "the geometry has the type 'Circle'"),
    "no coordinates": ({"type": "Point"}, "the geometry.coordinates is a NoneType; a list is needed"),
    "text": ({"type": "Point", "coordinates": "here"}, "the geometry.coordinates is a str"),
    "one number": ({"type": "Point", "coordinates": [1]}, "the geometry.coordinates is not a position"),
    "numbers as text": ({"type": "Point", "coordinates": ["1", "2"]}, "coordinates is not a position"),
    "a short line": ({"type": "LineString", "coordinates": [(0, 0)]}, "a line needs two"),
    "an open ring": ({"type": "Polygon", "coordinates": [SQUARE[:-1]]}, r"coordinates\[0\] is no ring"),
    "a flat polygon": ({"type": "Polygon", "coordinates": SQUARE}, r"coordinates\[0\] is not a ring"),
    "a polygon of numbers": ({"type": "Polygon", "coordinates": [1, 2]}, r"coordinates\[0\] is a int"),
    "a ring of a multipolygon": ({"type": "MultiPolygon", "coordinates": [[SQUARE], [WINDOW[:3]]]},
                                 r"coordinates\[1\]\[0\] is no ring"),
    "not finite": ([FRAME, {"type": "LineString", "coordinates": [(0, 0), (0, float("nan"))]}],
                   r"geometry 1.coordinates\[1\] has a coordinate that is not finite"),
    "features of nothing": ({"type": "FeatureCollection"}, "the geometry.features is a NoneType"),
    "wrong properties": ({"type": "Feature", "geometry": FRAME, "properties": [1]}, "properties is a list"),
    "an attribute of text": (feature(FRAME, attribute="clay"), "the property 'attribute' is 'clay'; a number"),
    "an area of zero": (feature(FRAME, max_area=0), "max_area of the geometry.geometry is 0.0"),
    "a marker of a half": (feature(FRAME, marker=0.5), "marker has the number 0.5"),
    "too many collections": (None, "more than 16 collections"),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_shape_is_named_with_its_place(what):
    shapes, message = WRONG[what]
    if shapes is None:
        shapes = FRAME
        for _ in range(20):
            shapes = {"type": "GeometryCollection", "geometries": [shapes]}
    with pytest.raises(pardel.UsageError, match=message):
        pardel.geometry(shapes)


@pytest.mark.parametrize("options, message", [
    (dict(attribute="soil"), "attribute is 'soil', and no feature has this property; there are sand"),
    (dict(attribute=[1]), r"attribute has the shape \(1,\); \(2,\) is needed, one number per geometry"),
    (dict(attribute=["clay", "sand"]), "the name of a property, a number, or a list of numbers is needed"),
    (dict(max_area=-1), "max_area of geometry 0.geometry is -1.0"),
    (dict(marker=[1, 2.5]), "marker has the number 2.5, which is no 32-bit integer"),
    (dict(marker=2**40), "no 32-bit integer"),
])
def test_a_wrong_keyword_is_named(options, message):
    features = [feature(FRAME, sand=1), feature(BOX)]
    with pytest.raises(pardel.UsageError, match=message):
        pardel.geometry(features, **options)
