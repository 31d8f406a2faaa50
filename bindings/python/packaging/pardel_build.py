"""Builds the wheel and the sdist of the Python package (PEP 517), with the standard library, CMake and Ninja only.

Settings (`pip install . -C NAME=VALUE`):
    build-dir=FOLDER    builds there, and keeps what was built; by default a temporary folder
    module=FILE         takes this compiled module instead of compiling it
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "bindings/python/pardel"
# What the build of the package needs of the repository.
IN_SDIST = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "pyproject.toml", "cmake", "core",
            "parallel", "off_the_shelf", "properties/CMakeLists.txt", "properties/checker", "properties/domains",
            "bindings/python/CMakeLists.txt", "bindings/python/packaging", "bindings/python/pardel",
            "bindings/python/src", "cli")


def version():
    return re.search(r"project\(pardel VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def metadata():
    project = (ROOT / "pyproject.toml").read_text()
    value = {key: re.search(rf'^{key} = "(.*)"$', project, re.M).group(1) for key in ("description", "requires-python")}
    return (f"Metadata-Version: 2.1\nName: pardel\nVersion: {version()}\nSummary: {value['description']}\n"
            f"License: Apache-2.0\nRequires-Python: {value['requires-python']}\nRequires-Dist: numpy>=1.21\n"
            f"Description-Content-Type: text/markdown\n\n{(ROOT / 'README.md').read_text()}")


def tag():
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{interpreter}-{interpreter}-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def run(*command):
    subprocess.run([str(part) for part in command], cwd=ROOT, check=True)


def compile_module(folder, build):
    """Compiles the module, and copies it to a folder."""
    run("cmake", "--preset", "python", "-B", build, "-DPARDEL_TEST_PYTHON=OFF", f"-DPython_EXECUTABLE={sys.executable}")
    run("cmake", "--build", build, "--target", "pardel_python")
    run("cmake", "--install", build, "--component", "python", "--prefix", folder, "--strip")


def files_in(package):
    """All files of a package and of the packages in it: their names in a wheel, and where they are."""
    return {"pardel/" + each.relative_to(package).as_posix(): each
            for each in package.rglob("*") if each.is_file() and "__pycache__" not in each.parts}


def files_of_package(folder, settings):
    """The files of the wheel: their names in it, and where they are."""
    if "module" in settings:
        module = pathlib.Path(settings["module"])
        found = files_in(PACKAGE) | {"pardel/" + module.name: module}
    else:
        build = settings.get("build-dir")
        with tempfile.TemporaryDirectory() as temporary:
            compile_module(folder, pathlib.Path(build).resolve() if build else temporary)
        found = files_in(folder / "pardel")
    return dict(sorted(found.items()))


def information():
    """The files in pardel-VERSION.dist-info, apart from the list of all files."""
    wheel = f"Wheel-Version: 1.0\nGenerator: pardel_build\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    return {"METADATA": metadata(), "WHEEL": wheel, "LICENSE": (ROOT / "LICENSE").read_text()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = f"pardel-{version()}.dist-info"
    os.makedirs(os.path.join(metadata_directory, info))
    for name, text in information().items():
        pathlib.Path(metadata_directory, info, name).write_text(text)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    info = f"pardel-{version()}.dist-info"
    name = f"pardel-{version()}-{tag()}.whl"
    record = []
    with tempfile.TemporaryDirectory() as folder, \
            zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        files = files_of_package(pathlib.Path(folder), config_settings or {})
        contents = {path: source.read_bytes() for path, source in files.items()}
        contents |= {f"{info}/{file}": text.encode() for file, text in information().items()}
        for path, content in contents.items():
            wheel.writestr(path, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{path},sha256={digest},{len(content)}\n")
        wheel.writestr(f"{info}/RECORD", "".join(record) + f"{info}/RECORD,,\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    base = f"pardel-{version()}"
    name = base + ".tar.gz"
    with tempfile.TemporaryDirectory() as folder, \
            tarfile.open(os.path.join(sdist_directory, name), "w:gz", format=tarfile.PAX_FORMAT) as sdist:
        information = pathlib.Path(folder) / "PKG-INFO"
        information.write_text(metadata())
        sdist.add(information, f"{base}/PKG-INFO")
        for part in IN_SDIST:
            sdist.add(ROOT / part, f"{base}/{part}",
                      filter=lambda entry: None if "__pycache__" in entry.name else entry)
    return name
