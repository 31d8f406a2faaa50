"""Runs of AFL++ on one target: how afl-fuzz is called, and what it leaves in its folder."""
import hashlib
import shutil
import subprocess
from pathlib import Path

from . import programs
from .script import Stop

STATISTICS = ("execs_done", "execs_per_sec", "edges_found", "corpus_count", "saved_crashes", "saved_hangs")


def build_mutator(folder):
    """Compiles the mutator of strokes, a library that afl-fuzz loads, without instrumentation."""
    sources = [programs.ROOT / "fuzz" / name for name in ("mutate_strokes.cpp", "afl_mutator.cpp")]
    subprocess.run(["clang++-14", "-std=c++20", "-O2", "-shared", "-fPIC", "-I", folder / "include", *sources,
                    "-o", folder / "mutate_strokes.so"], check=True)


def mutator(folder, target):
    """The library with the mutator of a target; None if it has none. Raises Stop if it has not been built."""
    library = folder / "mutate_strokes.so"
    if target.has_strokes and not library.exists():
        raise Stop(f"{library} is missing; without --no-build it is made")
    return library if target.has_strokes else None


def environment(library):
    """AFL++ sets the options of the sanitizers itself. Its screen, and its questions about the machine, are off."""
    result = programs.environment(AFL_NO_UI="1", AFL_SKIP_CPUFREQ="1", AFL_NO_AFFINITY="1", AFL_QUIET="1",
                                  AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES="1")
    for name in ("ASAN_OPTIONS", "UBSAN_OPTIONS"):
        del result[name]
    if library:
        result["AFL_CUSTOM_MUTATOR_LIBRARY"] = str(library)
    return result


def run(target, corpus, folder, seconds, seed, library, children):
    """Runs afl-fuzz, one of the children, for so many seconds, or until it gets SIGTERM. Its files are then in the
    folder `default` of `folder`. Raises Stop."""
    folder.mkdir(parents=True)
    inputs = corpus
    if not (corpus.is_dir() and any(corpus.iterdir())):
        inputs = folder / "inputs"
        inputs.mkdir()
        (inputs / "empty").write_bytes(b"\n")  # afl-fuzz needs an input
    command = ["afl-fuzz", "-V", str(seconds), "-s", str(seed), "-m", "none", "-t", "30000",
               "-G", str(target.longest), "-i", str(inputs), "-o", str(folder)]
    if target.dictionary.exists():
        command += ["-x", str(target.dictionary)]
    with open(folder / "log", "wb") as log:
        child = children.start([*command, "--", target.program()], stdout=log, stderr=subprocess.STDOUT,
                               env=environment(library))
    child.wait()
    if child.returncode != 0 or not (folder / "default" / "fuzzer_stats").exists():
        said = (folder / "log").read_text(errors="replace")
        raise Stop(f"{' '.join(command)} ended with exit code {child.returncode}\n{said[-2000:]}")


def statistics(folder):
    """The figures of a run. Those of a run that ended before it had any are zero."""
    lines = (folder / "default" / "fuzzer_stats").read_text().splitlines()
    read = dict(line.split(":", 1) for line in lines if ":" in line)
    read = {name.strip(): value.strip() for name, value in read.items()}
    return {name: (float if name == "execs_per_sec" else int)(read.get(name, 0)) for name in STATISTICS}


def new_inputs(folder):
    """The inputs that the run added to its queue."""
    return [file for file in sorted((folder / "default" / "queue").glob("id:*")) if ",orig:" not in file.name]


def failing_inputs(folder):
    return [file for kind in ("crashes", "hangs") for file in sorted((folder / "default" / kind).glob("id:*"))]


def output_of(failing):
    """What finds.record() takes for the output of the fuzzer: AFL++ keeps none."""
    return "ERROR: libFuzzer: timeout" if failing.parent.name == "hangs" else ""


def give(inputs, corpus):
    """Copies inputs to a corpus. Their names there are their hashes, as libFuzzer names them."""
    corpus.mkdir(parents=True, exist_ok=True)
    for file in inputs:
        shutil.copy(file, corpus / hashlib.sha1(Path(file).read_bytes()).hexdigest())
