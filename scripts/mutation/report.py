"""The report of a run of scripts/mutate."""
import collections

KILLED = ("failed", "crashed", "time-out")


def snippet(root, site):
    """The text that a mutant changes, on one line."""
    edit = site.edits[0]
    text = (root / site.file).read_bytes()[edit.start:edit.end].decode()
    return " ".join(text.split()) or f"{site.function}()"


def equivalents(file):
    """The known mutants without a visible effect: {(file, function, text, mutant): reason}."""
    lines = file.read_text().splitlines() if file.exists() else []
    rows = [[part.strip() for part in line.split(" | ")] for line in lines if line and not line.startswith("#")]
    return {tuple(row[:4]): row[4] for row in rows}


def key(row):
    return row["file"], row["function"], row["text"], row["mutant"]


def folder(row):
    parts = row["file"].split("/")
    return "/".join(parts[:2] if parts[0] in ("parallel", "distributed", "properties") and len(parts) > 2 else parts[:1])


def score(rows):
    killed = sum(row["result"] in KILLED for row in rows)
    return f"{100 * killed / len(rows):6.1f}" if rows else "     -"


def text(rows, known):
    """The score of each folder and the list of the mutants that survived."""
    equivalent = [row for row in rows if key(row) in known and row["result"] not in KILLED]
    rest = [row for row in rows if row not in equivalent]
    results = [*KILLED, "survived", "not decided", "never evaluated"]
    lines = [f"{'folder':26}" + "".join(f"{c:>17}" for c in ["tried", *results, "equivalent", "killed, %"])]
    for name in [*sorted({folder(row) for row in rows}), "all"]:
        here = [row for row in rest if name in (folder(row), "all")]
        counts = collections.Counter(row["result"] for row in here)
        same = sum(name in (folder(row), "all") for row in equivalent)
        numbers = [len(here) + same, *(counts[r] for r in results), same]
        lines.append(f"{name:26}" + "".join(f"{n:17}" for n in numbers) + f"{score(here):>17}")
    lines += ["", "Survived:"]
    for row in sorted((r for r in rest if r["result"] not in KILLED), key=lambda r: (r["file"], r["line"])):
        lines.append(f"{row['file']}:{row['line']} | {row['function']} | {row['text']} | {row['mutant']} | {row['result']}")
    return "\n".join(lines)
