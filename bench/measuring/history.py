"""The history of measurements: bench/history/workloads.csv, one line per commit and workload."""
import csv
import os
import platform

from . import commits

FILE = os.path.join(commits.ROOT, "bench", "history", "workloads.csv")
# A workload on n > 1 threads is NAME/threads:n. Instructions are those of the counted size; the other columns are of
# the timed size. `seconds`: once.seconds(). `items` are triangles, or evaluations of predicates, or inserted points. A
# value that was not measured is empty. `bytes` is the largest memory of the work; for the tables of bench/scaling and
# bench/paper_tables that of the process. `digest` is the first half of the digest of the mesh.
COLUMNS = ["commit", "compiler", "machine", "workload", "instructions", "items", "seconds", "bytes", "cycles", "digest"]
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


def read(file=FILE):
    if not os.path.exists(file):
        return []
    with open(file, newline="") as rows:
        return list(csv.DictReader(rows))


def merged(old, new):
    """Both lists, in which a new row replaces the one of the same commit, workload, compiler and machine, and the one
    of an unknown machine."""
    def key(row, machine_of=lambda row: row["machine"]):
        return row["commit"], row["workload"], row["compiler"], machine_of(row)
    replaced = {key(row) for row in new} | {key(row, lambda _: "") for row in new}
    return [row for row in old if key(row) not in replaced] + new


def in_order(rows, line):
    """In the order of the commits of a branch, then by workload. Other commits come first."""
    place = {commit[:SHORT_COMMIT]: i for i, commit in enumerate(line)}
    return sorted(rows, key=lambda row: (place.get(row["commit"], -1), row["commit"], row["workload"]))


def write(rows, file=FILE):
    os.makedirs(os.path.dirname(file), exist_ok=True)
    with open(file, "w", newline="") as out:
        writer = csv.DictWriter(out, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def row(commit, compiler, workload, **values):
    """A row of this machine."""
    digest = values.pop("digest", None) or ""
    known = {name: "" if value is None else value for name, value in values.items()}
    return {**dict.fromkeys(COLUMNS, ""), "commit": commit[:SHORT_COMMIT], "compiler": compiler, "machine": machine(),
            "workload": workload, "digest": digest[:SHORT_DIGEST], **known}


def series(rows, line, value, of=lambda row: True):
    """For each workload its values in the order of the branch: lists of (place in `line`, number, row).
    value: computes the number of a row; rows where it is None, and commits of other branches, are left out."""
    place = {commit[:SHORT_COMMIT]: i for i, commit in enumerate(line)}
    found = {}
    for each in in_order(rows, line):
        number = value(each)
        if number is not None and each["commit"] in place and of(each):
            found.setdefault(each["workload"], []).append((place[each["commit"]], number, each))
    return found


def instructions(row):
    return int(row["instructions"]) if row["instructions"] else None


def items_per_second(row):
    return int(row["items"]) / float(row["seconds"]) if row["seconds"] and row["items"] else None


def changes(points, least):
    """The steps between neighbouring points whose share is at least `least`: (share, point before, point after)."""
    steps = [(after[1] / before[1] - 1, before, after) for before, after in zip(points, points[1:])]
    return [step for step in steps if abs(step[0]) >= least]
