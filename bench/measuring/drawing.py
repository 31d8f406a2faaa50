"""Draws the history: curves over the commits, as SVG, and a page with the commits that changed each."""
import html

from . import history

PICTURE = "history.svg"  # the file of the drawing, beside the page
WIDTH, HEIGHT, MARGIN, TOP, BOTTOM = 400, 110, 10, 24, 20
THREADS = "/threads:"  # as in google.name_of()
LINE, CHANGED = "#4682b4", "#c0392b"
NOTABLE_COUNT = 0.01  # changes of instructions that the page names
NOTABLE_RATE = 0.15  # changes of speed: seconds of a virtual machine vary
LABELLED, LABEL_WIDTH = 4, 80  # changes that a curve names, the largest first, where there is room


def spelled(number):
    """A number with three digits and a unit."""
    for limit, unit in ((1e9, " G"), (1e6, " M"), (1e3, " k")):
        if abs(number) >= limit:
            return f"{number / limit:.3g}{unit}"
    return f"{number:.3g}"


def curve(title, points, last, steps, describe):
    """The elements of one curve in a box of WIDTH x HEIGHT. points: as from history.series(), at least one; last: the
    place of the last commit; steps: the changes to mark, as from history.changes(); describe: text about a point."""
    most = max(number for _, number, _ in points)

    def at(point):
        x = MARGIN + (WIDTH - 2 * MARGIN) * point[0] / max(1, last)
        return x, HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * point[1] / (most or 1)
    line = " ".join("{:.1f},{:.1f}".format(*at(point)) for point in points)
    parts = [f'<text x="{MARGIN}" y="14" font-weight="bold">{html.escape(title)}</text>',
             f'<text x="{WIDTH - MARGIN}" y="14" text-anchor="end">{spelled(points[-1][1])}</text>',
             f'<line x1="{MARGIN}" y1="{HEIGHT - BOTTOM}" x2="{WIDTH - MARGIN}" y2="{HEIGHT - BOTTOM}" stroke="#bbb"/>',
             f'<polyline points="{line}" fill="none" stroke="{LINE}"/>']
    changed = {id(after): share for share, _, after in steps}
    for point in points:
        x, y = at(point)
        share = changed.get(id(point))
        look = f'r="2" fill="{LINE}"' if share is None else f'r="3.5" fill="{CHANGED}"'
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" {look}><title>{html.escape(describe(point))}</title></circle>')
    labels = []
    for share, _, after in sorted(steps, key=lambda step: -abs(step[0])):
        x = at(after)[0]
        if len(labels) < LABELLED and all(abs(x - other) >= LABEL_WIDTH for other in labels):
            labels.append(x)
            anchor = "start" if x < 0.6 * LABEL_WIDTH else "end" if x > WIDTH - 0.6 * LABEL_WIDTH else "middle"
            parts.append(f'<text x="{x:.1f}" y="{HEIGHT - 7}" text-anchor="{anchor}" font-size="9" fill="{CHANGED}">'
                         f'{after[2]["commit"][:7]} {100 * share:+.0f} %</text>')
    return "\n".join(parts)


def svg(rows_of_curves):
    """A drawing of curves in rows. Each is the text of curve(), or None for an empty place."""
    columns = max(len(row) for row in rows_of_curves)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {columns * WIDTH} {len(rows_of_curves) * HEIGHT}" '
             f'width="{columns * WIDTH}" font-family="sans-serif" font-size="12">',
             '<rect width="100%" height="100%" fill="white"/>']
    for i, row in enumerate(rows_of_curves):
        for k, drawn in enumerate(row):
            if drawn:
                parts.append(f'<g transform="translate({k * WIDTH} {i * HEIGHT})">\n{drawn}\n</g>')
    return "\n".join(parts + ["</svg>\n"])


def table(title, series, steps_of, subject):
    """The changes of all workloads that are worth a line, each with the commits between which it lies. steps_of: the
    changes of a list of points."""
    lines = [f"<h2>{title}</h2>", "<table>",
             "<tr><th>workload</th><th>change</th><th>commit</th><th>measured before</th><th>mesh</th></tr>"]
    for name, points in sorted(series.items()):
        for share, before, after in steps_of(points):
            old, new = before[2]["digest"], after[2]["digest"]
            mesh = "" if not old or not new else "the same" if old == new else "another"
            lines.append(f"<tr><td>{html.escape(name)}</td><td>{100 * share:+.1f} %</td>"
                         f"<td>{html.escape(subject(after[2]['commit']))}</td><td>{before[2]['commit'][:7]}</td>"
                         f"<td>{mesh}</td></tr>")
    return "\n".join(lines + ["</table>"])


def draw(rows, line, compiler, machine, subject):
    """The drawing and the page, as texts. rows: the history; line: the commits of the branch; subject: text about a
    commit. Curves have the counts of one compiler, and the speeds of this compiler and one machine. The commits that
    were measured have equal distances."""
    measured = {row["commit"] for row in rows}
    line = [commit for commit in line if commit[:history.SHORT_COMMIT] in measured]
    counts = history.series(rows, line, history.instructions, lambda row: row["compiler"] == compiler)
    rates = history.series(rows, line, history.items_per_second,
                           lambda row: row["compiler"] == compiler and row["machine"] == machine)

    counted = {(row["commit"], name): number for name, points in counts.items() for _, number, row in points}

    def steps_of_counts(points):
        return history.changes(points, NOTABLE_COUNT)

    def steps_of_rates(points):
        """Without those where the instructions are the same: there, something else on the machine is the likely cause."""
        def explained(before, after):
            old, new = (counted.get((point[2]["commit"], point[2]["workload"].split(THREADS)[0])) for point in (before, after))
            return old is None or new is None or abs(new / old - 1) >= NOTABLE_COUNT
        return [step for step in history.changes(points, NOTABLE_RATE) if explained(*step[1:])]

    def drawn(series, name, what, steps_of):
        if name not in series:
            return None
        return curve(f"{name}: {what}", series[name], len(line) - 1, steps_of(series[name]),
                     lambda point: f"{subject(point[2]['commit'])}: {point[1]:,.0f}")
    alone = sorted(name for name in counts.keys() | rates.keys() if THREADS not in name)
    curves = [[drawn(counts, name, "instructions", steps_of_counts), drawn(rates, name, "items/s", steps_of_rates),
               drawn(rates, f"{name}{THREADS}2", "items/s", steps_of_rates)] for name in alone]
    others = sorted(name for name in rates if THREADS in name and name.split(THREADS)[0] not in alone)
    curves += [[None, drawn(rates, name, "items/s", steps_of_rates)] for name in others]
    picture = svg(curves or [[None]])
    page = "\n".join([
        "<!DOCTYPE html>", "<html lang='en'>", "<meta charset='utf-8'>",
        "<title>pardel: workloads over the commits</title>",
        "<style>body { font-family: sans-serif; max-width: 1220px; margin: 1em auto } td, th { text-align: left; "
        "padding: 0 1em 0 0 } object { max-width: 100% }</style>",
        "<h1>Fixed workloads over the commits</h1>",
        f"<p>Written by bench/track: {len(line)} commits, from {html.escape(subject(line[0]) if line else '')} to "
        f"{html.escape(subject(line[-1]) if line else '')}. Instructions are counted by valgrind, on one thread, with "
        f"{html.escape(compiler)}. Items are triangles; for predicates evaluations, for insertion points. Seconds are "
        f"the least of some runs on one machine ({html.escape(machine)}), of the processor on one thread, of the clock "
        f"on two. The machine also did other work, so they vary, often by a half. All axes begin at zero; the number is "
        f"the last value. Red: changes of {100 * NOTABLE_COUNT:.0f} % of the instructions, and of "
        f"{100 * NOTABLE_RATE:.0f} % of the speed if the instructions changed, too. bench/compare finds changes of the "
        f"speed alone. docs/performance.md describes the workloads.</p>",
        f'<object type="image/svg+xml" data="{PICTURE}">{PICTURE}</object>',
        table(f"Changes of instructions of {100 * NOTABLE_COUNT:.0f} % and more", counts, steps_of_counts, subject),
        table(f"Changes of items per second of {100 * NOTABLE_RATE:.0f} % and more, where the instructions changed", rates,
              steps_of_rates, subject),
        "</html>", ""])
    return picture, page
