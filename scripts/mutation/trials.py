"""Runs the tests that evaluate a mutant, until one of them fails."""
import collections
import concurrent.futures
import contextlib
import dataclasses
import json
import os
import pathlib
import re
import resource
import signal
import stat
import subprocess
import tempfile
import threading

LEFT_OUT_LABELS = {"mutants", "docs", "examples", "install", "harness"}
MOST_MEMORY = 6 << 30  # bytes per process
CHUNK = 1.0  # seconds of the tests that run in one process
START = 0.02  # seconds until a process runs
FAVOURITES = 3  # tests that come first because they noticed other mutants of the function, of the file, of all files
KILLED_BY_LIMIT = -9


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
    seconds: float = 0  # of processor time
    cases: int = 0  # of a property; 0: as many as usual
    mutants: int = 0  # that the test evaluates


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


def settings(cases):
    """The seed is fixed, and RapidCheck does not look for a smaller counterexample."""
    parameters = "noshrink=1 seed=1" + (f" max_success={cases}" if cases else "")
    return {"RC_PARAMS": parameters, "OMP_WAIT_POLICY": "passive"}


def begin(seconds):
    """In the process of a test. A process that a shell started in the background ignores interrupts; no test does."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))


def kill_group(leader):
    with contextlib.suppress(ProcessLookupError):
        os.killpg(leader, 9)


def restore_devices():
    """If root runs the tests, a mutant can put a regular file in the place of a device. Later tests would then fail."""
    for name, minor in (("full", 7), ("null", 3), ("zero", 5)):
        device = pathlib.Path("/dev", name)
        if not device.is_char_device():
            device.unlink(missing_ok=True)
            os.mknod(device, stat.S_IFCHR, os.makedev(1, minor))
            device.chmod(0o666)


def run(tests, seconds, variables):
    """Runs tests of one program, for at most so many seconds of processor time: (exit code, output, seconds).

    On a busy computer no test fails for that reason. A test that waits and does not compute is stopped after some time.
    """
    program, filters, limit = tests[0].program, [t.filter for t in tests if t.filter], int(seconds) + 1
    command = list(program.command)
    if filters:
        command += ["--gtest_filter=" + ":".join(filters), "--gtest_fail_fast"]
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(command, cwd=program.folder, env=os.environ | settings(tests[0].cases) | variables,
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                   start_new_session=True, preexec_fn=lambda: begin(limit))
        timer = threading.Timer(60 + 10 * seconds, kill_group, (process.pid,))
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        kill_group(process.pid)
        restore_devices()
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        return process.returncode, output.read().decode(errors="replace"), usage.ru_utime + usage.ru_stime


@dataclasses.dataclass
class Trace:
    seconds: float
    reached: list  # the numbers of the mutants that a test evaluates
    passed: bool
    cases: int


def trace(test, cases):
    """Runs a test without a mutant. A property that fails because it has few cases gets the usual number."""
    for number in (cases, 0) if cases else (0,):
        with tempfile.TemporaryDirectory() as folder:
            code, _, seconds = run([dataclasses.replace(test, cases=number)], 100, {"PARDEL_MUTATION_TRACE": folder})
            reached = {int(line) for file in pathlib.Path(folder).iterdir() for line in file.read_text().split()}
        if code == 0:
            break
    return Trace(seconds, sorted(reached), code == 0, number)


def stamp(test, cases):
    """Changes when a test has to be traced again."""
    files = [pathlib.Path(word) for word in test.program.command]
    return test.name, cases, tuple(file.stat().st_mtime_ns for file in files if file.is_file())


def trace_all(tests, cases, known, jobs):
    """Traces the tests that are not in `known`, and adds them to it."""
    waiting = [test for test in tests if stamp(test, cases) not in known]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for test, result in zip(waiting, pool.map(lambda test: trace(test, cases), waiting)):
            known[stamp(test, cases)] = result


def tests_of_mutants(tests, cases, traces):
    """The tests of each mutant, and the tests that fail without a mutant."""
    reaching, failing = collections.defaultdict(list), []
    for test in tests:
        result = traces[stamp(test, cases)]
        if not result.passed:
            failing.append(test.name)
            continue
        traced = dataclasses.replace(test, seconds=result.seconds, cases=result.cases, mutants=len(result.reached))
        for number in result.reached:
            reaching[number].append(traced)
    return reaching, failing


class Killers:
    """Which tests noticed how many mutants of a function, of a file, and of all files."""

    def __init__(self):
        self.counts = collections.defaultdict(collections.Counter)

    @staticmethod
    def places(site):
        return (site.file, site.function), site.file, ""

    def add(self, site, test):
        for place in self.places(site):
            self.counts[place][test] += 1

    def favourites(self, site, tests):
        """Tests that are likely to notice a mutant, the most likely ones first."""
        by_name, found = {t.filter or t.name: t for t in tests}, {}
        for place in self.places(site):
            names = [name for name, _ in self.counts[place].most_common() if name in by_name and name not in found]
            found |= {name: by_name[name] for name in names[:FAVOURITES]}
        return list(found.values())


def distance(test):
    """Small for quick tests and for tests of a small part of the sources, which are likely to notice its mutants."""
    return test.mutants * (START + test.seconds)


def chunks(tests):
    """Lists of tests of one program that take a second together, or one test that takes longer; the nearest first."""
    groups, result = collections.defaultdict(list), []
    for test in sorted(tests, key=distance):
        group = groups[test.program, test.cases]
        if group and sum(t.seconds for t in group) + test.seconds > CHUNK:
            result.append(group)
            group = groups[test.program, test.cases] = []
        group.append(test)
    return sorted([*result, *groups.values()], key=lambda group: distance(group[0]))


def in_order(site, tests, killers):
    """The chunks of the tests in the order in which a mutant meets them."""
    first = killers.favourites(site, tests)
    return [[test] for test in first] + chunks([test for test in tests if test not in first])


def failed_test(output, group):
    match = re.search(r"\[  FAILED  \] ([^\s,]+)", output)
    return match[1] if match else group[0].filter or group[0].name


def try_mutant(number, groups, most_seconds=float("inf")):
    """How a mutant ends: (result, the test that noticed it, seconds). After `most_seconds` it is not decided."""
    used = 0
    for group in groups:
        if used > most_seconds:
            return "not decided", "", used
        limit = 2 + 5 * sum(test.seconds for test in group)
        code, output, seconds = run(group, limit, {"PARDEL_MUTATION": str(number)})
        used += seconds
        if code == 1:
            return "failed", failed_test(output, group), used
        if code != 0:
            running = re.findall(r"\[ RUN      \] (\S+)", output) or [group[0].filter or group[0].name]
            return "time-out" if code == KILLED_BY_LIMIT else "crashed", running[-1], used
    return ("survived" if groups else "never evaluated"), "", used
