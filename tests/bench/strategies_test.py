"""The programs that count what parallel schemes cost, and turn that into seconds."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

from measuring import commits, strategies
from some_run import some_run

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

    def test_each_number_of_workers_has_the_counts_of_a_run_of_its_own(self):
        for scheme in known()["schemes"]:
            arguments = ("--scheme", scheme["name"], "--input", "random", "--triangles", 600, "--workers")
            self.assertEqual(counts(*arguments, 6, 1), counts(*arguments, 6) + counts(*arguments, 1))

    def test_another_seed_draws_other_priorities(self):
        arguments = ("--scheme", "exact", "--triangles", 1000, "--workers", 4)
        self.assertNotEqual(counts(*arguments, "--seed", 1), counts(*arguments, "--seed", 2))

    def test_meshes_have_about_as_many_triangles_as_asked_for(self):
        for domain, triangles in (("square", 3000), ("pipe", 10000), ("key", 10000), ("random", 3000)):
            line, = counts("--scheme", "one-worker", "--input", domain, "--triangles", triangles)
            self.assertLess(abs(line["triangles"] / triangles - 1), 1 / 3, line)
        for domain in strategies.POINT_SETS:
            line, = counts("--scheme", "given-points", "--input", domain, "--triangles", 3000)
            self.assertLess(abs(line["triangles"] / 3000 - 1), 0.05, line)

    def test_counts_have_their_names(self):
        line, = counts("--scheme", "one-worker", "--triangles", 1000)
        self.assertEqual([line[key] for key in ("work", "wasted", "rounds", "barriers", "set_backs")], [0] * 5)
        self.assertEqual((line["critical"], line["before"]), (line["sequential"], line["sequential"]))
        self.assertEqual(line["most_held"], line["triangles"])
        line, = counts("--scheme", "exact", "--triangles", 1000, "--workers", 6)  # nothing is set back
        self.assertEqual(line["set_backs"], 0)
        self.assertGreaterEqual(line["barriers"], 3 * line["rounds"])  # to propose, to choose, and to insert
        self.assertEqual((line["messages"] > 0, line["bytes"] % 56), (True, 0))
        self.assertGreater(line["work"], line["wasted"])
        self.assertAlmostEqual(line["parallelism"], (line["sequential"] + line["work"]) / line["critical"])

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

    def test_every_scheme_has_a_colour_of_its_own(self):
        self.assertGreaterEqual(len(set(strategies.COLOURS)), len(known()["schemes"]))

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



if __name__ == "__main__":
    unittest.main()
