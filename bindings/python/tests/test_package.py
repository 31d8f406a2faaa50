"""The package builds, installs into an empty environment, has types, and its documentation is true."""

import doctest
import importlib
import os
import re
import shutil
import subprocess
import sys
import tarfile
import time
from pathlib import Path

import pytest

import pardel

SOURCE = Path(os.environ.get("PARDEL_SOURCE", Path(__file__).resolve().parents[3]))
MODULES = ("pardel", "pardel._mesh", "pardel.checking", "pardel.domain", "pardel.files", "pardel.generating",
           "pardel.geometry", "pardel.meshing", "pardel.pictures", "pardel.polygons", "pardel.raster",
           "pardel.simplices", "pardel.sources", "pardel.testing.certifying", "pardel.testing.families",
           "pardel.testing.meshes", "pardel.validation")


def run(*command, **options):
    ended = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


def without_drawing(test):
    """The test without the examples that need cairo, if the package was built without it."""
    if not hasattr(pardel._pardel, "Picture"):
        test.examples = [each for each in test.examples if not re.match(r"(pardel\.)?draw\(", each.source)]
    return test


def run_examples(tests):
    """The numbers of examples that failed, and of those that ran."""
    runner = doctest.DocTestRunner()
    for test in tests:
        runner.run(without_drawing(test))
    return runner.summarize(verbose=False)


def examples_of_the_page():
    page = SOURCE / "docs/python.md"
    return [doctest.DocTestParser().get_doctest(page.read_text(), {}, page.name, str(page), 0)]


@pytest.mark.parametrize("name", MODULES)
def test_the_examples_of_docstrings_are_true(name):
    failed, tried = run_examples(doctest.DocTestFinder().find(importlib.import_module(name)))
    assert failed == 0 and (tried > 0 or name == "pardel.pictures")


def test_the_examples_of_the_page_are_true(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    failed, tried = run_examples(examples_of_the_page())
    assert tried > 10 and failed == 0


def test_without_cairo_the_examples_of_drawings_do_not_run(monkeypatch):
    monkeypatch.delattr(pardel._pardel, "Picture", raising=False)
    test_the_examples_of_docstrings_are_true("pardel.pictures")
    (page,) = examples_of_the_page()
    all = [each.source for each in page.examples]
    rest = [each.source for each in without_drawing(page).examples]
    assert rest == [each for each in all if "pardel.draw(" not in each] != all


def test_every_public_name_has_a_docstring():
    assert all(getattr(pardel, name).__doc__ for name in pardel.__all__ if name != "__version__")
    for cls in (pardel.Mesh, pardel.Domain, pardel.Simplices):
        assert all(value.__doc__ for name, value in vars(cls).items() if not name.startswith("_"))


def test_every_public_name_is_on_the_page():
    page = (SOURCE / "docs/python.md").read_text()
    assert [name for name in pardel.__all__ if name[0] != "_" and not re.search(rf"\b{name}\b", page)] == []


def test_the_package_prints_nothing_and_does_not_end_the_process():
    folder = SOURCE / "bindings/python"
    sources = [path.read_text() for path in [*folder.glob("[ps]*/*.[pc]*"), *folder.glob("pardel/*/**/*.py")]]
    code = re.sub(r">>> .*|\.\.\. .*", "", "\n".join(sources))
    assert not re.search(r"\bprint\(|\bexit\(|std::cerr|std::cout|printf", code.replace("for problem in", ""))


def test_the_version_is_that_of_the_project():
    project = (SOURCE / "CMakeLists.txt").read_text()
    assert f"project(pardel VERSION {pardel.__version__} " in project


@pytest.fixture(scope="module")
def mypy(tmp_path_factory):
    """Runs mypy; the runs share what they have found out about NumPy."""
    if shutil.which("mypy") is None:
        pytest.skip("mypy is not installed")
    folder = tmp_path_factory.mktemp("mypy")
    environment = {**os.environ, "MYPYPATH": str(SOURCE / "bindings/python")}
    return lambda *arguments: subprocess.run(["mypy", "--strict", "--cache-dir", str(folder), *map(str, arguments)],
                                             capture_output=True, text=True, cwd=folder, env=environment)


def test_the_types_are_right(mypy):
    ended = mypy("-p", "pardel")
    assert ended.returncode == 0, ended.stdout


def test_wrong_types_of_a_caller_are_found(mypy, tmp_path):
    script = tmp_path / "caller.py"
    script.write_text("import pardel\nmade: int = pardel.mesh([(0.0, 0.0)], min_angle=20).points\n")
    assert 'expression has type "ndarray' in mypy(script).stdout


def unpacked_sdist(folder):
    backend = SOURCE / "bindings/python/packaging"
    build = f"import sys; sys.path.insert(0, {str(backend)!r}); import pardel_build; "
    name = run(sys.executable, "-B", "-c", f"{build}print(pardel_build.build_sdist({str(folder)!r}))").strip()
    with tarfile.open(folder / name) as sdist:
        sdist.extractall(folder)
    return folder / name.removesuffix(".tar.gz")


def test_the_sdist_has_all_that_its_build_needs(tmp_path):
    root = unpacked_sdist(tmp_path)
    missing = []
    for source in [*root.rglob("*.cpp"), *root.rglob("*.hpp")]:
        for name in re.findall(r'^#include "(.+)"$', source.read_text(), re.M):
            if not (source.parent / name).exists():
                missing.append((str(source), name))
        for name in re.findall(r"^#include <pardel/(.+)>$", source.read_text(), re.M):
            if not (root / name).exists() and name != "pardel.hpp":
                missing.append((str(source), name))
    assert missing == [] and len(list(root.rglob("*.cpp"))) > 100


def empty_environment(folder):
    """The environment has pip and NumPy of the system, and nothing else."""
    run(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", folder)
    return folder / "bin/python"


def check_installed(python, folder):
    """The package in an environment is used, from a folder without sources, and leaves with pip."""
    program = ("import pardel; made = pardel.mesh([(0, 0), (1, 0), (0, 1)], max_area=0.01); "
               "print(pardel.check([(0, 0), (1, 0), (0, 1)], made).valid, pardel.__file__, pardel.__version__)")
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    valid, file, version = run(python, "-c", program, cwd=folder, env=environment).split()
    assert valid == "True" and Path(file).is_relative_to(python.parents[1]) and version == pardel.__version__
    installed = Path(file).parent
    assert (installed / "py.typed").exists() and (installed / "_pardel.pyi").exists()
    run(python, "-c", "import pardel.compat.triangle as tr; tr.triangulate(tr.get_data('A'), 'pq')", cwd=folder,
        env=environment)
    assert (installed / "testing/certifying.py").exists()
    run(python, "-m", "pip", "uninstall", "--yes", "pardel", cwd=folder, env=environment)
    assert not (installed / "__init__.py").exists()


def install(python, root, folder, *settings):
    """Without a network."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    run(python, "-m", "pip", "install", "--no-index", *settings, root, cwd=folder, env=environment)


def test_the_sdist_installs_into_an_empty_environment(tmp_path):
    (module,) = Path(os.environ.get("PARDEL_PACKAGE", Path(pardel.__file__).parent)).glob("_pardel.*.so")
    python = empty_environment(tmp_path / "environment")
    install(python, unpacked_sdist(tmp_path), tmp_path, "--config-settings", f"module={module}")
    check_installed(python, tmp_path)


@pytest.mark.skipif("PARDEL_COMPILE_WHEEL" not in os.environ, reason="it takes minutes; PARDEL_COMPILE_WHEEL=1 runs it")
def test_the_sdist_compiles_and_installs_into_an_empty_environment(tmp_path):
    python = empty_environment(tmp_path / "environment")
    start = time.monotonic()
    install(python, unpacked_sdist(tmp_path), tmp_path)
    print(f"{time.monotonic() - start:.0f} s")
    check_installed(python, tmp_path)
