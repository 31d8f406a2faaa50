"""Rasters of edge lengths."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel

UNIT = pardel.polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
VALUES = np.array([[0.1, 0.2], [0.05, 0.4]])


def bilinear(values, extent):
    """A function of x and y with the lengths of a raster, written from the definition."""
    left, right, bottom, top = extent
    rows, columns = values.shape

    def at(x, y):
        i = np.clip((x - left) / (right - left) * columns - 0.5, 0, columns - 1)
        j = np.clip((top - y) / (top - bottom) * rows - 0.5, 0, rows - 1)
        i0, j0 = min(int(i), max(columns - 2, 0)), min(int(j), max(rows - 2, 0))
        i1, j1 = min(i0 + 1, columns - 1), min(j0 + 1, rows - 1)
        upper = values[j0, i0] * (1 - (i - i0)) + values[j0, i1] * (i - i0)
        lower = values[j1, i0] * (1 - (i - i0)) + values[j1, i1] * (i - i0)
        return float(upper * (1 - (j - j0)) + lower * (j - j0))

    return at


lengths = st.floats(0.04, 0.5)
rasters = st.tuples(st.integers(1, 4), st.integers(1, 4)).flatmap(
    lambda shape: st.lists(lengths, min_size=shape[0] * shape[1], max_size=shape[0] * shape[1]).map(
        lambda all: np.array(all).reshape(shape)))


@given(rasters)
def test_a_mesh_keeps_the_lengths_of_a_raster(values):
    mesh = pardel.mesh(UNIT, size=pardel.Raster(values, (0, 1, 0, 1)))
    wanted = bilinear(values, (0, 1, 0, 1))
    assert pardel.check(UNIT, mesh, size=lambda x, y: wanted(x, y) * (1 + 1e-9)).valid
    assert pardel.check(UNIT, mesh, size=pardel.Raster(values, (0, 1, 0, 1))).valid


@given(rasters)
def test_a_mesh_has_not_many_more_triangles_than_the_raster_asks_for(values):
    mesh = pardel.mesh(UNIT, size=pardel.Raster(values, (0, 1, 0, 1)))
    assert mesh.digest == pardel.mesh(UNIT, size=pardel.Raster(values, (0, 1, 0, 1)), threads=2).digest
    finest = pardel.mesh(UNIT, size=float(values.min()))
    assert len(mesh.triangles) <= 1.5 * len(finest.triangles) + 10


def test_a_raster_of_one_length_is_that_length():
    raster = pardel.Raster([[0.125]], (-1, 2, -1, 2))
    assert pardel.mesh(UNIT, size=raster).digest == pardel.mesh(UNIT, size=lambda x, y: 0.125).digest


def test_rows_go_from_north_to_south_and_columns_from_west_to_east():
    mesh = pardel.mesh(UNIT, size=pardel.Raster([[0.02, 0.4], [0.4, 0.4]], (0, 1, 0, 1)))
    middle = mesh.points[mesh.triangles].mean(axis=1)
    north_west = (middle[:, 0] < 0.5) & (middle[:, 1] > 0.5)
    assert north_west.sum() > 0.7 * len(mesh.triangles)


@pytest.mark.parametrize("size", [
    (VALUES, (0, 1, 0, 1)), (VALUES, (0.5, 0, 0, 0, -0.5, 1)), (VALUES, (0.5, 0, 0, 0, -0.5, 1, 0, 0, 1)),
    pardel.Raster(VALUES.tolist(), transform=(0.5, 0, 0, 0, -0.5, 1)), pardel.Raster(VALUES, [0, 1, 0, 1]),
])
def test_a_raster_may_be_given_in_several_ways(size):
    usual = pardel.Raster(VALUES, extent=(0, 1, 0, 1))
    assert pardel.mesh(UNIT, size=size).digest == pardel.mesh(UNIT, size=usual).digest


def test_a_raster_shows_what_it_was_made_of():
    raster = pardel.Raster(VALUES, (0, 4, 1, 3))
    assert raster.values.tolist() == VALUES.tolist() and raster.extent == (0, 4, 1, 3)
    assert not raster.values.flags.writeable
    values = pardel.Raster(VALUES, (0, 4, 1, 3)).values  # which keeps the raster alive
    assert values.tolist() == VALUES.tolist()


def test_a_raster_is_read_from_a_file(tmp_path):
    head = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\n"
    (tmp_path / "lengths.asc").write_text(head + "0.1 0.2\n0.05 0.4\n")
    raster = pardel.Raster.read(tmp_path / "lengths.asc")
    assert raster.values.tolist() == VALUES.tolist() and raster.extent == (0, 1, 0, 1)
    by_path = pardel.mesh(UNIT, size=tmp_path / "lengths.asc")
    assert by_path.digest == pardel.mesh(UNIT, size=(VALUES, (0, 1, 0, 1))).digest
    np.save(tmp_path / "lengths.npy", VALUES)
    (tmp_path / "lengths.wld").write_text("0.5\n0\n0\n-0.5\n0.25\n0.75\n")
    assert pardel.Raster.read(str(tmp_path / "lengths.npy")).values.tolist() == VALUES.tolist()


def test_a_mesh_is_refined_to_the_lengths_of_a_raster():
    coarse = pardel.mesh(UNIT)
    finer = pardel.refine(coarse, size=(VALUES, (0, 1, 0, 1)))
    assert pardel.check(UNIT, finer, size=(VALUES, (0, 1, 0, 1))).valid
    assert not pardel.check(UNIT, coarse, size=(VALUES, (0, 1, 0, 1))).valid


def test_grading_limits_the_steps_of_a_raster():
    steep = pardel.Raster([[0.01, 1, 1, 1, 1, 1, 1, 1]], (0, 1, 0, 1))
    graded = pardel.mesh(UNIT, size=steep, grading=0.1)
    assert pardel.check(UNIT, graded, size=steep, grading=0.1).valid
    assert len(graded.triangles) > len(pardel.mesh(UNIT, size=steep).triangles)


@pytest.mark.parametrize("values, extent", [
    ([[0.1]], (0, 0.5, 0, 1)), ([[0.1, np.nan]], (0, 1, 0, 1)),
    (np.ma.masked_equal([[0.1, 9]], 9), (0, 1, 0, 1)),
])
def test_a_place_without_a_length_is_an_error_that_names_it(values, extent):
    with pytest.raises(pardel.InvalidInput, match=r"the raster of the sizes has no size at \("):
        pardel.mesh(UNIT, size=pardel.Raster(values, extent), max_edge=0.1)


def test_infinity_is_no_bound():
    assert len(pardel.mesh(UNIT, size=pardel.Raster([[np.inf]], (0, 1, 0, 1))).triangles) == 2


WRONG_RASTERS = {
    "one dimension": (([0.1], (0, 1, 0, 1)), {}, r"have the shape \(1,\)"),
    "no value": (([[]], (0, 1, 0, 1)), {}, r"have the shape \(1, 0\)"),
    "text": (([["fine"]], (0, 1, 0, 1)), {}, "not an array of numbers"),
    "a length of zero": (([[1, 1], [1, 0]], (0, 1, 0, 1)), {}, "the value 0.0 in row 1, column 1"),
    "no extent": (([[1]],), {}, "needs its extent or its transform"),
    "both": (([[1]], (0, 1, 0, 1)), dict(transform=(1, 0, 0, 0, -1, 1)), "and not both"),
    "three numbers": (([[1]], (0, 1, 0)), {}, "4 finite numbers are needed"),
    "an endless extent": (([[1]], (0, np.inf, 0, 1)), {}, "4 finite numbers are needed"),
    "a flat extent": (([[1]], (0, 1, 1, 1)), {}, "each has to be an interval"),
    "a rotation": (([[1]],), dict(transform=(1, 0.1, 0, 0, -1, 1)), "b = d = 0"),
    "another rotation": (([[1]],), dict(transform=(1, 0, 0, 0.1, -1, 1)), "b = d = 0"),
    "rows to the north": (([[1]],), dict(transform=(1, 0, 0, 0, 1, 1)), "rows to the south"),
}


@pytest.mark.parametrize("what", WRONG_RASTERS)
def test_a_wrong_raster_is_named(what):
    arguments, options, message = WRONG_RASTERS[what]
    with pytest.raises(pardel.UsageError, match=message):
        pardel.Raster(*arguments, **options)


def test_lengths_at_the_points_may_be_in_a_file(tmp_path, square):
    file = tmp_path / "unit.sizes"
    file.write_text("4\n1 0.02\n2 0.2\n3 0.2\n4 0.02\n")
    mesh = pardel.mesh(square, size=file)
    assert mesh.digest == pardel.mesh(square, size=[0.02, 0.2, 0.2, 0.02]).digest
    assert pardel.check(square, mesh, size=str(file)).valid
    coarse = pardel.delaunay(square)
    assert pardel.refine(coarse, size=file).digest == pardel.refine(coarse, size=[0.02, 0.2, 0.2, 0.02]).digest


@pytest.mark.parametrize("suffix", ["vtu", "node"])
def test_lengths_may_be_at_the_points_of_a_mesh_in_a_file(tmp_path, suffix):
    lengths = np.array([0.05, 0.3, 0.3, 0.1])
    background = pardel.delaunay(UNIT.points, attributes=lengths[:, None])
    background.save(tmp_path / f"background.{suffix}")
    mesh = pardel.mesh(UNIT, size=tmp_path / f"background.{suffix}")
    assert mesh.digest == pardel.mesh(UNIT, size=(background, lengths)).digest


def test_a_wrong_file_of_lengths_is_named(tmp_path):
    def refused(name, text, error, message):
        (tmp_path / name).write_text(text)
        with pytest.raises(error, match=message):
            pardel.mesh(UNIT, size=tmp_path / name)

    refused("few.sizes", "1\n1 0.1\n", pardel.InvalidInput, "few.sizes: 1 sizes for 4 points")
    refused("zero.sizes", "1\n1 0\n", pardel.InvalidInput, "zero.sizes:2")
    refused("text.sizes", "fine\n", pardel.InvalidInput, "text.sizes:1")
    pardel.write(tmp_path / "bare.vtu", pardel.mesh(UNIT))
    with pytest.raises(pardel.InvalidInput, match="bare.vtu: the mesh has no values at its points that could be edge"):
        pardel.mesh(UNIT, size=tmp_path / "bare.vtu")
    with pytest.raises(pardel.UsageError, match="size is ''; .* or the path of a file"):
        pardel.mesh(UNIT, size="")
    for name in ("none.asc", "none.vtu", "none.sizes"):
        with pytest.raises(pardel.FileError, match=name):
            pardel.mesh(UNIT, size=name)
