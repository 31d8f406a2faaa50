"""Finds: failed runs, sorted by verdict and stack, and shrunk to the smallest input with the same verdict and stack."""
import hashlib
import json
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

import safe_files

from . import programs, slices
from .script import read_json

FRAME = re.compile(r"#\d+ 0x[0-9a-f]+ in (.+?) (?:/\S+|\()")
OF_OTHERS = ("LLVMFuzzer", "fuzzer::", "__", "std::", "operator")  # beginnings of names
ENTRY = ("target", "key", "times", "bytes", "replay", "verdict", "stack", "message")  # keys of a find.json
NOT_TELLING = ("pardel::fuzz::fail", "pardel::fuzz::fuzz_one", "abort", "raise", "gsignal", "main", "_start")


def plain(function):
    """The name of a function without the types of its result, of its arguments and of templates."""
    name = function.replace("(anonymous namespace)::", "")
    while (shorter := re.sub(r"<[^<>]*>", "", name)) != name:
        name = shorter
    name = name.partition("(")[0]
    return name if name.startswith("operator") else name.split()[-1] if name.split() else ""


def signature(output):
    """The verdict of a failed run and its innermost functions, without numbers, which differ from input to input."""
    verdict = "crash"
    for pattern in (r"fuzz: the property failed: (.*)", r"runtime error: (.*)", r"ERROR: (AddressSanitizer: [\w-]+)",
                    r"ERROR: (libFuzzer: .*)", r"terminate called after throwing (.*)", r"(assertion .*failed.*)"):
        found = re.search(pattern, output, re.IGNORECASE)
        if found:
            verdict = found.group(1)
            break
    message = verdict
    verdict = re.sub(r"/\S+|\S*pardel-fuzz-\S*", "FILE", verdict)
    verdict = re.sub(r"-?\d[\d.]*(e[+-]?\d+)?|\"[^\"]*\"", "N", verdict)[:160]
    verdict = re.sub(r"(\(N, N\),? ?)+|(N )+N", "N", verdict)
    frames = []
    for name in map(plain, FRAME.findall(output)):
        if name and not name.startswith(OF_OTHERS) and name not in NOT_TELLING and name not in frames:
            frames.append(name)
    return {"verdict": verdict, "stack": frames[:3], "message": message[:400]}


def key(target, found):
    text = json.dumps([target, found["verdict"], found["stack"]])
    return hashlib.sha1(text.encode()).hexdigest()[:10]


def replay(target, file, seconds=30):
    """Runs one input, for up to so many seconds of processor time. Returns the output of a failure, or None. Signals of
    a terminal do not reach the run: its end would look like a failure."""
    command = ["prlimit", f"--cpu={seconds}", str(target.replay), str(file)]
    try:
        ran = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=20 * seconds,
                             env=programs.environment(), check=False, start_new_session=True)
    except subprocess.TimeoutExpired:  # it waits for something
        return "ERROR: libFuzzer: timeout"
    if ran.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "ERROR: libFuzzer: timeout"
    return None if ran.returncode == 0 else ran.stdout.decode(errors="replace")


def smaller(data, target, fails, is_over):
    """The smallest input that rounds of one_round() reach from this one, until is_over(). fails() tells whether an
    input has the same verdict and stack."""
    before = None
    while data != before and not is_over():
        before, data = data, one_round(data, target, fails, is_over)
    return data


def one_round(data, target, fails, is_over):
    """Removes parts, and sets bytes to zero, as long as fails() holds: strokes of a domain, else lines and bytes. In
    strokes, bytes are numbers, for example the size of a domain of a family. They are also made smaller."""
    head, sizes = (32, [64, 16, 8]) if target.has_strokes else (0, [256, 64, 16, 4, 1])
    for size in sizes:
        at = len(data) - (len(data) - head) % size
        while at > head and not is_over():
            at -= size
            shorter = data[:at] + data[at + size:]
            if at >= head and len(shorter) < len(data) and fails(shorter):
                data = shorter
    for i in range(len(data)):
        if is_over():
            break
        zeroed = data[:i] + b"\0" + data[i + 1:]
        if zeroed != data and fails(zeroed):
            data = zeroed
        elif target.has_strokes:
            data = with_less_at(i, data, fails, is_over)
    while data.endswith(b"\0") and fails(data[:-1]) and not is_over():
        data = data[:-1]
    return data


def with_less_at(i, data, fails, is_over):
    """The input with a smaller byte at i: half of it is subtracted, then a quarter and so on, as long as fails()
    holds."""
    step = data[i] // 2
    while step > 0 and not is_over():
        less = data[i] - step
        if less > 0 and fails(candidate := data[:i] + bytes([less]) + data[i + 1:]):
            data = candidate
        else:
            step //= 2
    return data


def timed_out(artifact, output):
    """libFuzzer tells it in the name of a failing input, AFL++ in the output."""
    kind = slices.kind_of(artifact)
    return kind == "timeout" if kind else "timeout" in signature(output)["verdict"]


def record(target, artifact, output, folder, seconds, stopping=lambda: False):
    """Files a find below `folder`. Returns its entry, or None if one with the same verdict and stack is there. A find
    gets its name when it is complete; what an interruption leaves is made again. It is shrunk for so many seconds, or
    until stopping().

    If the replay program does not fail, the verdict is that of the fuzzer: the run depends on more than its input. Only
    a time-out of the fuzzer is then no find: it counts elapsed time, of which other work may have taken most.
    """
    again = replay(target, artifact)
    if again is None and timed_out(artifact, output):
        return None
    found = signature(again if again is not None else output)
    name = key(target.name, found)
    place = Path(folder) / target.name / name
    if (place / "find.json").exists():
        count = read_json(place / "find.json", ENTRY)
        count["times"] += 1
        safe_files.replace(place / "find.json", json.dumps(count, indent=1))
        return None
    fresh = place.with_suffix(".new")
    for leftover in (place, fresh):
        shutil.rmtree(leftover, ignore_errors=True)
    fresh.mkdir(parents=True)
    shutil.copy(artifact, fresh / "first")
    (fresh / "output.txt").write_text(again if again is not None else output)
    data = Path(artifact).read_bytes()
    if again is not None and "timeout" not in found["verdict"]:
        trial = fresh / "trial"

        def fails(candidate):
            trial.write_bytes(candidate)
            text = replay(target, trial)
            return text is not None and key(target.name, signature(text)) == name

        until = time.time() + seconds
        data = smaller(data, target, fails, lambda: stopping() or time.time() > until)
        trial.unlink(missing_ok=True)
    (fresh / "input").write_bytes(data)
    if target.draws:
        drawn = subprocess.run([str(target.folder / "draw_case"), target.name, str(fresh / "input"),
                                str(fresh / "domain")], capture_output=True, text=True, check=False)
        (fresh / "case.txt").write_text(drawn.stdout)
    entry = {"target": target.name, "key": name, "times": 1, "bytes": len(data), "repeats": again is not None,
             "replay": f"{target.replay} {place / 'input'}", "picture": target.draws, **found}
    (fresh / "find.json").write_text(json.dumps(entry, indent=1))
    fresh.rename(place)
    return entry


def all_in(folder):
    """The finds below a folder, sorted by verdict, then by stack."""
    files = Path(folder).glob("*/*/find.json")
    found = [read_json(file, ENTRY) for file in files if file.parent.suffix != ".new"]
    return sorted(found, key=lambda find: (find["verdict"], find["stack"], find["target"], find["key"]))
