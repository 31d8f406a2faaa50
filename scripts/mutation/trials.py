"""Runs the tests that evaluate a mutant, until one of them fails."""
import collections
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import time

LEFT_OUT_LABELS = {"mutants", "docs", "examples", "install", "harness"}
MOST_MEMORY = 6 << 30  # bytes per process
# The seed is fixed, and RapidCheck does not look for a smaller counterexample.
SETTINGS = {"RC_PARAMS": "noshrink=1 seed=1", "OMP_WAIT_POLICY": "passive"}


@dataclasses.dataclass(frozen=True)
class Program:
    """A test program, or a single test that is not one of GoogleTest."""
    command: tuple
    folder: str


@dataclasses.dataclass
class Test:
    name: str
    program: Program
    filter: str  # empty if the program is one test
    seconds: float = 0


def all_tests(build):
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, check=True, capture_output=True, text=True)
    tests = []
    for entry in json.loads(listed.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in entry.get("properties", [])}
        if "command" not in entry or LEFT_OUT_LABELS & set(properties.get("LABELS", [])):
            continue
        command, filters = [], ""
        for word in entry["command"]:
            if word.startswith("--gtest_filter="):
                filters = word.partition("=")[2]
            elif word != "--gtest_also_run_disabled_tests":
                command.append(word)
        variables = properties.get("ENVIRONMENT", [])
        program = Program(("env", *variables, *command), properties.get("WORKING_DIRECTORY", str(build)))
        if pathlib.Path(command[0]).exists():
            tests.append(Test(entry["name"], program, filters))
    return tests


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def run(program, filters, seconds, variables):
    """(exit code or None after the time limit, output)."""
    command = list(program.command)
    if filters:
        command += ["--gtest_filter=" + ":".join(filters), "--gtest_fail_fast"]
    process = subprocess.Popen(command, cwd=program.folder, env=os.environ | SETTINGS | variables, text=True,
                               errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True, preexec_fn=limit_memory)
    try:
        output = process.communicate(timeout=seconds)[0]
        return process.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.communicate()
        return None, ""


def trace(test):
    """Runs a test without a mutant. Returns (seconds, the numbers of the mutants that it evaluates, passed)."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        code, _ = run(test.program, [test.filter] if test.filter else [], 600, {"PARDEL_MUTATION_TRACE": folder})
        seconds = time.monotonic() - start
        reached = {int(line) for file in pathlib.Path(folder).iterdir() for line in file.read_text().split()}
        return seconds, sorted(reached), code == 0


def trace_all(tests, jobs):
    """The tests of each mutant, and the tests that fail without a mutant."""
    reaching, failing = collections.defaultdict(list), []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for test, (seconds, reached, passed) in zip(tests, pool.map(trace, tests)):
            test.seconds = seconds
            if not passed:
                failing.append(test.name)
                continue
            for number in reached:
                reaching[number].append(test)
    return reaching, failing


def by_program(tests):
    """The tests of each program, the quickest programs first."""
    groups = collections.defaultdict(list)
    for test in tests:
        groups[test.program].append(test)
    return sorted(groups.values(), key=lambda group: sum(test.seconds for test in group))


def failed_test(output, group):
    match = re.search(r"\[  FAILED  \] ([^\s,]+)", output)
    return match[1] if match else group[0].name


def try_mutant(number, tests):
    """How a mutant ends: (result, the test that noticed it). The results: failed, crashed, time-out, survived."""
    for group in by_program(tests):
        limit = 10 + 5 * sum(test.seconds for test in group)
        code, output = run(group[0].program, [t.filter for t in group if t.filter], limit,
                           {"PARDEL_MUTATION": str(number)})
        if code is None:
            return "time-out", group[0].name
        if code == 1:
            return "failed", failed_test(output, group)
        if code != 0:
            running = re.findall(r"\[ RUN      \] (\S+)", output)
            return "crashed", running[-1] if running else group[0].name
    return "survived", ""
