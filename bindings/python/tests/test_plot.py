"""Plots with matplotlib, pictures in files, and pictures of notebooks."""

import json
import re
import struct
import sys
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel
from pardel.notebook import MOST_TRIANGLES

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
pyplot = pytest.importorskip("matplotlib.pyplot")

needs_cairo = pytest.mark.skipif(not hasattr(pardel._pardel, "Picture"), reason="built without cairo")


@pytest.fixture
def ax():
    figure, axes = pyplot.subplots()
    yield axes
    pyplot.close(figure)


def drawn_values(axes):
    return np.asarray(axes.collections[0].get_array())


def test_a_plot_shows_all_triangles_and_segments(plate, ax):
    mesh = pardel.mesh(plate, max_area=0.5)
    assert mesh.plot(ax) is ax
    assert len(ax.collections[0].get_paths()) == len(mesh.triangles)
    assert len(ax.collections[1].get_segments()) == len(mesh.segments)
    ax.figure.canvas.draw()


@pytest.mark.parametrize("by, expected", [
    ("quality", lambda corners: angles_of(corners).min(axis=1)),
    ("angle", lambda corners: angles_of(corners).max(axis=1)),
    ("size", lambda corners: np.array([max(np.linalg.norm(t[i] - t[j]) for i, j in ((0, 1), (1, 2), (2, 0)))
                                       for t in corners])),
])
def test_colours_show_what_was_asked_for(plate, ax, by, expected):
    mesh = pardel.mesh(plate, max_area=0.5)
    mesh.plot(ax, by)
    assert drawn_values(ax) == pytest.approx(expected(mesh.points[mesh.triangles]))
    assert len(ax.figure.axes) == 2 and ax.figure.axes[1].get_ylabel() != ""


def angles_of(corners):
    """By the law of cosines."""
    a, b, c = (np.linalg.norm(corners[:, i] - corners[:, j], axis=1) for i, j in ((1, 2), (2, 0), (0, 1)))
    return np.degrees(np.arccos(np.stack([(b * b + c * c - a * a) / (2 * b * c), (c * c + a * a - b * b) / (2 * c * a),
                                          (a * a + b * b - c * c) / (2 * a * b)], axis=1)))


def test_the_least_angle_of_a_plot_is_that_of_the_quality(ax):
    mesh = pardel.mesh(pardel.generate("key"))
    mesh.plot(ax, "quality", colorbar=False)
    assert drawn_values(ax).min() == pytest.approx(mesh.quality().min_angle)
    assert len(ax.figure.axes) == 1


def test_regions_are_coloured_by_their_attributes(ax):
    mesh = pardel.mesh(pardel.generate("regions"))
    mesh.plot(ax, "region")
    assert set(drawn_values(ax)) == {10, 20, 30}


def test_numbers_are_at_triangles_or_at_points(plate, ax):
    mesh = pardel.mesh(plate, max_area=0.5)
    mesh.plot(ax, np.arange(len(mesh.triangles)), edges=False, segments=False)
    assert drawn_values(ax).tolist() == list(range(len(mesh.triangles)))
    mesh.plot(ax, mesh.points[:, 0], cmap="magma")
    assert type(ax.collections[1]).__name__ == "TriMesh" and ax.collections[1].get_cmap().name == "magma"
    ax.figure.canvas.draw()


def test_a_plot_without_axes_uses_the_current_ones(plate):
    figure = pyplot.figure()
    assert pardel.mesh(plate).plot() is pyplot.gca()
    assert plate.plot() is pyplot.gca()
    pyplot.close(figure)


def test_a_domain_is_plotted_with_its_holes_and_regions(ax):
    domain = pardel.Domain([(0, 0), (1, 0), (1, 1)], [(0, 1), (1, 2), (2, 0)], holes=[(0.9, 0.1)],
                           regions=[(0.5, 0.4, 7)])
    assert domain.plot(ax, linewidth=3) is ax
    assert len(ax.collections[0].get_segments()) == 3 and ax.collections[0].get_linewidth()[0] == 3
    assert len(ax.lines) == 3 and ax.texts[0].get_text() == "7"


@pytest.mark.parametrize("by, message", [
    ("colour", "by is 'colour'; it must be one of quality, angle, size, region, or an array"),
    ([1, 2], r"by has the shape \(2,\)"),
    (np.zeros((3, 2)), r"by has the shape \(3, 2\)"),
    (["a"], "by is not an array of numbers"),
])
def test_a_wrong_colour_is_named(plate, ax, by, message):
    with pytest.raises(pardel.UsageError, match=message):
        pardel.mesh(plate).plot(ax, by)


def test_without_matplotlib_an_error_says_so(plate, monkeypatch):
    for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(pardel.UsageError, match="plot needs the package matplotlib"):
        pardel.mesh(plate).plot()
    with pytest.raises(pardel.UsageError, match="plot needs the package matplotlib"):
        plate.plot()


def size_of_png(file):
    head = file.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", head[16:24])


@needs_cairo
@pytest.mark.parametrize("by", ["region", "quality", "size"])
def test_a_mesh_is_drawn_as_png(plate, tmp_path, by):
    file = tmp_path / "plate.png"
    pardel.draw(file, pardel.mesh(plate, max_area=0.1), by=by, pixels=300, legend=False)
    assert size_of_png(file) == (312, 312)


@needs_cairo
def test_colours_of_a_drawing_differ(plate, tmp_path):
    mesh = pardel.mesh(plate, max_area=0.1)
    for by in ("region", "quality", "size"):
        pardel.draw(tmp_path / f"{by}.svg", mesh, by=by)
    assert len({(tmp_path / f"{by}.svg").read_text() for by in ("region", "quality", "size")}) == 3


def report_of_a_run(folder, mesh):
    """What `draw` reads of a report of the program: two threads, and a lattice of two by two cells."""
    file = folder / "run.json"
    cells = {"columns": 2, "rows": 2, "low": [0, 0], "high": [4, 4], "thread_of_cell": [0, 1, 1, -1]}
    file.write_text(json.dumps({"schema": "pardel.report/1", "mesh": {"triangles": len(mesh.triangles)},
                                "decomposition": cells}))
    return file


@needs_cairo
def test_triangles_are_coloured_by_the_work_of_the_program(plate, tmp_path):
    mesh = pardel.mesh(plate, max_area=0.1)
    report = report_of_a_run(tmp_path, mesh)
    for by in ("tile", "phase", "thread"):
        pardel.draw(tmp_path / f"{by}.svg", mesh, by=by, report=report)
    assert len({(tmp_path / f"{by}.svg").read_text() for by in ("tile", "phase", "thread")}) == 3
    with pytest.raises(pardel.UsageError, match="path is a int; the path of a file is needed"):
        pardel.draw(tmp_path / "a.svg", mesh, by="tile", report=3)
    report.write_text("{}")
    with pytest.raises(pardel.InvalidInput, match="run.json"):
        pardel.draw(tmp_path / "a.svg", mesh, by="tile", report=report)


@needs_cairo
def test_a_legend_makes_a_drawing_wider_and_a_window_cuts_it(plate, tmp_path):
    mesh = pardel.mesh(plate, max_area=0.1)
    for name, options in {"plain": dict(legend=False), "legend": dict(title="A plate"),
                          "window": dict(legend=False, window=(0, 0, 4, 1))}.items():
        pardel.draw(tmp_path / f"{name}.png", mesh, pixels=300, **options)
    (width, height), legend, window = [size_of_png(tmp_path / f"{name}.png") for name in ("plain", "legend", "window")]
    assert legend[0] > width and legend[1] == height
    assert window[0] == width and window[1] < height


@needs_cairo
def test_domains_and_shapes_are_drawn(plate, tmp_path):
    triangle = {"type": "Polygon", "coordinates": [[(0, 0), (1, 0), (0, 1), (0, 0)]]}
    for k, shape in enumerate([plate, triangle, [triangle]]):
        pardel.draw(tmp_path / f"{k}.svg", shape)
        assert ElementTree.parse(tmp_path / f"{k}.svg").getroot().tag.endswith("svg")


@needs_cairo
@pytest.mark.parametrize("name, options, message", [
    ("a.pdf", {}, "the suffix of a picture is .svg or .png"),
    ("a.svg", dict(by="angle"), "by is 'angle'; it must be one of phase, quality, region, size, thread, tile"),
    ("a.svg", dict(by="tile"), "by is 'tile', which needs report, the file that pardel mesh --json wrote"),
    ("a.svg", dict(report="run.json"), "report is for by='tile', 'phase' or 'thread', and by is 'region'"),
    ("a.svg", dict(by="quality"), "by is 'quality', which needs a mesh, and this is a domain"),
    ("a.svg", dict(pixels=10), "pixels is 10; an integer from 50 to 20000"),
    ("a.svg", dict(pixels="many"), "pixels is 'many'"),
    ("a.svg", dict(window=(0, 0, 0, 1)), "x0 below x1"),
    ("a.svg", dict(window=(0, 0, 1)), "four numbers are needed"),
    ("a.svg", dict(window=(0, 0, float("nan"), 1)), "x0 below x1"),
])
def test_a_wrong_argument_of_a_drawing_is_named(plate, tmp_path, name, options, message):
    with pytest.raises(pardel.UsageError, match=message):
        pardel.draw(tmp_path / name, plate, **options)
    assert list(tmp_path.iterdir()) == []


@needs_cairo
def test_a_drawing_that_cannot_be_written_is_a_file_error(plate, tmp_path):
    with pytest.raises(pardel.FileError, match="none"):
        pardel.draw(tmp_path / "none" / "a.png", plate)


def test_without_cairo_an_error_says_so(plate, tmp_path, monkeypatch):
    monkeypatch.delattr(pardel._pardel, "Picture", raising=False)
    with pytest.raises(pardel.UsageError, match="built without cairo"):
        pardel.draw(tmp_path / "a.png", plate)


def parsed(picture):
    root = ElementTree.fromstring(picture)
    return [(each.tag.split("}")[1], each) for each in root]


@given(st.floats(1e-3, 1), st.floats(-1e6, 1e6), st.floats(1e-200, 1e200))
def test_a_notebook_shows_each_triangle_inside_the_picture(area, shift, scale):
    made = pardel.mesh(pardel.generate("regions"), max_area=area + 0.01)
    mesh = pardel.Mesh((made.points + shift) * scale, made.triangles)
    picture = mesh._repr_svg_()
    root = ElementTree.fromstring(picture)
    width, height = float(root.get("width")), float(root.get("height"))
    path = next(each.get("d") for tag, each in parsed(picture) if tag == "path")
    numbers = np.array(re.split("[MLZ ]+", path)[1:-1], dtype=float).reshape(-1, 3, 2)
    assert len(numbers) == len(mesh.triangles)
    assert (numbers >= 0).all() and (numbers <= (width, height)).all()


def test_regions_have_colours_of_their_own_in_a_notebook():
    picture = pardel.mesh(pardel.generate("regions"))._repr_svg_()
    fills = {each.get("fill") for tag, each in parsed(picture) if tag == "path"}
    assert len(fills - {"none"}) == 3


def test_of_a_large_mesh_a_notebook_shows_the_boundary_and_a_sentence(plate):
    mesh = pardel.mesh(plate, max_area=0.0005)
    assert len(mesh.triangles) > MOST_TRIANGLES
    picture = mesh._repr_svg_()
    (sentence,) = [each.text for tag, each in parsed(picture) if tag == "text"]
    assert f"{len(mesh.triangles):,} triangles; only segments are drawn" in sentence
    assert len(picture) < 100_000


@pytest.mark.parametrize("kind, n", [("coast", 200_000), ("grid", 300), ("points", 200_000), ("star", 2000)])
def test_pictures_of_notebooks_stay_small(kind, n):
    domain = pardel.generate(kind, n)
    assert len(domain._repr_svg_()) < 500_000
    assert len(pardel.mesh(domain, min_angle=0)._repr_svg_()) < 500_000


@pytest.mark.parametrize("mesh", [
    pardel.Mesh([], []), pardel.Mesh([(1, 1)], []), pardel.Mesh([(0, 0), (np.nan, 0), (0, np.inf)], [(0, 1, 2)]),
    pardel.Mesh([(-1.7e308, 0), (1.7e308, 0), (0, 1.7e308)], [(0, 1, 2)]),
])
def test_a_notebook_shows_any_arrays(mesh):
    assert "svg" in ElementTree.fromstring(mesh._repr_svg_()).tag


def test_a_notebook_shows_no_picture_of_arrays_with_a_wrong_index():
    assert pardel.Mesh([(0, 0)], [(0, 1, 2)])._repr_svg_() is None


def test_a_notebook_shows_a_domain_with_its_holes_and_regions(plate):
    picture = parsed(plate._repr_svg_())
    paths = [each.get("d") for tag, each in picture if tag == "path"]
    assert paths[0].count("M") == 8 and paths[1].count("M") == 8 and paths[2].count("M") == 1
