"""Runs of the program bench/workloads/once.cpp, which runs one workload once."""
import concurrent.futures
import json
import os
import re
import tempfile

from .command import Failed, output

LONGEST = 150  # characters of the name of a function


def workloads(program, kind=None):
    """The names of all workloads; or of those of a kind, `gate` or `threads`."""
    lines = [line.split() for line in output(program).splitlines()]
    return [words[0] for words in lines if kind is None or kind in words[1:]]


def run(program, workload, threads=1, timed=True, twice=False):
    """What the program prints about one run, as a dictionary."""
    options = ["--threads", threads] + ["--timed"] * timed + ["--twice"] * twice
    with tempfile.TemporaryDirectory() as folder:  # a run that is killed leaves its files there
        return json.loads(output(program, workload, *options, threads=threads, TMPDIR=folder))


def seconds(result):
    """The time of a run, from what the program printed: of the processor on one thread, because other work on the
    machine hardly changes it; of the clock on several threads, which also shows how long they wait."""
    return result["cpu_seconds"] if result["threads"] == 1 else result["seconds"]


def counts_by_function(lines):
    """The instructions that each function executed itself, from the lines of a file of callgrind. A name is written out
    where it first appears, and later only its number. The line after "calls=" is about the called function."""
    names, counts, function, is_call = {}, {}, None, False
    for line in lines:
        named = re.match(r"(c?fn)=\((\d+)\)(?: (.*))?$", line)
        if named:
            kind, number, name = named.groups()
            if name:
                names[number] = name.rstrip()[:LONGEST]
            if kind == "fn":
                function = names[number]
        elif line.startswith("calls="):
            is_call = True
        elif re.match(r"[\d+*-]", line):
            if not is_call:
                counts[function] = counts.get(function, 0) + int(line.split()[-1])
            is_call = False
    return counts


def count(program, workload, waste=0):
    """The instructions of a workload by function, on one thread."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "counts")
        output("valgrind", "--tool=callgrind", "--collect-atstart=no", f"--callgrind-out-file={out}", program, workload,
               *(["--waste", waste] if waste else []), TMPDIR=folder)
        with open(out) as lines:
            counts = counts_by_function(lines)
    if not counts:
        raise Failed(f"{program} {workload}: valgrind counted nothing; was it compiled without valgrind/callgrind.h?")
    return counts


def count_all(program, names, waste=None):
    """The counts of several workloads. waste: instructions to add, by workload."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        try:
            runs = {name: pool.submit(count, program, name, waste[name] if waste else 0) for name in names}
            return {name: each.result() for name, each in runs.items()}
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def total(functions):
    return sum(functions.values())
