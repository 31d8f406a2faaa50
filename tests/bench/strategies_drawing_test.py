"""The tables and pictures that bench/strategies makes of runs."""
import math
import unittest
import xml.etree.ElementTree

from measuring import strategies
from some_run import some_run

MACHINE = {"name": "a machine"}


def drawn(picture, tag):
    """The elements of a picture with this tag."""
    return [e for e in xml.etree.ElementTree.fromstring(picture).iter() if e.tag.endswith("}" + tag)]


def words_of(picture):
    return [e.text for e in drawn(picture, "text")]


def legend(picture):
    """The colour beside each title: a small square, and words a little below its upper end."""
    squares = {float(e.get("y")) + 10: e.get("fill") for e in drawn(picture, "rect") if e.get("width") == "11"}
    return {e.text: squares[float(e.get("y"))] for e in drawn(picture, "text") if float(e.get("y")) in squares}


def curves(picture):
    """The points of each curve, by the title that has its colour."""
    points = {e.get("stroke"): [tuple(map(float, p.split(","))) for p in e.get("points").split()]
              for e in drawn(picture, "polyline")}
    return {title: points[colour] for title, colour in legend(picture).items() if colour in points}


class Drawing(unittest.TestCase):
    titles = {"a": "first", "b": "second"}

    def runs(self):
        return [some_run(scheme=scheme, workers=workers, size=size, input=domain, seconds=seconds / workers)
                for scheme, seconds in (("a", 3), ("b", 2)) for workers in (1, 4) for size in (1e3, 1e4)
                for domain in ("square", "pipe")]

    def test_the_winner_has_the_least_seconds(self):
        best = strategies.winners(self.runs() + [some_run(scheme="a", workers=4, seconds=0.1)])
        self.assertEqual(best["square", 4, 1e4]["scheme"], "a")
        self.assertEqual(best["pipe", 4, 1e4]["scheme"], "b")
        self.assertEqual(len(best), 8)

    def test_schemes_that_meet_no_goal_win_nothing(self):
        best = strategies.winners([some_run(seconds=0, refines=False), some_run(scheme="b")])
        self.assertEqual(best["square", 4, 1e4]["scheme"], "b")

    def test_failed_runs_win_nothing(self):
        best = strategies.winners([{**some_run(seconds=0), "error": "no mesh"}, some_run(scheme="b")])
        self.assertEqual(best["square", 4, 1e4]["scheme"], "b")

    def test_pictures_are_svg_with_all_schemes(self):
        for picture in (strategies.draw_parallelism(self.runs(), self.titles),
                        strategies.draw_winners(self.runs(), self.titles, MACHINE)):
            root = xml.etree.ElementTree.fromstring(picture)
            words = [element.text for element in root.iter() if element.text]
            for title in self.titles.values():
                self.assertIn(title, words)
            for number in picture.replace('"', " ").split():
                self.assertNotIn(number, ("nan", "inf"))

    def test_a_cell_of_the_picture_has_the_colour_of_its_winner(self):
        picture = strategies.draw_winners(self.runs(), self.titles, MACHINE)
        cells = [e for e in xml.etree.ElementTree.fromstring(picture).iter() if e.tag.endswith("rect") and len(e)]
        self.assertEqual(len(cells), 8)
        self.assertEqual({cell.get("fill") for cell in cells}, {strategies.COLOURS[1]})

    def test_curves_take_equal_steps_for_equal_factors(self):
        ideal = [some_run(workers=workers, parallelism=workers) for workers in (4, 1, 2)]
        flat = [some_run(scheme="b", workers=workers, parallelism=1) for workers in (1, 2, 4)]
        smaller = [some_run(scheme="b", size=1e3, workers=8, parallelism=8)]  # only the largest size is drawn
        picture = strategies.draw_parallelism(smaller + ideal + flat, self.titles)
        line, = drawn(picture, "line")
        left, low, right, high = (float(line.get(name)) for name in ("x1", "y1", "x2", "y2"))
        self.assertTrue(left < right and high < low)  # y grows downwards
        self.assertEqual(curves(picture), {
            "first": [(left, low), ((left + right) / 2, (low + high) / 2), (right, high)],
            "second": [(left, low), ((left + right) / 2, low), (right, low)]})
        self.assertIn("square, 10,000 triangles", words_of(picture))

    def test_the_fastest_is_found_at_its_workers_and_its_triangles(self):
        runs = [some_run(scheme=scheme, workers=workers, size=size,
                         seconds=0.25 if scheme == "b" and (workers, size) == (4, 1e3) else seconds)
                for scheme, seconds in (("a", 1), ("b", 2)) for workers in (16, 1, 4) for size in (1e4, 1e3)]
        picture = strategies.draw_winners(runs, self.titles, MACHINE)
        cells = [e for e in drawn(picture, "rect") if len(e)]
        self.assertEqual(len(cells), 6)
        fast, = [e for e in cells if e[0].text == "second: 0.2500 s"]
        self.assertEqual({e[0].text for e in cells if e is not fast}, {"first: 1.0000 s"})
        columns, rows = (sorted({float(e.get(name)) for e in cells}) for name in ("x", "y"))
        self.assertEqual((float(fast.get("x")), float(fast.get("y"))), (columns[1], rows[1]))  # y grows downwards
        self.assertEqual(fast.get("fill"), legend(picture)["second"])
        places = {e.text: e for e in drawn(picture, "text")}
        for words, column in (("1", 0), ("4", 1), ("16", 2)):
            self.assertAlmostEqual(float(places[words].get("x")), columns[column] + float(fast.get("width")) / 2, 0)
        for words, row in (("1e4", 0), ("1e3", 1)):
            self.assertAlmostEqual(float(places[words].get("y")), rows[row] + float(fast.get("height")) / 2 + 3, 0)
        self.assertIn("The fastest scheme in the model of a machine", words_of(picture))

    def test_pictures_of_failed_runs_are_empty(self):
        failed = [{"scheme": "a", "refines": True, "input": "square", "size": 1e4, "workers": 4, "error": "no mesh"}]
        self.assertEqual(drawn(strategies.draw_parallelism(failed, self.titles), "polyline"), [])
        cells = [e for e in drawn(strategies.draw_winners(failed, self.titles, MACHINE), "rect") if len(e)]
        self.assertEqual(cells, [])


class Tables(unittest.TestCase):
    titles = {"a": "first", "b": "second"}

    def row(self, run):
        """The cells of the row of a run, by the names of their columns."""
        names, _, cells = ([cell.strip() for cell in line.split("|")[1:-1]]
                           for line in strategies.table([run], self.titles).splitlines())
        return dict(zip(names, cells, strict=True))

    def test_every_number_stands_under_its_name_in_its_unit(self):
        self.assertEqual(self.row(some_run()), {
            "scheme": "first", "triangles": "10", "rounds": "3", "barriers": "6", "parallelism": "2.5",
            "wasted work": "25%", "set-backs": "1", "messages": "8", "MB": "3.0", "held by a worker": "5",
            "before parallel work": "25.0%", "smallest angle": "21.00°", "seconds (model)": "2.0000"})

    def test_a_run_that_failed_has_a_row_without_numbers(self):
        row = self.row({"scheme": "b", "input": "square", "size": 1e4, "workers": 4, "error": "no mesh"})
        self.assertEqual(row.pop("scheme"), "second")
        self.assertEqual(set(row.values()), {"–"})

    def test_there_is_a_table_for_the_largest_size_and_for_the_most_workers(self):
        runs = [some_run(scheme=scheme, input=domain, size=size, workers=workers) for domain in ("square", "pipe")
                for size in (1e3, 1e4) for scheme in ("a", "b") for workers in (1, 2, 4)]
        page = strategies.tables(runs, self.titles, MACHINE)
        headings = [f"## {domain}, {of}" for domain in ("square", "pipe") for of in (
            "1,000 triangles, 4 workers", "10,000 triangles, 2 workers", "10,000 triangles, 4 workers")]
        self.assertEqual([line for line in page.splitlines() if line.startswith("## ")], headings)
        for title in self.titles.values():
            self.assertEqual(page.count(f"| {title} |"), len(headings))
        self.assertIn("the cost model for a machine.", page)

    def test_a_run_without_work_wastes_nothing(self):
        self.assertEqual(strategies.value(some_run(sequential=0, work=0, wasted=0), "wasted"), 0)
        self.assertFalse(math.isnan(strategies.value(some_run(critical=0), "before")))


if __name__ == "__main__":
    unittest.main()
