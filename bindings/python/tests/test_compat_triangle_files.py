"""pardel.compat.triangle: files, examples and pictures, and what the modules promise."""

import doctest
import importlib
import os
from pathlib import Path

import numpy as np
import pytest

import pardel
import pardel.compat.triangle as tr
from pardel.compat.triangle.data import names

POLY = """# a comment
4 2 1 1
1 0 0 10 0   # another one
2 4 0 20 5
3 4 3 30 0
4 0 3 40 0

5 1
1 1 2 7
2 2 3 8
3 3 4 9
4 4 1 7
5 1 3 0
1
1 1 2
2
1 3 1 17 0.5
2 3 1 0.25
"""


@pytest.mark.parametrize("name", ["pardel.compat.triangle", "pardel.compat.triangle.points",
                                  "pardel.compat.triangle.triangulation", "pardel.compat.triangle.files",
                                  "pardel.compat.triangle.data"])
def test_the_examples_of_docstrings_are_true(name):
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert tried > 0 and failed == 0


def test_the_examples_of_the_page_are_true():
    source = Path(os.environ.get("PARDEL_SOURCE", Path(__file__).resolve().parents[3]))
    failed, tried = doctest.testfile(str(source / "docs/python_triangle.md"), module_relative=False)
    assert tried > 5 and failed == 0


def test_every_name_has_a_docstring():
    assert all(getattr(tr, name).__doc__ for name in tr.__all__)


def test_a_poly_is_read_with_numbers_from_0():
    found = tr.loads(poly=POLY)
    assert found["vertices"].tolist() == [[0, 0], [4, 0], [4, 3], [0, 3]]
    assert found["vertex_attributes"].tolist() == [[10], [20], [30], [40]]
    assert found["vertex_markers"].tolist() == [[0], [5], [0], [0]]
    assert found["segments"].tolist() == [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]
    assert found["segment_markers"].tolist() == [[7], [8], [9], [7], [0]]
    assert found["holes"].tolist() == [[1, 2]]
    assert found["regions"].tolist() == [[3, 1, 17, 0.5], [3, 1, 0.25, 0.25]]
    for key in ("vertex_markers", "segments", "segment_markers"):
        assert found[key].dtype == np.int32
    made = tr.triangulate(found, "pqAa")
    assert pardel.Mesh(made["vertices"], made["triangles"]).area() == 6
    assert set(made["triangle_attributes"].ravel()) == {0.25}


def test_all_six_kinds_of_files_are_read(tmp_path):
    square = pardel.mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)], max_area=0.1)
    pardel.write(tmp_path / "square.node", square)
    (tmp_path / "square.area").write_text(f"{len(square.triangles)}\n" + "".join(
        f"{k} {0.01 * k}\n" for k in range(len(square.triangles))))
    (tmp_path / "square.edge").write_text(f"{len(square.edges)} 1\n" + "".join(
        f"{k} {a + 1} {b + 1} {m}\n" for k, ((a, b), m) in enumerate(zip(square.edges, square.edge_markers))))
    (tmp_path / "square.neigh").write_text(f"{len(square.triangles)} 3\n" + "".join(
        f"{k} {a} {b} {c}\n" for k, (a, b, c) in enumerate(square.neighbors + (square.neighbors >= 0))))
    found = tr.load(tmp_path, "square")
    assert np.array_equal(found["vertices"], square.points) and np.array_equal(found["triangles"], square.triangles)
    assert np.array_equal(found["edges"], square.edges)
    assert np.array_equal(found["triangle_neighbors"], square.neighbors)
    assert found["edge_markers"].ravel().tolist() == square.edge_markers.tolist()
    assert found["triangle_max_area"][3].tolist() == [0.03]
    assert len(tr.triangulate(found, "ra")["triangles"]) > len(square.triangles)


def test_rays_of_a_voronoi_diagram_are_read():
    found = tr.loads(node="2 2 0 0\n1 0 0\n2 1 0", edge="3 0\n1 1 2\n2 1 -1 -1 0.5\n3 2 -1 1 0")
    assert found["edges"].tolist() == [[0, 1]] and found["ray_origins"].tolist() == [[0], [1]]
    assert found["ray_directions"].tolist() == [[-1, 0.5], [1, 0]]


def test_points_of_a_poly_may_be_in_a_node():
    found = tr.loads(node="3 2\n1 0 0\n2 1 0\n3 0 1\n", poly="0 2 0 0\n1 0\n1 1 2\n0\n", ele="1\n1 1 2 3")
    assert found["segments"].tolist() == [[0, 1]] and found["triangles"].tolist() == [[0, 1, 2]]
    assert sorted(found) == ["segments", "triangles", "vertices"]


@pytest.mark.parametrize("texts, message", [
    (dict(node="x 2 0 0"), "the .node has 'x' on line 1; a number of things"),
    (dict(node="3 2 0 0\n1 0 0\n2 1 0"), "the .node ends before vertex 2 of 3"),
    (dict(node="1 2 0 0\n1 0 zero"), "the .node has 'zero' on line 2; a number is needed"),
    (dict(node="1 2 0 0\n\n1 0"), "the .node has 2 fields on line 3; 3 are needed"),
    (dict(node="1 3 0 0\n1 0 0 0"), "points with 3 coordinates"),
    (dict(node="2 2 0 0\n1 0 0\n3 1 0"), "whose numbers are not 0, 1, 2"),
    (dict(ele="1 3 0\n0 0 1 2.5"), "a triangle of the .ele has a number that is not an integer"),
    (dict(poly="0\n"), "the .poly ends before a header"),
    (dict(poly="0\n0\n0\n1\n0 1 2\n"), "the .poly has 3 fields on line 5; 4 are needed"),
    (dict(edge="2 0\n0 0 1"), "the .edge has fewer than 2 edges"),
    (dict(neigh="1\n0 1"), "the .neigh has 2 fields on line 2; 4 are needed")])
def test_a_wrong_text_is_an_error_with_the_line(texts, message):
    with pytest.raises(pardel.InvalidInput, match=message):
        tr.loads(**texts)


def test_files_that_are_not_there_are_an_error(tmp_path):
    with pytest.raises(pardel.FileError, match="there is no file with this name"):
        tr.load(tmp_path, "nothing")


@pytest.mark.parametrize("name", [name for name in names() if "." not in name])
def test_each_example_can_be_meshed(name):
    data = tr.get_data(name)
    opts = "pq" if "segments" in data else "rq" if "triangles" in data else "q"
    made = tr.triangulate(data, opts)
    domain = pardel.Domain(data["vertices"], data.get("segments"), holes=data.get("holes"))
    if name != "ell":  # it has no segments, and is not convex
        assert pardel.check(domain, (made["vertices"], made["triangles"]), min_angle=20)
    assert len(made["triangles"]) > 10


@pytest.mark.parametrize("name", [name for name in names() if "." in name])
def test_the_meshes_of_the_examples_are_meshes(name):
    data = tr.get_data(name)
    domain = tr.get_data(name.split(".")[0])
    assert np.array_equal(data["vertices"][:len(domain["vertices"])], domain["vertices"])
    domain = pardel.Domain(domain["vertices"], domain.get("segments"), holes=domain.get("holes"))
    assert pardel.check(domain, (data["vertices"], data["triangles"]), min_angle=0)


def test_an_example_that_is_not_there_is_an_error_with_all_names():
    with pytest.raises(pardel.UsageError, match="there is no example 'greenland'; the names are A, A.1, box"):
        tr.get_data("greenland")


@pytest.fixture
def plt(monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    monkeypatch.setattr(pyplot, "show", lambda: None)
    yield pyplot
    pyplot.close("all")


def test_a_picture_has_all_that_a_dictionary_has(plt):
    tri = dict(tr.get_data("la"), holes=[[50, 40]])
    made = tr.triangulate(tri, "pqaAeo2")
    ax = plt.axes()
    tr.plot(ax, labels=True, **made)
    lines = [len(each.get_segments()) for each in ax.collections if hasattr(each, "get_segments")]
    assert lines == [len(made["segments"]), len(made["edges"])]
    assert len(ax.texts) == len(made["vertices"]) + len(made["regions"]) + len(made["triangles"])
    assert len(ax.lines) == 2 and not ax.get_xaxis().get_visible()


def test_rays_are_drawn_beyond_the_picture_and_do_not_widen_it(plt):
    points, edges, origins, directions = tr.voronoi([[0, 0], [0, 1], [0.5, 0.5], [1, 1], [1, 0]])
    ax = plt.axes()
    tr.plot(ax, vertices=points, edges=edges, ray_origins=origins, ray_directions=directions)
    limits = ax.axis()
    assert limits[1] - limits[0] < 2
    rays = ax.collections[-1].get_segments()
    assert len(rays) == 4
    for (start, end), direction in zip(rays, directions):
        assert end[0] < limits[0] or end[0] > limits[1] or end[1] < limits[2] or end[1] > limits[3]
        assert (end - start) @ direction == pytest.approx(np.linalg.norm(end - start) * np.linalg.norm(direction))


@pytest.mark.parametrize("function, share", [(tr.compare, "y"), (tr.comparev, "x")])
def test_two_dictionaries_are_drawn_with_the_same_limits(plt, function, share):
    domain = tr.get_data("A")
    function(plt, domain, tr.triangulate(domain, "pq"), figsize=(4, 5))
    first, second = plt.gcf().axes
    assert first.axis() == second.axis() and plt.gcf().get_size_inches().tolist() == [4, 5]
    shared = first.get_shared_y_axes() if share == "y" else first.get_shared_x_axes()
    assert shared.joined(first, second)


def test_markers_are_written_at_vertices(plt):
    tr.plot(plt.axes(), vertices=[[0, 0], [1, 0]], vertex_markers=[[4], [7]], markers=True)
    assert [text.get_text() for text in plt.gca().texts] == ["4", "7"]


def test_an_example_can_be_shown(plt):
    tr.show_data("face")
    assert len(plt.gcf().axes) == 1
