"""The JSON of Google Benchmark, which its own tools (tools/compare.py) and many others read."""
import datetime
import os
import platform

from . import history

NANOSECONDS = 1e9


def name_of(workload, threads):
    return workload if threads == 1 else f"{workload}/threads:{threads}"


def context(commit, compiler, executable):
    """What Google Benchmark says about a machine, and the commit and the compiler."""
    return {"date": datetime.datetime.now().astimezone().isoformat(timespec="seconds"),
            "host_name": platform.node(), "executable": executable, "num_cpus": os.cpu_count(),
            "load_avg": list(os.getloadavg()), "caches": [], "library_build_type": "release",
            "machine": history.machine(), "compiler": compiler, "commit": commit}


def entries(runs, instructions):
    """One entry for each repetition of a workload. runs: what `once` printed. instructions: by workload, of one
    thread."""
    found = []
    for i, one in enumerate(runs):
        name = name_of(one["workload"], one["threads"])
        entry = {"name": name, "run_name": name, "run_type": "iteration", "repetitions": len(runs),
                 "repetition_index": i, "threads": one["threads"], "iterations": 1,
                 "real_time": NANOSECONDS * one["seconds"], "cpu_time": NANOSECONDS * one["cpu_seconds"],
                 "time_unit": "ns", "items_per_second": one["items"] / one["seconds"], "items": one["items"]}
        if one["triangles"]:
            entry["bytes_per_triangle"] = one["bytes"] / one["items"]
        known = {"stalled": one.get("stalled"), "digest": one["digest"], "cycles": one["cycles"],
                 "instructions": instructions.get(name)}
        for key, value in known.items():
            if value is not None:
                entry[key] = value
        found.append(entry)
    return found
