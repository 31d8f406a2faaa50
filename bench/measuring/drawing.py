"""Draws the history: curves over the commits, as SVG, and a page with the commits that changed each."""
import html
import itertools

from . import history

PICTURE = "history.svg"  # the file of the drawing, beside the page
WIDTH, HEIGHT, MARGIN, TOP, BOTTOM = 400, 110, 10, 24, 20
THREADS = "/threads:"  # as in google.name_of()
COLOURS, CHANGED = ["#4682b4", "#2e8b57", "#8e44ad", "#b8860b"], "#c0392b"  # of the machines; of notable changes
NOTABLE_COUNT = 0.01  # changes of instructions that the page names
NOTABLE_RATE = 0.15  # changes of speed: seconds of a virtual machine vary
LABELLED, LABEL_WIDTH = 4, 80  # changes that a curve names, the largest first, where there is room


def spelled(number):
    """A number with three digits and a unit."""
    for limit, unit in ((1e9, " G"), (1e6, " M"), (1e3, " k")):
        if abs(number) >= limit:
            return f"{number / limit:.3g}{unit}"
    return f"{number:.3g}"


def curve(title, lines, last, steps, describe):
    """The elements of a box of WIDTH x HEIGHT with one line per machine. lines: lists of points as from
    history.series(), each with its colour; at least one, and none without points; last: the place of the last commit;
    steps: the changes to mark, as from history.changes(); describe: text about a point."""
    points = [point for _, of_line in lines for point in of_line]
    most = max(number for _, number, _ in points)
    newest = max(points, key=lambda point: point[0])

    def at(point):
        x = MARGIN + (WIDTH - 2 * MARGIN) * point[0] / max(1, last)
        return x, HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * point[1] / (most or 1)
    parts = [f'<text x="{MARGIN}" y="14" font-weight="bold">{html.escape(title)}</text>',
             f'<text x="{WIDTH - MARGIN}" y="14" text-anchor="end">{spelled(newest[1])}</text>',
             f'<line x1="{MARGIN}" y1="{HEIGHT - BOTTOM}" x2="{WIDTH - MARGIN}" y2="{HEIGHT - BOTTOM}" stroke="#bbb"/>']
    changed = {id(after) for _, _, after in steps}
    for colour, of_line in lines:
        path = " ".join("{:.1f},{:.1f}".format(*at(point)) for point in of_line)
        parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}"/>')
        for point in of_line:
            x, y = at(point)
            look = f'r="3.5" fill="{CHANGED}"' if id(point) in changed else f'r="2" fill="{colour}"'
            parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" {look}><title>{html.escape(describe(point))}</title>'
                         "</circle>")
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


def origin(before, after, between, subject):
    """Which commits a change between two measured points may come from. between(before, after): the commits after the
    one, up to the other, that change what is measured, the newest first."""
    suspects = between(before[2]["commit"], after[2]["commit"])
    if not suspects:
        return f"measured at {subject(after[2]['commit'])}"
    last = subject(suspects[0])
    return last if len(suspects) == 1 else f"one of {len(suspects)}, the last of them: {last}"


def table(title, steps, between, subject):
    """The changes that are worth a line. steps: lists of changes, as from history.changes(), by workload."""
    lines = [f"<h2>{title}</h2>", "<table>",
             "<tr><th>workload</th><th>change</th><th>measured before</th><th>commit</th><th>mesh</th></tr>"]
    for name, of_workload in sorted(steps.items()):
        for share, before, after in of_workload:
            old, new = before[2]["digest"], after[2]["digest"]
            mesh = "" if not old or not new else "the same" if old == new else "another"
            lines.append(f"<tr><td>{html.escape(name)}</td><td>{100 * share:+.1f} %</td>"
                         f"<td>{before[2]['commit'][:7]}</td>"
                         f"<td>{html.escape(origin(before, after, between, subject))}</td><td>{mesh}</td></tr>")
    return "\n".join(lines + ["</table>"])


def changes_of_speed(points, counted):
    """Notable changes of speed, without those where the instructions are the same: there, something else on the machine
    is the likely cause. counted: the instructions, by commit and workload."""
    def explained(before, after):
        old, new = (counted.get((point[2]["commit"], point[2]["workload"].split(THREADS)[0])) for point in (before, after))
        return old is None or new is None or abs(new / old - 1) >= NOTABLE_COUNT
    return [step for step in history.changes(points, NOTABLE_RATE) if explained(*step[1:])]


def speedups(alone, together):
    """The points of `together`, speeds on several threads, divided by the speed of the same commit on one thread. Both
    are of one machine."""
    of_commit = {row["commit"]: speed for _, speed, row in alone}
    return [(place, speed / of_commit[row["commit"]], row) for place, speed, row in together
            if of_commit.get(row["commit"])]


def draw(rows, line, compiler, between, subject):
    """The drawing and the page, as texts. rows: the history; line: the commits of the branch; between: see origin();
    subject: text about a commit. The curves are those of one compiler. Speeds have a curve per machine. The commits
    that were measured have equal distances."""
    rows = [row for row in rows if row["compiler"] == compiler]
    measured = {row["commit"] for row in rows}
    line = [commit for commit in line if commit[:history.SHORT_COMMIT] in measured]
    counts = history.series(rows, line, history.instructions)
    counted = {(row["commit"], name): number for name, points in counts.items() for _, number, row in points}
    machines = {machine: history.series(rows, line, history.items_per_second, lambda row: row["machine"] == machine)
                for machine in sorted({row["machine"] for row in rows if row["seconds"]})}
    colours = dict(zip(machines, itertools.cycle(COLOURS)))
    rates = {name for of_machine in machines.values() for name in of_machine}
    steps_of_counts = {name: history.changes(points, NOTABLE_COUNT) for name, points in counts.items()}
    steps_of_rates = {name: [step for of_machine in machines.values()
                             for step in changes_of_speed(of_machine.get(name, []), counted)] for name in rates}

    def about(point):
        return f"{subject(point[2]['commit'])}: {point[1]:,.0f}"

    def about_ratio(point):
        return f"{subject(point[2]['commit'])}: {point[1]:.2f}"

    def drawn_count(name):
        return name in counts and curve(f"{name}: instructions", [(COLOURS[0], counts[name])], len(line) - 1,
                                        steps_of_counts[name], about)

    def drawn_rate(name):
        lines = [(colours[machine], series[name]) for machine, series in machines.items() if name in series]
        return bool(lines) and curve(f"{name}: items/s", lines, len(line) - 1, steps_of_rates[name], about)

    def drawn_speedup(name):
        lines = [(colours[machine], speedups(series.get(name, []), series.get(f"{name}{THREADS}2", [])))
                 for machine, series in machines.items()]
        lines = [(colour, points) for colour, points in lines if points]
        return bool(lines) and curve(f"{name}: speed on 2 threads / on 1", lines, len(line) - 1, [], about_ratio)
    alone = sorted(name for name in counts.keys() | rates if THREADS not in name)
    curves = [[drawn_count(name), drawn_rate(name), drawn_rate(f"{name}{THREADS}2"), drawn_speedup(name)]
              for name in alone]
    others = sorted(name for name in rates if THREADS in name and
                    not (name.endswith(f"{THREADS}2") and name.split(THREADS)[0] in alone))
    curves += [[None, drawn_rate(name), None, None] for name in others]
    legend = "; ".join(f"<span style='color: {colours[machine]}'>{html.escape(machine)}</span>" for machine in machines)
    first, last = (html.escape(subject(commit)) for commit in (line[0], line[-1])) if line else ("", "")
    page = "\n".join([
        "<!DOCTYPE html>", "<html lang='en'>", "<meta charset='utf-8'>",
        "<title>pardel: workloads over the commits</title>",
        "<style>body { font-family: sans-serif; max-width: 1220px; margin: 1em auto } td, th { text-align: left; "
        "padding: 0 1em 0 0 } object { max-width: 100% }</style>",
        "<h1>Fixed workloads over the commits</h1>",
        f"<p>Measured by bench/track: {len(line)} commits. The first one is <q>{first}</q>, the last one <q>{last}</q>. "
        "docs/performance.md describes the workloads.</p>",
        "<ul>",
        f"<li>First column: the instructions that valgrind counts, on one thread, with {html.escape(compiler)}.</li>",
        "<li>Second and third column: items per second, on one thread and on two. Items are triangles; for predicates "
        "they are evaluations, for insertion points, for domains points, for caps and rasters numbers. The shortest of "
        "some runs counts: processor time on one thread, clock time on several.</li>",
        "<li>Last column: the speed on two threads divided by that on one.</li>",
        f"<li>Each machine has a colour: {legend}. The machines also did other work, so seconds vary, often by a half."
        "</li>",
        "<li>All axes begin at zero. The number beside a curve is its last value.</li>",
        f"<li>Red dots: the instructions changed by {100 * NOTABLE_COUNT:.0f} % or more; or the speed on one machine "
        f"changed by {100 * NOTABLE_RATE:.0f} % or more, and the instructions changed, too. Changes of the speed alone "
        "are found by bench/compare.</li>",
        "<li>In the tables below, several commits may be named for a change: they lie between two measured ones, and any "
        "of them may be the cause; bench/track --narrow measures more of them. The last column says if the workload made "
        "the same mesh before and after; it is empty if the mesh before, or that after, is not known.</li>",
        "</ul>",
        f'<object type="image/svg+xml" data="{PICTURE}">{PICTURE}</object>',
        table(f"Changes of instructions of {100 * NOTABLE_COUNT:.0f} % and more", steps_of_counts, between, subject),
        table(f"Changes of items per second of {100 * NOTABLE_RATE:.0f} % and more on one machine, where the instructions "
              "changed", steps_of_rates, between, subject),
        "</html>", ""])
    return svg(curves or [[None]]), page
