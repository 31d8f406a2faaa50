"""Makes a copy of the project that contains the mutants, and builds its tests."""
import concurrent.futures
import json
import pathlib
import re
import shlex
import shutil
import subprocess

from . import rewrite, sites

SCHEMATA = pathlib.Path(__file__).with_name("schemata.hpp")
MOST_BUILDS = 12
# The assertions of the standard library find places beyond the end of an array, as the presets dev and asan do.
FLAGS = "-O1 -DNDEBUG -D_GLIBCXX_ASSERTIONS"
# Tests of other things than the mutated folders, and tests with mutants of their own.
LEFT_OUT = {"mutants_test", "catalogue_test", "structure_test", "docs_test"}


def copy_project(root, source, without=()):
    """Copies the files that git knows or would add, except those below the folders `without`."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=root, check=True, capture_output=True)
    for name in filter(None, listed.stdout.decode().split("\0")):
        old, new = root / name, source / name
        if not old.is_file() or any(pathlib.Path(name).is_relative_to(folder) for folder in without):
            continue
        if not new.exists() or old.read_bytes() != new.read_bytes():
            new.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(old, new)


def configure(source, build, unity):
    """Little optimisation: the build takes longer than the tests. ccache serves what no mutant of a run changes."""
    options = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_CXX_FLAGS": "-std=c++20 -w", "CMAKE_CXX_FLAGS_RELEASE": FLAGS,
               "CMAKE_UNITY_BUILD": "ON" if unity else "OFF", "CMAKE_UNITY_BUILD_BATCH_SIZE": "10",
               "CMAKE_DISABLE_PRECOMPILE_HEADERS": "OFF" if unity else "ON"}
    if shutil.which("ccache"):
        options["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
    subprocess.run(["cmake", "-S", str(source), "-B", str(build), "-G", "Ninja",
                    *(f"-D{name}={value}" for name, value in options.items())], check=True, stdout=subprocess.DEVNULL)


def parse(task):
    entry, root, folders = task
    words = shlex.split(entry["command"])
    kept = [a for before, a in zip(words, words[1:]) if re.match(r"-I|-D|-std|-isystem", a) or before == "-isystem"]
    # clang has headers of its own, but omp.h is in another package. That of g++ has an attribute that clang lacks.
    of_gcc = subprocess.run(["g++", "-print-file-name=include"], check=True, capture_output=True, text=True).stdout
    kept += ["-idirafter", of_gcc.strip(), "-D__malloc__(x)=__malloc__"]
    return sites.find_sites(entry["file"], kept, root, folders)


def all_sites(source, build, folders, jobs):
    """The sites of all files below the folders, in the order of files and lines."""
    entries = {e["file"]: e for e in json.loads((build / "compile_commands.json").read_text())}
    wanted = [(e, source, folders) for file, e in entries.items()
              if any(pathlib.Path(file).is_relative_to(source / folder) for folder in folders)]
    found = {}
    with concurrent.futures.ProcessPoolExecutor(jobs) as pool:
        for result in pool.map(parse, wanted):
            for file in result:
                found.update({site.key(): site for site in result[file]})
    return [found[key] for key in sorted(found)]


def numbered(chosen):
    """(number of its first mutant, site) for each site."""
    result, number = [], 1
    for site in chosen:
        result.append((number, site))
        number += len(site.mutants)
    return result


def write_sources(root, source, pairs):
    files = {}
    for number, site in pairs:
        files.setdefault(site.file, []).append((number, site))
    for file in files:
        text = rewrite.with_mutants((root / file).read_bytes(), files[file])
        text = f'#include "{SCHEMATA}"\n#line 1\n'.encode() + text
        if (source / file).read_bytes() != text:
            (source / file).write_bytes(text)


def targets(build, rule):
    """The targets that a rule of CMake makes, such as CXX_EXECUTABLE_LINKER: {name: path below the build folder}."""
    command = ["ninja", "-C", str(build), "-t", "targets", "all"]
    listed = subprocess.run(command, check=True, capture_output=True, text=True)
    return {pathlib.Path(path).name: path for path in re.findall(rf"^(\S+): {rule}", listed.stdout, re.M)}


def test_programs(build):
    names = (name for name in targets(build, "CXX_EXECUTABLE_LINKER") if name.endswith("_test"))
    return sorted(set(names) - LEFT_OUT) + ["pardel"]


def libraries(build, folders):
    """The libraries below the folders, without the twins that have mutants of their own."""
    paths = targets(build, "CXX_STATIC_LIBRARY_LINKER").values()
    return [path for path in paths if any(pathlib.Path(path).is_relative_to(folder) for folder in folders)]


def run_ninja(build, names, jobs):
    command = ["ninja", "-C", str(build), "-k", "0", "-j", str(jobs), *names]
    return subprocess.run(command, capture_output=True, text=True)


def make(build, programs, jobs):
    """Builds the tests. There must be no error."""
    done = run_ninja(build, programs or test_programs(build), jobs)
    if done.returncode != 0:
        raise RuntimeError(f"the copy does not build:\n{done.stdout[-4000:]}")


def build_tests(root, source, build, pairs, args, log):
    """Builds the tests. Sites that do not compile are removed. Returns the sites that are left.

    The libraries come first. They name nearly all of these sites, and take less time than all tests.
    """
    # Without names, ninja would build everything: no library lies below a folder that is a part of one.
    steps = [names for names in (libraries(build, args.folders), args.programs or test_programs(build)) if names]
    for _ in range(MOST_BUILDS):
        write_sources(root, source, pairs)
        done = run_ninja(build, steps[0], args.jobs)
        if done.returncode == 0:
            steps.pop(0)
            if not steps:
                return pairs
            continue
        broken = broken_lines(done.stdout, source, build)
        left = [(n, s) for n, s in pairs if (s.file, s.line) not in broken]
        if len(left) == len(pairs):
            raise RuntimeError(f"the copy does not build:\n{done.stdout[-4000:]}")
        log(f"{len(pairs) - len(left)} sites do not compile")
        for file in {file for file, _ in broken}:
            if (root / file).is_file():
                (source / file).write_bytes((root / file).read_bytes())
        pairs = left
    raise RuntimeError("the copy does not build after the last attempt")


def broken_lines(output, source, build):
    """(file, line) of all places of the copy that the compiler names with an error."""
    places = set()
    for line in output.splitlines():
        match = re.match(r"(?:In file included from |\s+from )?([^\s:]+):(\d+)", line)
        if not match or not re.search(r" error: |required from|required by|in 'constexpr' expansion", line):
            continue
        path = (build / match[1]).resolve()
        if path.is_relative_to(source):
            places.add((str(path.relative_to(source)), int(match[2])))
    return places
