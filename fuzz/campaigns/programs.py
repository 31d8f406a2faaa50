"""The fuzz programs of a build: their names, how they are built, and how libFuzzer is called."""
import os
import re
import sys
from pathlib import Path

import process_groups

from .script import Stop

ROOT = Path(__file__).resolve().parents[2]
CORPUS = ROOT / "fuzz" / "corpus"
DICTIONARIES = ROOT / "fuzz" / "dictionaries"

# The longest input. Strokes: a header of 32 bytes and 24 strokes of 8 bytes. Files: also a small mesh in two pieces.
LONGEST = {"mutate_strokes.cpp": 224, "mutate_files.cpp": 4096, "": 256}
SMALL = {"checker": 72, "triangulation": 72}  # they use the first five strokes (decode_small_case)


class Target:
    """One fuzz target. `mutator` is the source that changes its inputs, or empty."""

    def __init__(self, name, mutator, folder):
        self.name = name
        self.mutator = mutator
        self.folder = folder

    @property
    def has_strokes(self):
        """Does the input consist of a header and strokes of a domain (mesh_case.hpp)?"""
        return self.mutator == "mutate_strokes.cpp"

    @property
    def draws(self):
        """Is the input a domain that draw_case can draw?"""
        return self.has_strokes or self.name == "reference"

    @property
    def longest(self):
        """The most bytes of an input."""
        return SMALL.get(self.name, LONGEST[self.mutator])

    @property
    def committed(self):
        return CORPUS / self.name

    @property
    def dictionary(self):
        return DICTIONARIES / f"{self.name}.dict"

    def program(self, mutated=False):
        return self.folder / f"fuzz_{self.name}{'_mutated' if mutated else ''}"

    @property
    def replay(self):
        return self.folder / f"replay_{self.name}"

    def command(self, *arguments, mutated=False):
        """The libFuzzer program with the options of this target."""
        command = [str(self.program(mutated)), f"-max_len={self.longest}", "-timeout=30",
                   "-rss_limit_mb=3000", "-malloc_limit_mb=1000", "-len_control=0", "-print_final_stats=1"]
        if not self.has_strokes:
            # The values that are compared guide the search in files. In a mesh nearly every value is new.
            command.append("-use_value_profile=1")
        if self.dictionary.exists():
            command.append(f"-dict={self.dictionary}")
        return command + [str(a) for a in arguments]


def environment(**more):
    """One thread, but for the targets that ask for more. Waiting threads sleep: they may be more than the cores."""
    result = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1",
                  UBSAN_OPTIONS="print_stacktrace=1", **more)
    result["ASAN_OPTIONS"] = "detect_leaks=0:handle_abort=1"
    return result


def targets(build):
    """The targets of a build folder, in the order of fuzz/CMakeLists.txt. Raises Stop if there are none."""
    folder = (Path(build) / "fuzz").resolve()  # slices work in folders of their own
    found = []
    for line in (folder / "targets").read_text().splitlines():
        name, _, mutator = line.strip().partition(" ")
        if mutator not in LONGEST:
            raise Stop(f"{folder / 'targets'}: the mutator '{mutator}' is unknown")
        found += [Target(name, mutator, folder)] if name else []
    if not found:
        raise Stop(f"{folder / 'targets'}: there is no target")
    return found


def chosen(targets, names):
    """The targets whose names are in a text, separated by commas; all of them if it is empty. Raises Stop for a wrong
    name."""
    wanted = [word for word in names.split(",") if word]
    unknown = set(wanted) - {t.name for t in targets}
    if unknown:
        raise Stop(f"there is no target {', '.join(sorted(unknown))}; the targets are "
                   + ", ".join(t.name for t in targets))
    return [t for t in targets if not wanted or t.name in wanted]


def check_path(path):
    """Raises Stop for a path that libFuzzer cannot use when it minimises a corpus. It starts itself by a shell then,
    without quotes."""
    if wrong := re.search(r"[^\w@%+=:,./-]", str(path)):
        raise Stop(f"{path}: libFuzzer cannot minimise corpora where a path contains '{wrong.group()}'")


def needed(targets):
    """The programs that a campaign of these targets starts."""
    found = [program for target in targets for program in (target.program(), target.replay)]
    return found + [target.folder / "draw_case" for target in targets if target.draws][:1]


def cmake(*arguments):
    """Runs CMake. What it prints goes to standard error: standard output is for the results of a script."""
    process_groups.run(["cmake", *arguments], cwd=ROOT, stdout=sys.stderr).check_returncode()


def configure(folder, preset="fuzz"):
    """Configures a preset. Then the build folder has the present list of the targets."""
    cmake("--preset", preset, "-B", str(folder))


def build(folder, goals, jobs, preset="fuzz"):
    """Configures a preset if necessary and builds CMake targets of it."""
    if not (Path(folder) / "CMakeCache.txt").exists():
        configure(folder, preset)
    cmake("--build", str(folder), "-j", str(jobs), "--target", *goals)
