"""The comparison of parallel schemes: the programs that count and model, and what bench/strategies draws."""
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from measuring import commits, strategies

MACHINE = {"name": "a machine", "seconds_per_triangle": 1e-6, "latency": 1e-3, "bandwidth": 1e6}


def run(variable, *arguments):
    words = [os.environ[variable], *(str(word) for word in arguments)]
    return subprocess.run(words, capture_output=True, text=True, timeout=200, check=False)


def counts(*arguments):
    done = run("COUNT_SCHEMES", *arguments)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()]


def known():
    return counts("--list")[0]


def some_run(**changes):
    """A run that was not counted, for the tables."""
    plain = {"scheme": "a", "refines": True, "input": "square", "size": 1e4, "workers": 4, "triangles": 10,
             "sequential": 10, "work": 90, "wasted": 25, "critical": 40, "before": 10, "parallelism": 2.5, "rounds": 3,
             "barriers": 6, "set_backs": 1, "messages": 8, "bytes": 3e6, "most_held": 5, "smallest_angle": 21,
             "certified": True, "seconds": 2.0}
    return {**plain, **changes}


class Counting(unittest.TestCase):
    def test_every_scheme_is_certified_on_every_input(self):
        names = known()
        for scheme in names["schemes"]:
            for domain in names["inputs"]:
                if not scheme["refines"] and domain not in strategies.POINT_SETS:
                    continue
                arguments = ("--scheme", scheme["name"], "--input", domain, "--triangles", 2000)
                for line in counts(*arguments, "--workers", 1, 7):
                    self.assertNotIn("error", line)
                    self.assertTrue(line["certified"], line)

    def test_the_same_run_has_the_same_counts(self):
        for scheme in known()["schemes"]:
            arguments = ("--scheme", scheme["name"], "--input", "random", "--triangles", 1000, "--workers", 5)
            self.assertEqual(counts(*arguments), counts(*arguments))

    def test_parts_are_not_more_than_the_whole(self):
        for scheme in known()["schemes"]:
            for line in counts("--scheme", scheme["name"], "--input", "random", "--triangles", 2000, "--workers", 1, 8):
                self.assertLessEqual(line["wasted"], line["work"], line)
                self.assertLessEqual(line["before"], line["critical"], line)
                self.assertLessEqual(line["most_held"], line["triangles"] + 10, line)
                self.assertLessEqual(line["parallelism"], line["workers"] + 1e-9, line)
                if scheme["name"] != "load-balancing":  # there, messages take time on the path
                    self.assertLessEqual(line["critical"], line["sequential"] + line["work"], line)

    def test_one_worker_sends_nothing_and_is_never_set_back_by_another(self):
        for scheme in known()["schemes"]:
            line, = counts("--scheme", scheme["name"], "--input", "random", "--triangles", 1000, "--workers", 1)
            self.assertEqual((line["messages"], line["bytes"]), (0, 0), line)

    def test_unknown_names_are_errors(self):
        for arguments in (("--scheme", "magic"), ("--scheme", "rounds", "--input", "moon")):
            done = run("COUNT_SCHEMES", *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(arguments[-1], done.stderr)


class Options(unittest.TestCase):
    """What is wrong with the options of bench/strategies is found before anything is built or counted."""

    def refused(self, *arguments):
        words = [sys.executable, commits.ROOT + "/bench/strategies", *arguments]
        done = subprocess.run(words, capture_output=True, text=True, timeout=20, check=False)
        self.assertNotEqual(done.returncode, 0, arguments)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def test_numbers_out_of_range_are_refused(self):
        for name, text in (("--workers", "0"), ("--workers", "x"), ("--sizes", "nan"), ("--sizes", "5"), ("--jobs", "0")):
            self.assertIn(name, self.refused(name, text))

    def test_a_machine_that_cannot_be_read_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "machine.json")
            self.assertIn(path, self.refused("--machine", path, "--out", folder))
            for text, message in (("no JSON", "no JSON"), ('{"name": "a"}', "seconds_per_triangle")):
                with open(path, "w", encoding="utf-8") as out:
                    out.write(text)
                self.assertIn(message, self.refused("--machine", path, "--out", folder))

    def test_a_folder_that_cannot_be_written_or_read_is_refused(self):
        with tempfile.NamedTemporaryFile() as file:
            self.assertIn(file.name, self.refused("--out", file.name))
        self.assertIn("/no/folder", self.refused("--again", "/no/folder"))


class Seconds(unittest.TestCase):
    def modelled(self, *runs, machine=None):
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("machine.json", "counts")]
            with open(paths[0], "w", encoding="utf-8") as out:
                json.dump(machine or MACHINE, out)
            with open(paths[1], "w", encoding="utf-8") as out:
                out.writelines(json.dumps(r) + "\n" for r in runs)
            return run("SCHEME_SECONDS", *paths)

    def test_seconds_are_the_path_the_barriers_and_the_messages(self):
        line = json.loads(self.modelled(some_run()).stdout)
        barrier = 2 * (MACHINE["latency"] + 8 / MACHINE["bandwidth"])  # doubling among 4 workers
        messages = (8 * MACHINE["latency"] + 3e6 / MACHINE["bandwidth"]) / 4
        self.assertAlmostEqual(line["seconds"], 40e-6 + 6 * barrier + messages)

    def test_one_worker_waits_for_nobody(self):
        line = json.loads(self.modelled(some_run(workers=1, messages=0, bytes=0)).stdout)
        self.assertAlmostEqual(line["seconds"], 40e-6)

    def test_runs_that_failed_have_no_seconds(self):
        line = json.loads(self.modelled({"scheme": "a", "workers": 2, "error": "no mesh"}).stdout)
        self.assertNotIn("seconds", line)

    def test_a_machine_without_a_number_is_an_error(self):
        done = self.modelled(some_run(), machine={"latency": 1})
        self.assertEqual(done.returncode, 1)
        self.assertIn("seconds_per_triangle", done.stderr)
        self.assertEqual(run("SCHEME_SECONDS", "/no/file", "/no/counts").returncode, 1)


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

    def test_tables_have_a_row_per_scheme(self):
        page = strategies.tables(self.runs(), self.titles, MACHINE)
        self.assertEqual(page.count("## "), 4)  # two inputs and sizes, with more than one worker
        self.assertEqual(page.count("| first |"), 4)
        self.assertIn("| 25% |", page)  # wasted work
        self.assertIn("| 25.0% |", page)  # of the path before parallel work

    def test_every_scheme_has_a_colour_of_its_own(self):
        self.assertGreaterEqual(len(set(strategies.COLOURS)), len(known()["schemes"]))

    def test_a_run_without_work_wastes_nothing(self):
        self.assertEqual(strategies.value(some_run(sequential=0, work=0, wasted=0), "wasted"), 0)
        self.assertFalse(math.isnan(strategies.value(some_run(critical=0), "before")))


if __name__ == "__main__":
    unittest.main()
