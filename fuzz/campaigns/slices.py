"""Slices: runs of libFuzzer of limited length, and what their logs say."""
import hashlib
import re
import shutil
import subprocess
from pathlib import Path

from . import programs

PULSE = re.compile(r"^#(\d+)\s+(\w+)\s+cov: (\d+) ft: (\d+)(?: corp: (\d+)/\S+)?", re.MULTILINE)


def numbers(log):
    """Executions, covered edges, features and inputs of the corpus, from the last line that has them; the features when
    the corpus had been read, and how many inputs were read. Reading an input again is no new execution."""
    result = {"executions": 0, "coverage": 0, "features": 0, "inputs": 0, "features_before": 0, "read": 0}
    for count, event, coverage, features, inputs in PULSE.findall(log):
        result.update(executions=int(count), coverage=int(coverage), features=int(features),
                      inputs=int(inputs or result["inputs"]))
        if event == "INITED":
            result["features_before"] = int(features)
            result["read"] = int(count)
    total = re.search(r"stat::number_of_executed_units: (\d+)", log)
    if total:
        result["executions"] = max(result["executions"], int(total.group(1)))
    if not result["read"]:
        result["read"] = result["executions"]  # the slice ended before the corpus was read
    result["executions"] -= min(result["read"], result["executions"])
    return result


def start(target, corpus, work, seconds, seed, children):
    """Starts a slice, one of the children. Its log is WORK/log, and a failing input is left in WORK. SIGTERM ends it
    with its figures."""
    corpus.mkdir(parents=True, exist_ok=True)
    command = target.command(f"-max_total_time={seconds}", f"-seed={seed}", f"-artifact_prefix={work}/", "-reload=0",
                             *folders_of(target, corpus))
    with open(work / "log", "wb") as log:
        return children.start(command, stdout=log, stderr=subprocess.STDOUT, cwd=work,
                              env=programs.environment())


def did_not_start(child, work):
    """Did the program of a slice end with an exit code of its own, without a figure and without a failing input?"""
    return child.returncode > 0 and not PULSE.search(log_of(work)) and not artifacts(work)


def folders_of(target, corpus):
    return [corpus] + ([target.committed] if target.committed.is_dir() else [])


def kind_of(file):
    """The kind of failure with which libFuzzer begins the name of a failing input; None for other files."""
    found = re.match(r"(crash|timeout|oom|leak)-", Path(file).name)
    return found and found.group(1)


def artifacts(work):
    return [file for file in sorted(Path(work).iterdir()) if kind_of(file)]


def log_of(work, name="log"):
    """The text of a log in WORK; empty if there is none."""
    log = work / name
    return log.read_text(errors="replace") if log.exists() else ""


def is_complete(folder):
    """Does a folder that libFuzzer has written have inputs, and all of them whole? Their names are their hashes.
    libFuzzer does not notice that it cannot write, for example on a full disk."""
    files = list(folder.iterdir())
    return bool(files) and all(hashlib.sha1(file.read_bytes()).hexdigest() == file.name for file in files)


def minimise(target, corpus, work, seconds, children):
    """Replaces the corpus by a subset with the same features. An interruption leaves the old or the new one. One of the
    children does it. Its log is WORK/merge, and inputs that fail are left in WORK; the subset does not have them."""
    merged, old, control = (corpus.with_suffix(suffix) for suffix in (".merged", ".old", ".control"))
    for leftover in (merged, old):
        remove(leftover)
    merged.mkdir(parents=True)
    command = target.command("-merge=1", f"-merge_control_file={control}", f"-artifact_prefix={work}/", merged,
                             *folders_of(target, corpus))
    control.unlink(missing_ok=True)
    with open(work / "merge", "wb") as log:
        child = children.start(command, stdout=log, stderr=subprocess.STDOUT, env=programs.environment())
    child.wait(seconds)
    control.unlink(missing_ok=True)
    if child.returncode != 0 or not is_complete(merged):
        remove(merged)
        return False
    corpus.rename(old)
    merged.rename(corpus)
    remove(old)
    return True


def recover(corpus):
    """Completes a replacement of the corpus that was interrupted between its two renames, and removes what an
    interrupted one has left."""
    old, merged = corpus.with_suffix(".old"), corpus.with_suffix(".merged")
    if not corpus.exists() and merged.exists():
        merged.rename(corpus)
    if not corpus.exists() and old.exists():
        old.rename(corpus)
    for leftover in (old, merged):
        remove(leftover)
    corpus.with_suffix(".control").unlink(missing_ok=True)


def remove(folder):
    if folder.is_dir():
        shutil.rmtree(folder)
