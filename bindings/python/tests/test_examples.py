"""The scripts of examples/python: they run, their figures are those on the page, and the errors fall as theory says."""

import importlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pardel

SOURCE = Path(os.environ.get("PARDEL_SOURCE", Path(__file__).resolve().parents[3]))
EXAMPLES = SOURCE / "examples/python"
PAGE = (SOURCE / "docs/python_examples.md").read_text()
SCRIPTS = sorted(path.stem for path in EXAMPLES.glob("*.py"))


def needs(name):
    """Skips a test if what a script needs is not installed."""
    text = (EXAMPLES / f"{name}.py").read_text()
    for package in ("scipy", "dolfinx", "shapely"):
        if f"from {package}" in text or "from poisson" in text and package == "scipy":
            pytest.importorskip(package)
    if name == "check_gmsh" and shutil.which("gmsh") is None:
        pytest.skip("gmsh is not installed")


def run(name, *arguments, folder):
    environment = {**os.environ, "HOME": str(folder), "XDG_CACHE_HOME": str(folder)}  # DOLFINx compiles into a cache
    ended = subprocess.run([sys.executable, "-B", str(EXAMPLES / f"{name}.py"), *map(str, arguments)], cwd=folder,
                           capture_output=True, text=True, env=environment)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


@pytest.fixture
def script(monkeypatch):
    """Imports a script."""
    monkeypatch.syspath_prepend(str(EXAMPLES))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)

    def imported(name):
        needs(name)
        return importlib.import_module(name)

    return imported


def test_every_script_is_on_the_page_with_its_command():
    assert sorted(re.findall(r"^\$ python3 examples/python/(\w+)\.py$", PAGE, re.M)) == SCRIPTS


@pytest.mark.parametrize("name", SCRIPTS)
def test_a_script_is_short_and_says_how_it_is_run(name):
    lines = (EXAMPLES / f"{name}.py").read_text().splitlines()
    assert 30 <= len(lines) <= 90 and f"    python3 {name}.py" in "\n".join(lines[:12])


@pytest.mark.parametrize("name", [name for name in SCRIPTS if name not in ("check_gmsh", "dolfinx_poisson")])
def test_a_script_prints_what_the_page_says(name, tmp_path):
    needs(name)
    printed = run(name, folder=tmp_path)
    (quoted,) = re.findall(rf"^\$ python3 examples/python/{name}\.py\n(.*?)^```", PAGE, re.M | re.S)
    number = r"[0-9]+(?:\.[0-9]+)?(?:e[-+][0-9]+)?"
    assert re.sub(r"\s+", " ", re.sub(number, "#", printed)) == re.sub(r"\s+", " ", re.sub(number, "#", quoted))
    numbers = [[float(each) for each in re.findall(number, text)] for text in (printed, quoted)]
    assert numbers[0] == pytest.approx(numbers[1], rel=0.02, abs=0.011), printed
    assert list(tmp_path.iterdir()) == []


def test_the_airfoil_is_written_and_right(tmp_path, script):
    run("airfoil", tmp_path / "airfoil.vtu", folder=tmp_path)
    domain, lengths = script("airfoil").wind_tunnel()
    assert pardel.check(domain, tmp_path / "airfoil.vtu", min_angle=30, size=lengths, grading=0.15)
    assert len(domain.holes) == 1


def test_the_lake_is_written_with_its_shores_as_land(tmp_path, script):
    run("lake", tmp_path / "lake.gr3", folder=tmp_path)
    lake = script("lake")
    mesh = pardel.read(tmp_path / "lake.gr3")
    found = pardel.check(lake.in_metres(lake.lake()), mesh, min_angle=30, max_edge=800)
    assert set(found.violation_counts) <= {"wrong_edge_marker"}, "the format has types of boundaries, and no markers"
    assert re.search(r"^3 = number of land boundaries$", (tmp_path / "lake.gr3").read_text(), re.M)


def test_the_projection_of_the_lake_keeps_lengths(script):
    lake = script("lake")
    north, east = lake.projected([9.4, 47.61]), lake.projected([9.41, 47.6])
    assert north[0] == east[1] == 0
    assert (north[1], east[0]) == pytest.approx((1111.8, 752.0), abs=0.5)  # a hundredth of a degree at 47.6 degrees


def test_the_errors_of_the_poisson_problem_fall_as_theory_says(script):
    rows = np.array(list(script("poisson").study()))
    rates = np.log2(rows[:-1, 2:] / rows[1:, 2:])
    assert np.all(np.abs(rates[:, 0] - 2) < 0.1), "of the values"
    assert np.all(np.abs(rates[:, 1] - 1) < 0.05), "of the gradients"


def test_linear_functions_are_solved_exactly(script):
    poisson = script("poisson")
    mesh = pardel.mesh(pardel.polygon([(0, 0), (2, 0), (1, 3)]), max_edge=0.3)
    u = poisson.solve(mesh, lambda x, y: 0 * x, lambda x, y: 1 + 2 * x - y)
    assert np.allclose(u, 1 + 2 * mesh.points[:, 0] - mesh.points[:, 1], atol=1e-12)


def test_the_corner_of_the_l_spoils_the_rate_and_grading_restores_it(script):
    shape = script("l_shape")
    domain = pardel.polygon(shape.CORNERS)

    def rate(meshes):
        rows = list(shape.study(meshes))
        return np.log(rows[0][1] / rows[-1][1]) / np.log(rows[-1][0] / rows[0][0])

    assert abs(rate(shape.uniform(domain)) - 1 / 3) < 0.05
    assert abs(rate(shape.graded(domain)) - 1 / 2) < 0.05


def test_the_adaptive_loop_finds_the_corner_and_the_better_rate(script):
    rows = list(script("adaptive").adapt(pardel.polygon(script("l_shape").CORNERS)))
    counts, estimates, errors = (np.array([row[k] for row in rows], dtype=float) for k in range(3))
    assert np.log(errors[1] / errors[-1]) / np.log(counts[-1] / counts[1]) > 0.45
    assert np.all((1 < estimates / errors) & (estimates / errors < 5))
    mesh = rows[-1][3]
    corners = mesh.points[mesh.triangles]
    longest = np.linalg.norm(np.roll(corners, 1, axis=1) - corners, axis=2).max(axis=1)
    smallest = corners[longest.argmin()].mean(axis=0)
    assert np.hypot(*smallest) < 0.01 and longest.max() > 20 * longest.min()


def test_the_cells_of_the_groundwater_grid_are_clockwise_and_fill_the_outline(script):
    model = script("groundwater")
    domain, lengths = model.domain_and_lengths()
    vertices, cell2d = model.disv(pardel.mesh(domain, min_angle=30, size=lengths, grading=0.2))
    assert [row[0] for row in vertices] == list(range(len(vertices)))
    assert [row[0] for row in cell2d] == list(range(len(cell2d)))
    places = np.array(vertices)[:, 1:]
    corners = places[np.array([row[4:] for row in cell2d])]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = 0.5 * (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    assert np.all(areas < 0) and -areas.sum() == pytest.approx(2000 * 1200)
    assert all(row[3] == 3 == len(row) - 4 for row in cell2d)
    assert np.allclose(corners.mean(axis=1), [row[1:3] for row in cell2d])


def test_the_file_of_the_groundwater_grid_has_its_blocks_and_counts_from_one(tmp_path):
    run("groundwater", tmp_path / "grid.disv", folder=tmp_path)
    blocks = dict(re.findall(r"^BEGIN (\w+)\n(.*?)^END \1$", (tmp_path / "grid.disv").read_text(), re.M | re.S))
    assert list(blocks) == ["OPTIONS", "DIMENSIONS", "GRIDDATA", "VERTICES", "CELL2D"]
    sizes = dict(line.split() for line in blocks["DIMENSIONS"].splitlines())
    cells = [line.split() for line in blocks["CELL2D"].splitlines()]
    vertices = [line.split() for line in blocks["VERTICES"].splitlines()]
    assert sizes == {"NLAY": "1", "NCPL": str(len(cells)), "NVERT": str(len(vertices))}
    numbers = {int(number) for row in cells for number in row[4:]}
    assert (min(numbers), max(numbers)) == (1, len(vertices)) and cells[0][0] == vertices[0][0] == "1"


def test_meshes_of_gmsh_are_read_and_judged(tmp_path):
    needs("check_gmsh")
    printed = run("check_gmsh", folder=tmp_path)
    rows = re.findall(r"^(\S+) +(\d+) triangles, smallest angle ([0-9.]+) degrees; wrong: (.*)$", printed, re.M)
    assert [row[0] for row in rows] == ["MeshAdapt", "Delaunay", "Frontal-Delaunay"]
    for _, triangles, angle, wrong in rows:  # they cover the plate, whatever version of Gmsh made them
        assert 2000 < int(triangles) < 4000 and float(angle) > 15
        assert set(re.findall(r"[a-z]+_[a-z_]+", wrong)) <= {"not_delaunay"}


def test_a_mesh_of_gmsh_that_is_wrong_is_refused(tmp_path, script):
    check = script("check_gmsh")
    mesh = check.gmsh_mesh(tmp_path, [check.OUTLINE], 0.2, 5)  # without the window
    found = pardel.check(pardel.polygon(check.OUTLINE, check.WINDOW), mesh, min_angle=0)
    assert "covered_exterior" in found.violation_counts or "broken_segment" in found.violation_counts


def test_dolfinx_gets_the_mesh_and_its_markers(tmp_path):
    needs("dolfinx_poisson")
    counts, temperatures = run("dolfinx_poisson", folder=tmp_path).splitlines()
    assert re.fullmatch(r"\d+ triangles, 64 facets on the left, 64 on the hole", counts)
    least, most, mean = map(float, re.fullmatch(r"temperature from (\S+) to (\S+) degrees, mean (\S+)",
                                                temperatures).groups())
    assert (least, most) == (0, 100) and 60 < mean < 90
