"""Places from which edge lengths grow."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel

UNIT = pardel.polygon([(0, 0), (1, 0), (1, 1), (0, 1)])


@given(st.lists(st.tuples(st.floats(0, 1), st.floats(0, 1), st.floats(0.01, 0.2)), min_size=1, max_size=4),
       st.floats(0.1, 0.5))
def test_lengths_grow_from_points_by_the_grading(points, grading):
    mesh = pardel.mesh(UNIT, sources=points, grading=grading)
    assert pardel.check(UNIT, mesh, sources=points, grading=grading).valid
    corners = mesh.points[mesh.triangles]
    longest = np.hypot(*np.moveaxis(np.roll(corners, -1, axis=1) - corners, 2, 0)).max(axis=1)
    middle = corners.mean(axis=1)
    for x, y, length in points:
        wanted = length + grading * np.hypot(middle[:, 0] - x, middle[:, 1] - y)
        assert (longest <= wanted * (1 + 1e-9)).all()


def test_a_mesh_that_is_too_coarse_at_a_source_is_found():
    coarse = pardel.mesh(UNIT, grading=0.2)
    assert pardel.check(UNIT, coarse, grading=0.2)
    assert not pardel.check(UNIT, coarse, sources=[(0.5, 0.5, 0.01)], grading=0.2)


def finest_at(mesh):
    """The middle of the triangle with the shortest longest edge."""
    corners = mesh.points[mesh.triangles]
    longest = np.hypot(*np.moveaxis(np.roll(corners, -1, axis=1) - corners, 2, 0)).max(axis=1)
    return corners[np.argmin(longest)].mean(axis=0)


def test_lengths_hold_on_segments_with_a_marker(square):
    mesh = pardel.mesh(square, sources={2: 0.01}, grading=0.3)
    assert finest_at(mesh)[0] > 0.95
    assert pardel.mesh(square, sources=pardel.Sources(markers={2: 0.01}), grading=0.3).digest == mesh.digest


def test_one_length_of_a_line_holds_at_both_ends():
    meshes = [pardel.mesh(UNIT, sources=pardel.Sources(lines=[line]), grading=0.3).digest
              for line in ((0.2, 0.5, 0.8, 0.6, 0.05), (0.2, 0.5, 0.8, 0.6, 0.05, 0.05))]
    assert meshes[0] == meshes[1]


def test_lengths_hold_along_lines():
    mesh = pardel.mesh(UNIT, sources=pardel.Sources(lines=[(0.2, 0.5, 0.8, 0.5, 0.01)]), grading=0.3)
    assert abs(finest_at(mesh)[1] - 0.5) < 0.05
    both = pardel.mesh(UNIT, sources=pardel.Sources(lines=[(0.2, 0.5, 0.8, 0.5, 0.01, 0.2)]), grading=0.5)
    assert np.hypot(*(finest_at(both) - (0.2, 0.5))) < 0.05 and len(both.triangles) < len(mesh.triangles)


def test_lengths_hold_in_regions():
    domain = pardel.generate("regions")
    mesh = pardel.mesh(domain, sources=pardel.Sources(regions={20: 0.02}), grading=0.3)
    assert pardel.check(domain, mesh, sources=pardel.Sources(regions={20: 0.02}), grading=0.3).valid
    of_region = mesh.region_attributes[mesh.regions] == 20
    corners = mesh.points[mesh.triangles[of_region]]
    assert np.hypot(*np.moveaxis(np.roll(corners, -1, axis=1) - corners, 2, 0)).max() <= 0.02


def test_sources_are_read_from_a_file(tmp_path, square):
    (tmp_path / "shore.sources").write_text("point 0.5 0.5 0.02\nmarker 2 0.05\n")
    by_path = pardel.mesh(square, sources=tmp_path / "shore.sources", grading=0.3)
    given = pardel.Sources(points=[(0.5, 0.5, 0.02)], markers={2: 0.05})
    assert by_path.digest == pardel.mesh(square, sources=given, grading=0.3).digest


def test_shapes_with_a_length_are_sources(tmp_path):
    pond = {"type": "Feature", "properties": {"length": 0.02},
            "geometry": {"type": "Polygon", "coordinates": [[(.4, .4), (.6, .4), (.6, .6), (.4, .6), (.4, .4)]]}}
    other = {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": (0, 0)}}
    file = tmp_path / "pond.geojson"
    file.write_text(json.dumps({"type": "FeatureCollection", "features": [pond, other]}))
    mesh = pardel.mesh(UNIT, sources=[pond, other], grading=0.3)
    assert mesh.digest == pardel.mesh(UNIT, sources=file, grading=0.3).digest
    assert mesh.digest == pardel.mesh(UNIT, sources=pardel.Sources.of(pond["geometry"], 0.02), grading=0.3).digest
    corners = mesh.points[mesh.triangles]
    middle = corners.mean(axis=1)
    inside = (np.abs(middle - 0.5) < 0.1).all(axis=1)
    longest = np.hypot(*np.moveaxis(np.roll(corners, -1, axis=1) - corners, 2, 0)).max(axis=1)
    assert inside.sum() > 100 and longest[inside].max() <= 0.02
    assert pardel.check(UNIT, mesh, sources=file, grading=0.3).valid


def test_shapes_whose_sides_cross_are_mended():
    crossing = [{"type": "Polygon", "coordinates": [[(x, .1), (x + .4, .1), (x + .4, .5), (x, .5), (x, .1)]]}
                for x in (0.1, 0.3)]
    sources = pardel.Sources.of(crossing, [0.05, 0.02])
    assert pardel.check(UNIT, pardel.mesh(UNIT, sources=sources, grading=0.3), sources=sources, grading=0.3).valid


def test_sources_and_a_function_hold_together():
    sources, size = [(0.1, 0.1, 0.02)], lambda x, y: 0.05 + 0.2 * (1 - x)
    mesh = pardel.mesh(UNIT, sources=sources, size=size, grading=0.3)
    assert pardel.check(UNIT, mesh, sources=sources, grading=0.3).valid and pardel.check(UNIT, mesh, size=size).valid


def test_sources_without_grading_are_a_usage_error():
    with pytest.raises(pardel.UsageError, match="sources needs grading"):
        pardel.mesh(UNIT, sources=[(0, 0, 1)])


@pytest.mark.parametrize("parts, message", [
    (dict(markers={7: 0.1}), "sources: no segment and no point of the domain has the marker 7"),
    (dict(regions={7: 0.1}), "sources: no region of the domain has the attribute 7"),
])
def test_a_marker_or_region_that_the_domain_lacks_is_named(parts, message):
    with pytest.raises(pardel.InvalidInput, match=message):
        pardel.mesh(UNIT, sources=pardel.Sources(**parts), grading=0.2)


@pytest.mark.parametrize("parts, message", [
    (dict(points=[(0, 0)]), r"points of sources has the shape \(1, 2\)"),
    (dict(points=[(0, 0, 1), (0, 0, 0)]), r"points\[1\] of sources is \(0.0, 0.0, 0.0\)"),
    (dict(points=[(0, np.nan, 1)]), r"points\[0\] of sources"),
    (dict(lines=[(0, 0, 1, 1)]), r"lines of sources has the shape \(1, 4\)"),
    (dict(lines=[(0, 0, 1, 1, -1)]), r"lines\[0\] of sources"),
    (dict(lines=[(0, 0, 1, 1, 1, 0)]), r"lines\[0\] of sources"),
    (dict(lines=[(0, 0, 1, 1, 0, 1)]), r"lines\[0\] of sources"),
    (dict(markers=[0.1]), "markers of sources is a list; a dict of lengths is needed"),
    (dict(markers={0.5: 1}), "markers of sources has 0.5, which is no 32-bit integer"),
    (dict(markers={2**40: 1}), "no 32-bit integer"),
    (dict(regions={1: 0}), "regions of sources has the length 0.0 for 1.0"),
    (dict(regions={1: "fine"}), "numbers are needed"),
])
def test_a_wrong_source_is_named(parts, message):
    with pytest.raises(pardel.UsageError, match=message):
        pardel.Sources(**parts)


def test_shapes_without_a_length_are_an_error():
    with pytest.raises(pardel.InvalidInput, match="no point, line or polygon has the property 'length'"):
        pardel.Sources.of({"type": "Point", "coordinates": (0, 0)})
    with pytest.raises(pardel.UsageError, match="length of the geometry is inf; a finite number greater than 0"):
        pardel.Sources.of({"type": "Point", "coordinates": (0, 0)}, float("inf"))
