"""Scripts as people write them for the package `triangle`: they run, and their results are right."""

import runpy
from pathlib import Path

import numpy as np
import pytest

import pardel

SCRIPTS = Path(__file__).resolve().parent / "scripts_triangle"


@pytest.fixture
def run(monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    monkeypatch.setattr(plt, "show", lambda: None)
    yield lambda name: runpy.run_path(str(SCRIPTS / f"{name}.py"))
    plt.close("all")


def is_right(domain, mesh, **bounds):
    of = pardel.Domain(domain["vertices"], domain.get("segments"), holes=domain.get("holes"))
    corners = mesh["triangles"][:, :3]  # nodes in the middle of edges come behind them
    return pardel.check(of, (mesh["vertices"][:corners.max() + 1], corners), **{"min_angle": 0, **bounds}).valid


def test_each_script_is_run_by_a_test_and_imports_the_module():
    text = Path(__file__).read_text()
    names = [path.stem for path in SCRIPTS.glob("*.py")]
    assert len(names) >= 10
    for name in names:
        assert f'run("{name}")' in text
        lines = (SCRIPTS / f"{name}.py").read_text().splitlines()
        assert "import pardel.compat.triangle as tr" in lines and 10 <= len(lines) <= 30, name


def test_random_points_have_the_degrees_of_euler(run):
    found = run("delaunay_of_random_points")
    n, h = 300, found["hull"]
    assert len(found["mesh"]["triangles"]) == len(found["same"]) == 2 * n - 2 - h
    assert found["boundary"] == h and found["mean_degree"] == 2 * (3 * n - 3 - h) / n
    assert is_right(dict(vertices=found["points"]), found["mesh"], conforming=True)


def test_the_square_with_a_circular_hole_is_meshed(run):
    found = run("square_with_circular_hole")
    assert is_right(found["A"], found["B"], min_angle=20, max_area=0.05) and len(found["B"]["segments"]) >= 46
    assert sorted(found["B"]) == ["holes", "segment_markers", "segments", "triangles", "vertex_markers", "vertices"]


def test_two_materials_have_their_areas(run):
    found = run("two_materials")
    assert is_right(found["plate"], found["mesh"], min_angle=30, max_area=0.2)
    assert found["area_of"] == pytest.approx({1: 4, 2: 4})
    assert found["largest"][2] <= 0.02 < found["largest"][1] <= 0.2
    assert np.all(found["mesh"]["vertices"][found["outflow"]][..., 0] == 4)


def test_linear_temperatures_are_exact(run):
    found = run("heat_on_an_ell")
    assert found["error"] < 1e-12 and found["free"].any()
    assert is_right(found["ell"], found["mesh"], min_angle=32, max_area=0.02)


def test_refinement_follows_the_areas_that_a_script_gives(run):
    found = run("refine_near_a_corner")
    assert found["counts"] == sorted(found["counts"]) and found["counts"][-1] > 4 * found["counts"][0]
    assert is_right(found["square"], found["mesh"], min_angle=25)
    p = found["mesh"]["vertices"][found["mesh"]["triangles"]]
    near = np.hypot(*p.mean(axis=1).T) < 0.2
    assert near.mean() > 0.3


def test_levels_of_a_box_get_smaller_triangles(run):
    found = run("boxes_in_levels")
    assert found["sizes"][0] == (8, 8) and len(found["levels"]) == 4
    for level, area in zip(found["levels"], (9, 0.2, 0.05, 0.0125)):
        assert is_right(found["box"], level, max_area=area)
    assert np.array_equal(found["stored"]["triangles"], found["levels"][-1]["triangles"])


def test_a_voronoi_diagram_is_drawn(run):
    found = run("voronoi_cells")
    assert len(found["vertices"]) == len(found["edges"]) == len(found["ray_origins"]) == 4
    assert [len(lines.get_segments()) for lines in found["axes"][1].collections[1:]] == [4, 4]


def test_the_hull_of_dots_bounds_their_mesh(run):
    found = run("convex_hull_of_dots")
    assert is_right(dict(vertices=found["points"], segments=found["segments"]), found["mesh"], min_angle=20,
                    max_area=0.02)
    hull = {frozenset(edge) for edge in found["segments"].tolist()}
    assert {frozenset(edge) for edge in found["by_switch"]["segments"].tolist()} == hull


def test_a_spiral_gets_the_angles_that_are_asked_for(run):
    table = run("quality_of_a_spiral")["table"]
    assert [opts for opts, _, _ in table] == ["", "q", "q25", "q30", "q32.5"] and table[0][1] == 17
    for (_, triangles, angle), least in zip(table, (0, 20, 25, 30, 32.5)):
        assert angle >= least and triangles >= 17


def test_quadratic_elements_integrate_exactly(run):
    found = run("quadratic_elements")
    whole = found["whole"]["vertices"][found["whole"]["triangles"]]
    u, v = whole[:, 1] - whole[:, 0], whole[:, 2] - whole[:, 0]
    y = whole[:, :, 1]
    exact = ((u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 12 * (y ** 2 + y * np.roll(y, 1, axis=1)).sum(axis=1)).sum()
    assert found["moment"] == pytest.approx(exact, rel=1e-12)
    assert is_right(found["letter"], found["mesh"], min_angle=20, max_area=0.5)


def test_all_triangles_are_reached_through_neighbours(run):
    found = run("dual_graph")
    assert found["steps"].min() == 0 and np.count_nonzero(found["steps"] == 0) == 1
    assert found["boundary_sides"] == len(found["mesh"]["segments"])
    assert is_right(found["A"], found["mesh"], min_angle=20, max_area=0.002)


def test_conforming_meshes_of_a_letter_are_delaunay(run):
    found = run("conforming_letter")
    for opts, mesh in found["meshes"].items():
        assert is_right(found["A"], mesh, conforming="D" in opts)
    assert found["counts"]["p"] == 11 < found["counts"]["pqa0.1D"]


def test_texts_and_files_give_the_same_domain(run):
    found = run("text_of_files")
    assert all(np.array_equal(found["domain"][key], found["same"][key]) for key in found["domain"])
    assert found["mesh"]["vertex_attributes"][:5].ravel().tolist() == [10, 20, 30, 40, 25]
    assert found["mesh"]["vertex_markers"][2] == 7 and is_right(found["domain"], found["mesh"], min_angle=30)


def test_crossing_lines_get_a_common_point(run):
    found = run("shared_points_and_crossings")
    assert [2, 2] in found["mesh"]["vertices"].tolist() and len(found["mesh"]["segments"]) == 8
    assert np.array_equal(found["kept"]["vertices"][:12], found["vertices"]) and len(found["mesh"]["vertices"]) == 9
    assert is_right(found["mesh"], found["mesh"])
