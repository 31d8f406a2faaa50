"""Draws the history: curves over the commits, as SVG, and a page with the commits that changed each."""
import html

from . import history

WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 520, 130, 8, 24, 20
LINE, CHANGED = "#4682b4", "#c0392b"
NOTABLE_COUNT = 0.01  # changes of instructions that the page names
NOTABLE_RATE = 0.15  # changes of speed: seconds of a virtual machine vary
LABELLED = 4  # changes that a curve names


def spelled(number):
    """A number with three digits and a unit."""
    for limit, unit in ((1e9, " G"), (1e6, " M"), (1e3, " k")):
        if abs(number) >= limit:
            return f"{number / limit:.3g}{unit}"
    return f"{number:.3g}"


def curve(title, points, last, notable, describe):
    """The elements of one curve in a box of WIDTH x HEIGHT. points: as from history.series(), at least one; last: the
    place of the last commit; describe: text about a point."""
    most = max(number for _, number, _ in points)
    first = points[0][0]

    def at(point):
        x = LEFT + (WIDTH - 2 * LEFT) * (point[0] - first) / max(1, last - first)
        return x, HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * point[1] / (most or 1)
    places = [at(point) for point in points]
    parts = [f'<text x="{LEFT}" y="14" font-weight="bold">{html.escape(title)}</text>',
             f'<text x="{WIDTH - LEFT}" y="14" text-anchor="end">{spelled(points[-1][1])}, most {spelled(most)}</text>',
             f'<line x1="{LEFT}" y1="{HEIGHT - BOTTOM}" x2="{WIDTH - LEFT}" y2="{HEIGHT - BOTTOM}" stroke="#bbb"/>',
             f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}" fill="none" stroke="{LINE}"/>']
    steps = history.changes(points, notable)
    changed = {id(after): share for share, _, after in steps}
    labelled = {id(after) for _, _, after in sorted(steps, key=lambda step: -abs(step[0]))[:LABELLED]}
    for point, (x, y) in zip(points, places):
        share = changed.get(id(point))
        colour = LINE if share is None else CHANGED
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{2 if share is None else 3.5}" fill="{colour}">'
                     f'<title>{html.escape(describe(point))}</title></circle>')
        if id(point) in labelled:
            anchor = "start" if x < 60 else "end" if x > WIDTH - 60 else "middle"
            parts.append(f'<text x="{x:.1f}" y="{HEIGHT - 6}" text-anchor="{anchor}" font-size="9" fill="{CHANGED}">'
                         f'{point[2]["commit"][:7]} {100 * share:+.0f} %</text>')
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


def table(title, series, notable, subject):
    """The changes of all workloads that are worth a line, each with the commits between which it lies."""
    lines = [f"<h2>{title}</h2>", "<table>",
             "<tr><th>workload</th><th>change</th><th>commit</th><th>measured before</th><th>mesh</th></tr>"]
    for name, points in sorted(series.items()):
        for share, before, after in history.changes(points, notable):
            old, new = before[2]["digest"], after[2]["digest"]
            mesh = "" if not old or not new else "the same" if old == new else "another"
            lines.append(f"<tr><td>{html.escape(name)}</td><td>{100 * share:+.1f} %</td>"
                         f"<td>{html.escape(subject(after[2]['commit']))}</td><td>{before[2]['commit'][:7]}</td>"
                         f"<td>{mesh}</td></tr>")
    return "\n".join(lines + ["</table>"])


def draw(rows, line, compiler, machine, subject):
    """The drawing and the page, as texts. rows: the history; line: the commits of the branch; subject: text about a
    commit. Curves have the counts of one compiler, and the speeds of this compiler and one machine."""
    counts = history.series(rows, line, history.instructions, lambda row: row["compiler"] == compiler)
    rates = history.series(rows, line, history.items_per_second,
                           lambda row: row["compiler"] == compiler and row["machine"] == machine)
    last = len(line) - 1

    def drawn(series, name, what, notable):
        if name not in series:
            return None
        return curve(f"{name}: {what}", series[name], last, notable,
                     lambda point: f"{subject(point[2]['commit'])}: {point[1]:,.0f}")
    names = sorted(counts.keys() | rates.keys())
    picture = svg([[drawn(counts, name, "instructions", NOTABLE_COUNT), drawn(rates, name, "items per second", NOTABLE_RATE)]
                   for name in names] or [[None]])
    page = "\n".join([
        "<!DOCTYPE html>", "<html lang='en'>", "<meta charset='utf-8'>",
        "<title>pardel: workloads over the commits</title>",
        "<style>body { font-family: sans-serif; max-width: 1080px; margin: 1em auto } td, th { text-align: left; "
        "padding: 0 1em 0 0 } svg { max-width: 100% }</style>",
        f"<h1>Fixed workloads over the commits</h1>",
        f"<p>Written by bench/track. Instructions are counted by valgrind, with {html.escape(compiler)}, on one thread. "
        f"Items are triangles; for predicates and insertion, evaluations and points. Seconds are the least of some runs "
        f"on one machine ({html.escape(machine)}), which also did other work; they vary. Each curve begins at its first "
        f"commit, and its axis at zero. Red: changes of {100 * NOTABLE_COUNT:.0f} % of the instructions and of "
        f"{100 * NOTABLE_RATE:.0f} % of the speed. docs/performance.md describes the workloads.</p>",
        picture,
        table(f"Changes of instructions of {100 * NOTABLE_COUNT:.0f} % and more", counts, NOTABLE_COUNT, subject),
        table(f"Changes of items per second of {100 * NOTABLE_RATE:.0f} % and more", rates, NOTABLE_RATE, subject),
        "</html>", ""])
    return picture, page
