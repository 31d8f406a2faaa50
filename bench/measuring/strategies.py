"""Tables and pictures of what parallel schemes cost on simulated workers (bench/strategies)."""
import html
import math

POINT_SETS = ["random", "clustered"]  # inputs that a scheme without refinement can triangulate
COLOURS = ["#7f7f7f", "#4682b4", "#17becf", "#2e8b57", "#b8860b", "#e07b39", "#c0392b", "#8e44ad", "#d16ba5", "#1b4f72",
           "#7d6608", "#145a32", "#f1c40f", "#00e5a0", "#ff6f91", "#2c2c2c"]  # one per scheme
PANEL, MARGIN, LINE = 230, 44, 16
COLUMNS = [("triangles", "triangles", "{:,}"), ("rounds", "rounds", "{:,}"), ("barriers", "barriers", "{:,}"),
           ("parallelism", "parallelism", "{:.1f}"), ("wasted", "wasted work", "{:.0%}"),
           ("set_backs", "set-backs", "{:,}"), ("messages", "messages", "{:,}"), ("bytes", "MB", "{:.1f}"),
           ("most_held", "held by a worker", "{:,}"), ("before", "before parallel work", "{:.1%}"),
           ("smallest_angle", "smallest angle", "{:.2f}°"), ("seconds", "seconds (model)", "{:.4f}")]


def refining(runs):
    """Without the runs that meet no goal."""
    return [run for run in runs if run["refines"]]


def share(part, whole):
    return part / whole if whole else 0


def value(run, key):
    """The number in a column. Wasted work is a share of all work, the time before parallel work one of the path."""
    if key == "wasted":
        return share(run["wasted"], run["sequential"] + run["work"])
    if key == "before":
        return share(run["before"], run["critical"])
    return run["bytes"] / 1e6 if key == "bytes" else run[key]


def cell(run, key, form):
    return "–" if "error" in run else form.format(value(run, key))


def table(runs, titles):
    """One row per scheme, for runs of one input, size and number of workers."""
    lines = ["| scheme | " + " | ".join(name for _, name, _ in COLUMNS) + " |", "|---|" + "---:|" * len(COLUMNS)]
    for run in runs:
        cells = [cell(run, key, form) for key, _, form in COLUMNS]
        lines.append(f"| {titles[run['scheme']]} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def kinds(runs, *keys):
    """The values of these keys in the runs, each once, in their order."""
    return list(dict.fromkeys(tuple(run[key] for key in keys) for run in runs))


def tables(runs, titles, machine):
    """All tables in Markdown: per input and size with the most workers, and the largest size with each number."""
    most, largest = max(run["workers"] for run in runs), max(run["size"] for run in runs)
    parts = [f"# Parallel schemes on simulated workers\n\nSeconds are those of the cost model for {machine['name']}."]
    for domain, size, workers in kinds(runs, "input", "size", "workers"):
        if workers == 1 or (workers != most and size != largest):
            continue
        chosen = [r for r in runs if (r["input"], r["size"], r["workers"]) == (domain, size, workers)]
        parts.append(f"## {domain}, {size:,.0f} triangles, {workers:,} workers\n\n{table(chosen, titles)}")
    return "\n\n".join(parts) + "\n"


def text(x, y, words, anchor="start", size=11):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}">{html.escape(words)}</text>'


def legend(schemes, titles, x, y):
    parts = []
    for place, scheme in enumerate(schemes):
        parts.append(f'<rect x="{x}" y="{y + place * LINE}" width="11" height="11" fill="{COLOURS[place]}"/>')
        parts.append(text(x + 17, y + place * LINE + 10, titles[scheme]))
    return parts


def drawing(panels, notes, width, height):
    body = "\n".join(panels + notes)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'font-family="sans-serif"><rect width="100%" height="100%" fill="white"/>\n{body}\n</svg>\n')


def size_of_drawing(panels, schemes):
    columns = min(3, max(1, panels))
    rows = math.ceil(panels / columns)
    return columns, columns * PANEL + MARGIN, rows * PANEL + MARGIN + LINE * len(schemes)


def curve(runs, colour, at):
    points = [at(run["workers"], run["parallelism"]) for run in sorted(runs, key=lambda r: r["workers"])]
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dots = [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2" fill="{colour}"/>' for x, y in points]
    return [f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>', *dots]


def draw_parallelism(runs, titles):
    """Work divided by the critical path against workers, one panel per input, for the largest size."""
    largest = max(run["size"] for run in runs)
    runs = [run for run in runs if run["size"] == largest and "error" not in run]
    schemes, domains = [s for s, in kinds(runs, "scheme")], [d for d, in kinds(runs, "input")]
    columns, width, height = size_of_drawing(len(domains), schemes)
    most = max([2] + [run["workers"] for run in runs])  # all runs may have failed
    inner = PANEL - MARGIN
    panels = []
    for place, domain in enumerate(domains):
        left, top = MARGIN + place % columns * PANEL, MARGIN + place // columns * PANEL

        def at(workers, parallelism):
            return (left + inner * math.log(workers) / math.log(most),
                    top + inner - inner * math.log(max(1, parallelism)) / math.log(most))
        (left, low), (right, high) = at(1, 1), at(most, most)
        panels += [f'<path d="M{left:.1f} {high:.1f}V{low:.1f}H{right:.1f}" fill="none" stroke="#bbb"/>',
                   f'<line x1="{left:.1f}" y1="{low:.1f}" x2="{right:.1f}" y2="{high:.1f}" stroke="#ddd"/>',
                   text(left, top - 6, f"{domain}, {largest:,.0f} triangles"),
                   text(right, low + 13, f"{most:,} workers", "end", 9),
                   text(left - 3, high + 8, f"{most:,}", "end", 9)]
        for number, scheme in enumerate(schemes):
            of_scheme = [r for r in runs if r["input"] == domain and r["scheme"] == scheme]
            if of_scheme:
                panels += curve(of_scheme, COLOURS[number], at)
    notes = [text(MARGIN, 16, "Parallelism: all work divided by the critical path", size=13)]
    return drawing(panels, notes + legend(schemes, titles, MARGIN, height - LINE * len(schemes)), width, height)


def winners(runs):
    """The run with the least seconds, per input, number of workers and size."""
    best = {}
    for run in refining(runs):
        place = run["input"], run["workers"], run["size"]
        if "error" not in run and (place not in best or run["seconds"] < best[place]["seconds"]):
            best[place] = run
    return best


def draw_winners(runs, titles, machine):
    """Workers against triangles, coloured by the scheme with the least seconds in the model, one panel per input."""
    best = winners(runs)
    schemes = [s for s, in kinds(refining(runs), "scheme")]
    domains, workers, sizes = ([v for v, in kinds(refining(runs), key)] for key in ("input", "workers", "size"))
    workers, sizes = sorted(workers), sorted(sizes)
    columns, width, height = size_of_drawing(len(domains), schemes)
    inner = PANEL - MARGIN
    wide, high = inner / len(workers), inner / len(sizes)
    panels = []
    for place, domain in enumerate(domains):
        left, top = MARGIN + place % columns * PANEL, MARGIN + place // columns * PANEL
        panels.append(text(left, top - 6, domain))
        for i, count in enumerate(workers):
            panels.append(text(left + (i + 0.5) * wide, top + inner + 12, f"{count:,}", "middle", 9))
            for j, size in enumerate(sizes):
                run = best.get((domain, count, size))
                if run is None:
                    continue
                x, y = left + i * wide, top + inner - (j + 1) * high
                told = html.escape(f"{titles[run['scheme']]}: {run['seconds']:.4f} s")
                colour = COLOURS[schemes.index(run["scheme"])]
                panels.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{wide - 1:.1f}" height="{high - 1:.1f}" '
                              f'fill="{colour}"><title>{told}</title></rect>')
                if domain == domains[0] and i == 0:
                    panels.append(text(left - 3, y + high / 2 + 3, f"{size:.0e}".replace("e+0", "e"), "end", 9))
    notes = [text(MARGIN, 16, f"The fastest scheme in the model of {machine['name']}", size=13)]
    return drawing(panels, notes + legend(schemes, titles, MARGIN, height - LINE * len(schemes)), width, height)
