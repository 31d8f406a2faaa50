"""The history of measurements: bench/history/workloads.csv, one line per commit and workload."""
import csv
import io
import os
import platform

import safe_files

from . import commits
from .command import Failed

FILE = os.path.join(commits.ROOT, "bench", "history", "workloads.csv")
# A workload on n > 1 threads is NAME/threads:n. Instructions are those of the counted size; the other columns are of
# the timed size. `seconds`: once.seconds(). `items` are triangles, or evaluations of predicates, or inserted points. A
# value that was not measured is empty. `bytes` is the largest memory of the work; for the tables of bench/scaling and
# bench/paper_tables that of the process. `digest` is the first half of the digest of the mesh.
COLUMNS = ["commit", "compiler", "machine", "workload", "instructions", "items", "seconds", "bytes", "cycles", "digest"]
NUMBERS = {"instructions": int, "items": int, "seconds": float, "bytes": int, "cycles": int}
SHORT_COMMIT, SHORT_DIGEST = 12, 16


def machine():
    """The processor, and how many there are."""
    about = {}
    try:
        with open("/proc/cpuinfo") as lines:
            for line in lines:
                key, _, value = line.partition(":")
                about.setdefault(key.strip(), value.strip())
    except OSError:
        pass
    model = about.get("model name", platform.machine())
    return f"{model} {about.get('cpu family', '?')}/{about.get('model', '?')} x {os.cpu_count()}".replace(",", " ")


def read(file=None):
    """The rows of a file, or of FILE; none if there is no such file."""
    file = file or FILE
    if not os.path.exists(file):
        return []
    with open(file, newline="", errors="replace") as text:
        lines = list(csv.reader(text))
    for number, fields in enumerate(lines or [[]], 1):
        if fields != COLUMNS if number == 1 else len(fields) != len(COLUMNS) or not are_numbers(fields):
            raise Failed(f"{file}:{number}: this is not a row of {', '.join(COLUMNS)}")
    return [dict(zip(COLUMNS, fields)) for fields in lines[1:]]


def are_numbers(fields):
    """Is every field of a row that has to be a number above 0 one, or empty?"""
    try:
        return all(0 < NUMBERS[name](text) < float("inf")
                   for name, text in zip(COLUMNS, fields) if name in NUMBERS and text)
    except ValueError:
        return False


def merged(old, new):
    """Both lists. A new row replaces the one of the same commit, workload, compiler and machine, and the one of an
    unknown machine; what it does not have it takes from these."""
    def key(row, machine_of=lambda row: row["machine"]):
        return row["commit"], row["workload"], row["compiler"], machine_of(row)
    present = {key(row): row for row in old}
    taken, completed = set(), []
    for row in new:
        for each in (key(row), key(row, lambda _: "")):
            if each in present and each not in taken:
                taken.add(each)
                row = {name: row[name] or present[each][name] for name in COLUMNS}
        completed.append(row)
    return [row for row in old if key(row) not in taken] + completed


def in_order(rows, line):
    """In the order of the commits of a branch, then by workload. Other commits come first."""
    place = {commit[:SHORT_COMMIT]: i for i, commit in enumerate(line)}
    return sorted(rows, key=lambda row: (place.get(row["commit"], -1), row["commit"], row["workload"]))


def write(rows, file=None):
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    safe_files.replace(file or FILE, text.getvalue())


def row(commit, compiler, workload, **values):
    """A row of this machine."""
    digest = values.pop("digest", None) or ""
    known = {name: "" if value is None else value for name, value in values.items()}
    return {**dict.fromkeys(COLUMNS, ""), "commit": commit[:SHORT_COMMIT], "compiler": compiler, "machine": machine(),
            "workload": workload, "digest": digest[:SHORT_DIGEST], **known}


def series(rows, line, value, of=lambda row: True):
    """For each workload its values in the order of the branch: lists of (place in `line`, number, row).
    value: computes the number of a row; rows where it is None, and commits of other branches, are left out. Of two rows
    of one commit, from two machines, the last one counts."""
    place = {commit[:SHORT_COMMIT]: i for i, commit in enumerate(line)}
    found = {}
    for each in in_order(rows, line):
        number = value(each)
        if number is not None and each["commit"] in place and of(each):
            points = found.setdefault(each["workload"], [])
            if points and points[-1][0] == place[each["commit"]]:
                points.pop()
            points.append((place[each["commit"]], number, each))
    return found


def instructions(row):
    return int(row["instructions"]) if row["instructions"] else None


def items_per_second(row):
    return int(row["items"]) / float(row["seconds"]) if row["seconds"] and row["items"] else None


def changes(points, least):
    """The steps between neighbouring points whose share is at least `least`: (share, point before, point after)."""
    steps = [(after[1] / before[1] - 1, before, after) for before, after in zip(points, points[1:])]
    return [step for step in steps if abs(step[0]) >= least]
