"""pardel.read and pardel.write: all formats of the library."""

import numpy as np
import pytest

import pardel


@pytest.mark.parametrize("suffix", ["node", "ele", "msh", "vtu", "vtk", "off", "2dm", "gr3", "14"])
def test_a_mesh_is_the_same_after_it_was_written_and_read(plate, tmp_path, suffix):
    made = pardel.mesh(plate, max_area=0.1)
    file = tmp_path / f"mesh.{suffix}"
    pardel.write(file, made)
    read = pardel.read(file)
    assert np.array_equal(read.points, made.points)
    assert sorted(map(sorted, read.triangles.tolist())) == sorted(map(sorted, made.triangles.tolist()))


@pytest.mark.parametrize("suffix", ["svg", "inp"])
def test_some_formats_are_only_written(square, tmp_path, suffix):
    pardel.write(tmp_path / f"mesh.{suffix}", pardel.mesh(square))
    assert (tmp_path / f"mesh.{suffix}").stat().st_size > 100


def test_a_domain_is_the_same_after_it_was_written_and_read(tmp_path):
    points = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1 / 3)]
    segments = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)]
    domain = pardel.Domain(points, segments, regions=[(0.5, 0.5, 7, 0.1), (1.5, 0.5, 8, 0)], markers=range(7),
                           attributes=np.random.default_rng(3).random((6, 2)), point_markers=range(6))
    pardel.write(tmp_path / "domain.poly", domain)
    assert pardel.read(tmp_path / "domain.poly") == domain


def test_a_geometry_is_written_as_its_domain(tmp_path):
    field = {"type": "Polygon", "coordinates": [[(0, 0), (4, 0), (4, 4), (0, 0)]]}
    pardel.write(tmp_path / "field.poly", field)
    assert pardel.read(tmp_path / "field.poly") == pardel.geometry(field)


def test_a_domain_is_drawn(plate, tmp_path):
    pardel.write(tmp_path / "plate.svg", plate)
    assert "<svg" in (tmp_path / "plate.svg").read_text()


def test_markers_survive_a_file(square, tmp_path):
    pardel.write(str(tmp_path / "mesh.vtu"), pardel.mesh(square, max_edge=0.3))
    assert set(pardel.read(str(tmp_path / "mesh.vtu")).segment_markers) == {1, 2, 3, 4}


def test_a_msh_may_be_text(square, tmp_path):
    pardel.write(tmp_path / "mesh.msh", pardel.mesh(square), as_text=True)
    assert "$Nodes" in (tmp_path / "mesh.msh").read_text()


def test_triangles_may_have_six_nodes(square, tmp_path):
    made = pardel.mesh(square)
    pardel.write(tmp_path / "mesh.ele", made, second_order=True)
    first = (tmp_path / "mesh.ele").read_text().splitlines()[1].split()
    assert len(first) == 7
    assert len(pardel.read(tmp_path / "mesh.ele").points) == len(made.points)


def test_six_nodes_in_another_format_are_a_usage_error(square, tmp_path):
    with pytest.raises(pardel.UsageError):
        pardel.write(tmp_path / "mesh.off", pardel.mesh(square), second_order=True)


def test_arrays_are_written_without_a_domain(tmp_path):
    pardel.write(tmp_path / "two.node", ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)]))
    assert len(pardel.read(tmp_path / "two.ele").triangles) == 2


@pytest.mark.parametrize("name", ["none.poly", "none.vtu", "folder/none.msh"])
def test_a_file_that_is_missing_is_named(tmp_path, name):
    with pytest.raises(pardel.FileError, match=name) as caught:
        pardel.read(tmp_path / name)
    assert isinstance(caught.value, OSError)


def test_a_wrong_line_is_named(tmp_path):
    (tmp_path / "wrong.poly").write_text("3 2 0 0\n1 0 0\n2 1 zero\n3 1 1\n0 0\n0\n")
    with pytest.raises(pardel.InvalidInput, match=r"wrong.poly:3"):
        pardel.read(tmp_path / "wrong.poly")


def test_an_unknown_suffix_is_named(square, tmp_path):
    with pytest.raises(pardel.Error, match="mesh.xyz"):
        pardel.write(tmp_path / "mesh.xyz", pardel.mesh(square))


def test_a_folder_that_is_missing_is_a_file_error(square, tmp_path):
    with pytest.raises(pardel.FileError):
        pardel.write(tmp_path / "no" / "mesh.vtu", pardel.mesh(square))


def test_a_mesh_is_no_domain_and_a_domain_no_mesh(square, tmp_path):
    pardel.write(tmp_path / "mesh.vtu", pardel.mesh(square))
    pardel.write(tmp_path / "square.poly", square)
    with pytest.raises(pardel.UsageError, match="mesh.vtu is a mesh; a domain is needed"):
        pardel.mesh(tmp_path / "mesh.vtu")
    with pytest.raises(pardel.UsageError, match="square.poly is a domain; a mesh is needed"):
        pardel.refine(tmp_path / "square.poly")


@pytest.mark.parametrize("suffix", ["poly", "svg"])
def test_a_domain_saves_itself(plate, tmp_path, suffix):
    plate.save(tmp_path / f"saved.{suffix}")
    pardel.write(tmp_path / f"written.{suffix}", plate)
    assert (tmp_path / f"saved.{suffix}").read_bytes() == (tmp_path / f"written.{suffix}").read_bytes()


@pytest.mark.parametrize("name, suffix", [("d.vtu", ".vtu"), ("d", ""), ("d.POLY", ".POLY")])
def test_a_domain_in_a_format_of_meshes_is_a_usage_error(plate, tmp_path, name, suffix):
    for write in (plate.save, lambda path: pardel.write(path, plate)):
        with pytest.raises(pardel.UsageError, match=f"{name}: '{suffix}' is not a format of a domain; these are .poly"):
            write(tmp_path / name)
    assert list(tmp_path.iterdir()) == []
