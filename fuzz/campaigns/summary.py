"""The summary of a campaign: summary.json, summary.md and coverage.svg."""
import json

COLOURS = ["#1b6ca8", "#c0392b", "#1e8449", "#8e44ad", "#d68910", "#117a65", "#7b241c", "#2e4053", "#ca6f1e", "#5b2c6f"]


def counted(number, thing):
    """A number and a noun: 1 find, 2 finds."""
    return f"{number:,} {thing}{'' if number == 1 else 's'}"


def duration(seconds):
    """In hours; short times in minutes."""
    return f"{seconds / 3600:.2f} hours" if seconds >= 360 else f"{seconds / 60:.1f} minutes"


def totals(state):
    """The seconds of processor time and the executions of all targets."""
    return tuple(sum(target[key] for target in state["targets"].values()) for key in ("cpu_seconds", "executions"))


def headline(state, finds):
    """What a campaign of the fuzz targets did, in one sentence."""
    seconds, executions = totals(state)
    return (f"{duration(seconds)} of processor time, {counted(executions, 'execution')}, "
            f"{counted(len(finds), 'find')}.")


def plot(histories, across, up):
    """An SVG plot of lines, each a name with its list of (x, y). Values are relative to the last one of the line."""
    width, height, left, top = 900, 420, 60, 20
    lines = {name: points for name, points in histories.items() if points}
    right = max((x for points in lines.values() for x, _ in points), default=1) or 1
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height + 20 * len(lines) + 60}" '
           'font-family="sans-serif" font-size="13">',
           f'<rect x="{left}" y="{top}" width="{width - left - 20}" height="{height - top - 40}" fill="none" '
           'stroke="#999"/>']
    for i in range(5):
        y = height - 40 - (height - top - 40) * i / 4
        out.append(f'<text x="{left - 8}" y="{y + 4:.0f}" text-anchor="end">{25 * i} %</text>')
        x = left + (width - left - 20) * i / 4
        out.append(f'<text x="{x:.0f}" y="{height - 22}" text-anchor="middle">{right * i / 4:.3g}</text>')
    out.append(f'<text x="{width / 2}" y="{height - 2}" text-anchor="middle">{across}</text>')
    for number, (name, points) in enumerate(sorted(lines.items())):
        colour, last = COLOURS[number % len(COLOURS)], max(y for _, y in points) or 1
        path = " ".join(f"{left + (width - left - 20) * x / right:.1f},"
                        f"{height - 40 - (height - top - 40) * y / last:.1f}" for x, y in points)
        dash = "" if number < len(COLOURS) else ' stroke-dasharray="6 3"'
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"{dash}/>')
        out.append(f'<text x="{left + 20}" y="{height + 30 + 20 * number}" fill="{colour}">{name}: {last} {up}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def list_of_finds(finds):
    """Finds that are sorted by verdict: a heading for each verdict."""
    if not finds:
        return ["No finds."]
    lines = []
    for before, find in zip([None, *finds], finds):
        if before is None or before["verdict"] != find["verdict"]:
            lines += ["", f"### {find['verdict']}", ""]
        lines += [f"- **{find['target']}** `{find['key']}`, {counted(find['times'], 'time')}: {find['message']}",
                  f"  - stack: {' < '.join(find['stack']) or 'none'}",
                  f"  - smallest input: {find['bytes']} bytes"
                  + ("" if find.get("repeats", True) else "; does not fail when it is replayed"),
                  f"  - replay: `{find['replay']}`"]
        if find.get("picture"):
            lines.append(f"  - picture: finds/{find['target']}/{find['key']}/domain.svg, domain.poly")
    return lines


def write(folder, state, finds):
    """`state` is that of the campaign; `finds` are entries of finds.py."""
    rows = sorted(state["targets"].items())
    seconds, executions = totals(state)
    (folder / "summary.json").write_text(json.dumps(
        {"schema": "pardel.campaign/1", "cpu_hours": seconds / 3600, "executions": executions,
         "targets": {name: {k: v for k, v in t.items()} for name, t in rows}, "finds": finds}, indent=1) + "\n")
    text = ["# Fuzzing campaign", "", headline(state, finds), "",
            "| target | CPU hours | executions | per second | covered edges | features | inputs | finds |",
            "|---|---:|---:|---:|---:|---:|---:|---:|"]
    for name, t in rows:
        count = sum(1 for f in finds if f["target"] == name)
        rate = t["executions"] / t["cpu_seconds"] if t["cpu_seconds"] else 0
        text.append(f"| {name} | {t['cpu_seconds'] / 3600:.2f} | {t['executions']:,} | {rate:,.0f} | {t['coverage']:,} "
                    f"| {t['features']:,} | {t['inputs']:,} | {count} |")
    text += ["", "![coverage over time](coverage.svg)", "", "## Finds", ""] + list_of_finds(finds)
    (folder / "summary.md").write_text("\n".join(text) + "\n")
    histories = {name: [(s / 3600, c) for s, c in t["history"]] for name, t in rows}
    (folder / "coverage.svg").write_text(plot(histories, "hours of processor time of the target", "edges"))
