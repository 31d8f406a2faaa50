"""What bench/gate, bench/track and bench/compare compute from their measurements."""
import json
import math
import os
import random
import re
import statistics
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree

from measuring import command, commits, drawing, google, history, once, pressure, ratios
import safe_files
from script import load


gate, track, compare = load("gate"), load("track"), load("compare")


class Intervals(unittest.TestCase):
    def test_the_interval_contains_the_median(self):
        for n in range(1, 40):
            values = [random.Random(n).uniform(0.5, 2) for _ in range(n)]
            median, low, high = ratios.median_interval(values, 0.95)
            self.assertEqual(median, statistics.median(values))
            self.assertTrue(low <= median <= high)

    def test_the_same_values_give_the_same_interval(self):
        values = [1.1, 0.9, 1.3, 1.0, 1.2, 1.05, 0.95, 1.15, 1.25]
        self.assertEqual(ratios.median_interval(values, 0.95), ratios.median_interval(values, 0.95))

    def test_the_sign_interval_leaves_out_what_a_coin_seldom_throws(self):
        values = list(range(1, 16))
        # 2 (1 + 15 + 105) / 2^15 = 0.0074 is below 1 %, with 455 more it is not.
        self.assertEqual(ratios.sign_interval(values, 0.99), (3, 13))
        self.assertEqual(ratios.sign_interval(values, 0.95), (4, 12))

    def test_many_values_have_a_narrow_interval(self):
        low, high = ratios.sign_interval(list(range(3000)), 0.99)
        self.assertTrue(1400 < low < 1450 and 1550 < high < 1600)

    def test_few_values_have_no_interval_of_high_confidence(self):
        self.assertEqual(ratios.sign_interval([1.0] * 7, 0.99), (0, math.inf))
        self.assertEqual(ratios.sign_interval([1.0] * 8, 0.99), (1, 1))
        self.assertIn("too few pairs", ratios.verdict(0, math.inf, 0.99))

    def test_the_interval_is_at_least_as_wide_as_that_of_the_bootstrap(self):
        for seed in range(20):
            draw = random.Random(seed)
            values = [draw.lognormvariate(0, 0.1) for _ in range(21)]
            _, low, high = ratios.median_interval(values, 0.99)
            boot = ratios.bootstrap_interval(values, 0.99)
            self.assertTrue(low <= boot[0] and boot[1] <= high)

    def test_equal_programs_are_seldom_said_to_differ(self):
        """Ratios with heavy tails around 1: of 300 intervals of 95 %, about 15 may miss 1, and hardly ever 30."""
        missed = 0
        for seed in range(300):
            draw = random.Random(seed)
            values = [math.exp(0.05 * draw.gauss(0, 1) / max(0.1, draw.random())) for _ in range(15)]
            _, low, high = ratios.median_interval(values, 0.95)
            missed += not low <= 1 <= high
        self.assertLess(missed, 30)

    def test_a_verdict_says_who_is_slower_only_if_the_interval_excludes_1(self):
        self.assertEqual(ratios.verdict(1.01, 1.2, 0.99), "B is slower")
        self.assertEqual(ratios.verdict(0.8, 0.99, 0.99), "B is faster")
        for low, high in ((0.9, 1.1), (1, 1.1), (0.9, 1)):
            self.assertIn("includes 1", ratios.verdict(low, high, 0.99))


class Pairs(unittest.TestCase):
    def test_each_function_is_called_once_in_each_pair_and_each_often_first(self):
        calls = []
        results = ratios.in_pairs(lambda: calls.append("a") or 1, lambda: calls.append("b") or 2, 200, random.Random(1))
        self.assertEqual(results, [(1, 2)] * 200)
        self.assertTrue(all({calls[i], calls[i + 1]} == {"a", "b"} for i in range(0, 400, 2)))
        first = calls[0::2].count("a")
        self.assertTrue(70 < first < 130, first)


class FakeMachine:
    """Runs that take a known time, on a machine that gets slower and is disturbed now and then."""

    def __init__(self, seed):
        self.draw, self.calls = random.Random(seed), 0

    def run(self, seconds, digest="d"):
        self.calls += 1
        slower = 1 + 0.002 * self.calls
        disturbed = 3 if self.draw.random() < 0.1 else 1
        return {"seconds": seconds * slower * disturbed * self.draw.uniform(0.97, 1.03), "threads": 2, "digest": digest}


class Comparison(unittest.TestCase):
    def lines(self, seconds_b, digest="d", seed=0):
        machine = FakeMachine(seed)
        return compare.compare(lambda case: machine.run(1), lambda case: machine.run(seconds_b, digest),
                               [("x", 1), ("y", 2)], 31, 0.99, random.Random(seed))

    def test_a_planted_slowdown_is_named(self):
        lines = [line for seed in range(10) for line in self.lines(1.2, seed=seed).values()]
        verdicts = [line["verdict"] for line in lines]
        self.assertNotIn("B is faster", verdicts)
        self.assertGreaterEqual(verdicts.count("B is slower"), 18)
        self.assertTrue(all(1.1 < line["ratio"] < 1.3 for line in lines))

    def test_an_unchanged_program_on_a_machine_that_gets_slower_is_not_said_to_differ(self):
        verdicts = [line["verdict"] for seed in range(40) for line in self.lines(1, seed=seed).values()]
        self.assertLessEqual(sum("includes 1" not in verdict for verdict in verdicts), 3)  # 0.8 are expected

    def test_another_mesh_is_named(self):
        self.assertFalse(any(line["same_mesh"] for line in self.lines(1, "other").values()))
        self.assertTrue(all(line["same_mesh"] for line in self.lines(1).values()))


class Gate(unittest.TestCase):
    REFERENCE = {"w": {"instructions": 1000, "functions": {"f": 900}}}

    def test_more_than_two_percent_fail_and_the_function_that_grew_is_named(self):
        lines, beyond = gate.compare({"w": {"f": 900, "g": 130}}, self.REFERENCE)
        self.assertEqual(beyond, ["w"])
        self.assertIn("    functions without a count in the reference, among them g (130): +30", lines)
        self.assertFalse(any(line.startswith("    f:") for line in lines))

    def test_many_small_functions_that_grew_are_named_together(self):
        functions = {"f": 900, **{f"g{i}": 12 for i in range(12)}}
        lines, beyond = gate.compare({"w": functions}, self.REFERENCE)
        self.assertEqual(beyond, ["w"])
        self.assertIn("    functions without a count in the reference, among them g0 (12), g1 (12), g2 (12), g3 (12), "
                      "g4 (12): +44", lines)

    def test_less_than_two_percent_and_fewer_instructions_pass(self):
        for count in (1019, 500):
            self.assertEqual(gate.compare({"w": {"f": count}}, self.REFERENCE)[1], [])

    def test_a_missing_and_a_new_workload_fail(self):
        self.assertEqual(gate.compare({}, self.REFERENCE)[1], ["w"])
        self.assertEqual(gate.compare({"w": {"f": 1000}, "new": {"f": 1}}, self.REFERENCE)[1], ["new"])


    def test_the_document_has_the_counts_of_the_reference(self):
        with open(gate.REFERENCE) as file:
            counts = {name: f"{each['instructions'] / 1e6:.1f}" for name, each in json.load(file)["workloads"].items()}
        with open(os.path.join(commits.ROOT, "docs", "performance.md")) as document:
            written = dict(re.findall(r"^\| `(\w+)` \| .* \| ([\d.]+) \|$", document.read(), re.M))
        self.assertEqual({name: written.get(name) for name in counts}, counts)


class Callgrind(unittest.TestCase):
    def test_a_function_gets_its_own_instructions_and_not_those_of_its_callees(self):
        lines = ["fn=(1) main", "16 20", "cfn=(2) work", "calls=3 0", "16 400", "+2 5", "", "fn=(2)", "30 400", "fn=(1)", "* 1"]
        self.assertEqual(once.counts_by_function(lines), {"main": 26, "work": 400})


def row(commit, workload="w", instructions="", machine="m", seconds="", items="", digest="", compiler="c"):
    return {**dict.fromkeys(history.COLUMNS, ""), "commit": commit, "workload": workload, "compiler": compiler,
            "machine": machine, "instructions": instructions, "seconds": seconds, "items": items, "digest": digest}


class History(unittest.TestCase):
    def test_a_new_row_replaces_the_old_one_of_its_machine_and_of_an_unknown_one(self):
        old = [row("a", machine=""), row("a"), row("a", machine="other"), row("b"), row("a", workload="v")]
        new = [row("a", instructions="7")]
        self.assertEqual(history.merged(old, new), [old[2], old[3], old[4], new[0]])

    def test_a_new_row_takes_from_the_old_one_what_it_lacks(self):
        old = [row("a", seconds="2", items="5", instructions="6"), row("a", machine="", digest="0f", seconds="9")]
        found, = history.merged(old, [row("a", instructions="7")])
        self.assertEqual(found, row("a", instructions="7", seconds="2", items="5", digest="0f"))

    def test_rows_are_in_the_order_of_the_branch(self):
        rows = [row("b"), row("a", "x"), row("a", "w"), row("elsewhere")]
        order = [(each["commit"], each["workload"]) for each in history.in_order(rows, ["a", "b"])]
        self.assertEqual(order, [("elsewhere", "w"), ("a", "w"), ("a", "x"), ("b", "w")])

    def test_written_rows_are_read_again(self):
        rows = [row("a", instructions="5", digest="0f"), row("b")]
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "new", "workloads.csv")
            self.assertEqual(history.read(file), [])
            history.write(rows, file)
            self.assertEqual(history.read(file), rows)

    def test_a_damaged_file_is_refused_with_the_line(self):
        good = ",".join(history.COLUMNS) + "\na,c,m,w,5,,,,,\n"
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "workloads.csv")
            for line, text in ((1, ""), (1, "commit,workload\n"), (3, good + "<<<<<<< HEAD\n"), (3, good + "a,c,m\n"),
                               (3, good + "a,c,m,w,many,,,,,\n"), (3, good + "a,c,m,w,5,,,,,,one more\n")):
                safe_files.replace(file, text)
                with self.assertRaisesRegex(command.Failed, f"workloads.csv:{line}: "):
                    history.read(file)

    def test_a_file_that_cannot_be_written_is_as_before(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "workloads.csv")
            history.write([row("a")], file)
            with self.assertRaises(ValueError):
                history.write([row("b"), {**row("c"), "unknown": "5"}], file)
            with unittest.mock.patch("builtins.open", side_effect=OSError("no space left")), self.assertRaises(OSError):
                history.write([row("b")], file)
            self.assertEqual(history.read(file), [row("a")])

    def test_a_number_that_is_none_or_not_above_0_is_told_with_its_line(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "workloads.csv")
            for name, text in (("seconds", "0.00000"), ("seconds", "nan"), ("seconds", "inf"), ("instructions", "0"),
                               ("items", "-1"), ("bytes", "x")):
                history.write([row("a"), {**row("b"), name: text}], file)
                with self.assertRaisesRegex(command.Failed, "workloads.csv:3: this is not a row"):
                    history.read(file)

    def test_two_machines_have_one_point_for_the_instructions_of_a_commit(self):
        rows = [row("a", instructions="10"), row("a", machine="n", instructions="11"), row("b", instructions="12")]
        points = history.series(rows, ["a", "b"], history.instructions)["w"]
        self.assertEqual([(place, number) for place, number, _ in points], [(0, 11), (1, 12)])

    def test_a_series_has_no_gaps_for_what_was_not_measured_and_no_commits_of_other_branches(self):
        rows = [row("a", instructions="10"), row("b"), row("c", instructions="11"), row("z", instructions="99")]
        points = history.series(rows, ["a", "b", "c"], history.instructions)["w"]
        self.assertEqual([(place, number) for place, number, _ in points], [(0, 10), (2, 11)])

    def test_changes_are_steps_of_at_least_a_share(self):
        points = [(0, 100, "a"), (1, 100.5, "b"), (2, 102, "c"), (3, 99, "d")]
        self.assertEqual([(before[2], after[2]) for _, before, after in history.changes(points, 0.01)], [("b", "c"), ("c", "d")])

    def test_the_row_of_repetitions_has_the_least_time(self):
        runs = [{"workload": "w", "threads": 2, "seconds": s, "cpu_seconds": 1 / s, "items": 10, "triangles": True, "bytes": 400,
                 "cycles": None, "digest": "0123456789abcdef0123456789abcdef"} for s in (0.3, 0.1, 0.2)]
        found = track.row_of("0" * 40, "c", google.entries(runs, {"w/threads:2": 8}))
        self.assertEqual((found["workload"], found["seconds"], found["bytes"], found["instructions"], found["cycles"]),
                         ("w/threads:2", "0.10000", 400, 8, ""))
        self.assertEqual(found["digest"], "0123456789abcdef")
        self.assertEqual(found.keys(), set(history.COLUMNS))

    def test_on_one_thread_the_time_is_that_of_the_processor(self):
        run = {"workload": "w", "threads": 1, "seconds": 3, "cpu_seconds": 2, "items": 10, "triangles": False, "bytes": 0,
               "cycles": 5, "digest": None}
        found = track.row_of("0" * 40, "c", google.entries([run], {}))
        self.assertEqual((found["seconds"], found["bytes"], found["cycles"], found["digest"]), ("2.00000", "", 5, ""))
        self.assertEqual((once.seconds(run), once.seconds({**run, "threads": 2})), (2, 3))

    def test_a_row_of_a_table_has_the_time_of_the_clock_and_no_instructions(self):
        entry = {"run_name": "scaling/pipe/tiles/threads:2", "threads": 2, "real_time": 2e9, "items": 100,
                 "bytes_per_triangle": 50.5}
        found = track.row_of("0" * 40, "c", [entry])
        self.assertEqual((found["workload"], found["seconds"], found["bytes"], found["instructions"]),
                         ("scaling/pipe/tiles/threads:2", "2.00000", 5050, ""))

    def test_times_of_the_clock_on_a_busy_machine_are_left_out(self):
        def entry(time, stalled, threads):
            return {"run_name": "w", "threads": threads, "real_time": time, "cpu_time": time, "items": 1, "stalled": stalled}
        self.assertIsNone(track.row_of("0" * 40, "c", [entry(1e9, 0.5, 2), entry(2e9, 0.2, 2)]))
        self.assertEqual(track.row_of("0" * 40, "c", [entry(1e9, 0.5, 2), entry(2e9, 0.05, 2)])["seconds"], "2.00000")
        self.assertEqual(track.row_of("0" * 40, "c", [entry(1e9, 0.5, 1), entry(2e9, 0.05, 1)])["seconds"], "1.00000")

    def test_the_committed_history_has_one_valid_row_per_commit_workload_and_machine(self):
        rows = history.read()
        keys = [(each["commit"], each["workload"], each["compiler"], each["machine"]) for each in rows]
        self.assertEqual(len(keys), len(set(keys)))
        for each in rows:
            self.assertEqual(list(each), history.COLUMNS)
            self.assertTrue(each["instructions"] or float(each["seconds"]) > 0, each)

    def test_the_committed_history_has_the_instructions_of_the_gate_without_gaps(self):
        with open(os.path.join(commits.ROOT, "bench", "gate.json")) as file:
            of_gate = set(json.load(file)["workloads"])
        counted = {}  # in the order of the commits
        for each in history.read():
            if each["instructions"]:
                counted.setdefault(each["commit"], set()).add(each["workload"])
        self.assertGreaterEqual(len(counted), 20)
        for name in of_gate:  # a new workload is measured from some commit on
            has_it = [name in names for names in counted.values()]
            self.assertTrue(has_it[-1], name)
            self.assertEqual(has_it, sorted(has_it), name)

    def test_the_committed_history_is_in_the_order_of_the_commits(self):
        rows = history.read()
        try:
            line = commits.line_of()
        except command.Failed:
            self.skipTest("this is no git repository")
        if not set(row["commit"] for row in rows) <= {commit[:history.SHORT_COMMIT] for commit in line}:
            self.skipTest("this repository does not have all commits of the history")
        self.assertEqual(rows, history.in_order(rows, line))

    def test_the_committed_page_shows_the_committed_history(self):
        try:
            line = commits.line_of()
        except command.Failed:
            self.skipTest("this is no git repository")
        rows = history.read()
        if not set(row["commit"] for row in rows) <= {commit[:history.SHORT_COMMIT] for commit in line}:
            self.skipTest("this repository does not have all commits of the history")
        folder = os.path.dirname(history.FILE)
        for name, text in track.drawn().items():
            with open(os.path.join(folder, name)) as file:
                self.assertEqual(file.read(), text, f"{name}: bench/track --draw draws it again")


class Pressure(unittest.TestCase):
    def test_the_share_is_the_growth_of_the_stalled_time(self):
        stalled, clock = iter([10, 12.5]), iter([100, 110])
        self.assertEqual(pressure.Watch(lambda: next(stalled), lambda: next(clock)).share(), 0.25)

    def test_without_the_information_there_is_no_share(self):
        self.assertIsNone(pressure.Watch(lambda: None).share())
        self.assertIsNone(pressure.stalled_seconds("/no/such/file"))

    def test_the_total_of_some_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "cpu")
            with open(file, "w") as out:
                out.write("some avg10=99.50 avg60=99.70 avg300=99.34 total=5091707002\nfull avg10=0.00 total=0\n")
            self.assertAlmostEqual(pressure.stalled_seconds(file), 5091.707002)


class GoogleBenchmark(unittest.TestCase):
    RUN = {"workload": "w", "threads": 1, "seconds": 0.5, "cpu_seconds": 0.25, "items": 100, "triangles": True,
           "bytes": 3300, "cycles": 77, "digest": "ab"}

    def test_an_entry_has_the_keys_of_the_format_and_the_counters(self):
        entry, = google.entries([self.RUN], {"w": 123})
        for key in ("name", "run_name", "run_type", "repetitions", "repetition_index", "threads", "iterations"):
            self.assertIn(key, entry)
        self.assertEqual((entry["real_time"], entry["cpu_time"], entry["time_unit"]), (5e8, 2.5e8, "ns"))
        self.assertEqual((entry["items_per_second"], entry["bytes_per_triangle"]), (200, 33))
        self.assertEqual((entry["instructions"], entry["cycles"], entry["digest"]), (123, 77, "ab"))

    def test_what_was_not_measured_has_no_entry(self):
        entry, = google.entries([{**self.RUN, "cycles": None, "digest": None, "triangles": False}], {})
        self.assertFalse({"cycles", "digest", "instructions", "bytes_per_triangle", "stalled"} & entry.keys())

    def test_the_context_names_machine_compiler_and_commit(self):
        context = google.context("c0", "g++ 1", "once")
        self.assertEqual((context["commit"], context["compiler"], context["machine"]), ("c0", "g++ 1", history.machine()))


class Drawing(unittest.TestCase):
    ROWS = [row("a", instructions="1000", seconds="0.1", items="50", digest="d1"),
            row("b", instructions="1001", seconds="0.1", items="50", digest="d1"),
            row("c", instructions="1100", seconds="0.05", items="50", digest="d2"),
            row("a", workload="w/threads:2", seconds="0.1", items="50"),
            row("b", workload="w/threads:2", seconds="0.2", items="50"),
            row("c", workload="w/threads:2", seconds="0.4", items="50"),
            row("c", workload="other", instructions="5", compiler="c2"),
            row("a", machine="n", seconds="9", items="50"), row("b", machine="n", seconds="3", items="50")]

    def draw(self):
        return drawing.draw(self.ROWS, ["a", "b", "between", "c"], "c", self.between, lambda commit: f"<{commit}>")

    @staticmethod
    def between(before, after):
        """The commits that change what is measured: `a` and `between`, but not `b` and `c`."""
        return ["between", "a"] if (before, after) == ("b", "c") else []

    def test_the_drawing_is_xml_with_a_curve_for_counts_and_for_speeds_on_each_machine(self):
        root = xml.etree.ElementTree.fromstring(self.draw()[0])
        lines = root.findall(".//{http://www.w3.org/2000/svg}polyline")
        self.assertEqual([len(line.get("points").split()) for line in lines], [3, 3, 2, 3, 3])
        self.assertNotEqual(lines[1].get("stroke"), lines[2].get("stroke"))

    def test_the_speedup_is_the_speed_on_two_threads_divided_by_that_of_the_same_commit_on_one(self):
        self.assertIn("<title>&lt;c&gt;: 0.12</title>", self.draw()[0])  # 50 / 0.4 s, divided by 50 / 0.05 s
        alone = [(0, 10.0, row("a")), (1, 10.0, row("b"))]
        together = [(1, 15.0, row("b")), (2, 30.0, row("c"))]
        self.assertEqual([(place, ratio) for place, ratio, _ in drawing.speedups(alone, together)], [(1, 1.5)])

    def test_machines_are_not_compared_with_each_other(self):
        page = self.draw()[1]
        changes = re.findall(r"<tr><td>w</td><td>(\S+) %</td>", page)
        self.assertEqual(changes, ["+9.9", "+100.0"])  # of the instructions, and of the speed on m

    def test_the_page_shows_the_drawing_that_lies_beside_it(self):
        picture, page = self.draw()
        self.assertIn(f'data="{drawing.PICTURE}"', page)
        self.assertNotIn("<polyline", page)

    def test_the_page_names_the_commit_that_changed_a_workload(self):
        page = self.draw()[1]
        commit = "one of 2, the last of them: &lt;between&gt;"
        self.assertIn(f"<tr><td>w</td><td>+9.9 %</td><td>b</td><td>{commit}</td><td>another</td></tr>", page)
        self.assertIn(f"<tr><td>w</td><td>+100.0 %</td><td>b</td><td>{commit}</td><td>another</td></tr>", page)

    def test_one_suspect_is_named_alone_and_without_any_the_measured_commit_is_named(self):
        points = [(0, 1, row("a")), (1, 2, row("b"))]
        self.assertEqual(drawing.origin(*points, lambda *_: ["x"], str), "x")
        self.assertEqual(drawing.origin(*points, lambda *_: [], str), "measured at b")

    def test_a_change_of_the_speed_is_named_only_if_the_instructions_changed_too(self):
        page = self.draw()[1]
        self.assertIn("<tr><td>w/threads:2</td><td>-50.0 %</td><td>b</td>", page)
        self.assertEqual(page.count("<tr><td>"), 3)

    def test_counts_of_another_compiler_are_not_in_a_curve(self):
        self.assertNotIn("other", self.draw()[0])

    def test_an_empty_history_can_be_drawn(self):
        xml.etree.ElementTree.fromstring(drawing.draw([], [], "c", lambda *_: [], str)[0])


class Commits(unittest.TestCase):
    def test_the_present_workloads_replace_those_of_a_commit(self):
        who = {"GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a"}
        with tempfile.TemporaryDirectory() as root, unittest.mock.patch.dict(os.environ, who), \
                unittest.mock.patch.object(commits, "ROOT", root):
            def git(*arguments):
                return commits.git(*arguments, cwd=root)

            def write(name, text):
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                with open(os.path.join(root, name), "w") as file:
                    file.write(text)
            git("init", "-q", "-b", "main")
            write("CMakeLists.txt", "project(old)\n")
            git("add", ".")
            git("commit", "-q", "-m", "old")
            write("bench/workloads/once.cpp", "present")
            tree = os.path.join(root, "build", "tree")
            commits.check_out(git("rev-parse", "HEAD"), tree)
            with open(os.path.join(tree, "bench", "workloads", "once.cpp")) as file:
                self.assertEqual(file.read(), "present")
            with open(os.path.join(tree, "CMakeLists.txt")) as file:
                self.assertEqual(file.read(), "project(old)\nadd_subdirectory(bench/workloads)\n")

    def test_only_commits_that_change_what_is_measured_are_suspects(self):
        with tempfile.TemporaryDirectory() as root, unittest.mock.patch.object(commits, "ROOT", root):
            def commit(name):
                os.makedirs(os.path.join(root, os.path.dirname(name)), exist_ok=True)
                with open(os.path.join(root, name), "a") as file:
                    file.write("text\n")
                commits.git("add", ".")
                commits.git("-c", "user.name=a", "-c", "user.email=a", "commit", "-q", "-m", name)
                return commits.git("rev-parse", "HEAD")
            commits.git("init", "-q", "-b", "main")
            first, second, _, fourth, last = map(commit, ("core/a", "parallel/b", "tests/c", "core/d", "docs/e"))
            self.assertEqual(commits.changes_between(first, last), [fourth, second])
            self.assertEqual(commits.changes_between(fourth, last), [])
            self.assertEqual(commits.changes_between("0" * 40, last), [])

    def test_an_unknown_commit_is_an_error(self):
        with self.assertRaisesRegex(command.Failed, "no such commit"):
            commits.resolve("no-such-branch-here")


if __name__ == "__main__":
    unittest.main()
