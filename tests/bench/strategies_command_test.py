"""bench/strategies from end to end: with the programs that count and model, and with one whose runs fail."""
import json
import os
import sys
import tempfile
import unittest
import unittest.mock

from measuring.strategies import share
from script import call, load

strategies = load("strategies")

MACHINE = {"name": "a slow machine", "seconds_per_triangle": 1, "latency": 0, "bandwidth": 1e9}

# Stands for count_schemes. What a run is like is the name of its scheme.
COUNTS = f"#!{sys.executable}" + """
import json, sys
if "--list" in sys.argv:
    print(json.dumps({"schemes": [{"name": n, "title": n, "refines": True} for n in ("good", "uncertified", "failed")],
                      "inputs": ["square"]}))
else:
    asked = dict(zip(sys.argv[1::2], sys.argv[2::2]))
    line = {"scheme": asked["--scheme"], "refines": True, "input": "square", "size": 100, "workers": 1}
    if asked["--scheme"] == "failed":
        line["error"] = "no mesh"
    else:
        line.update(dict.fromkeys(["triangles", "sequential", "work", "wasted", "critical", "before", "parallelism",
                                   "rounds", "barriers", "set_backs", "messages", "bytes", "most_held",
                                   "smallest_angle"], 1))
        line["certified"] = asked["--scheme"] == "good"
    print(json.dumps(line))
"""


class Strategies(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.machine = os.path.join(self.folder, "machine.json")
        with open(self.machine, "w", encoding="utf-8") as out:
            json.dump(MACHINE, out)

    def call(self, *arguments, count_schemes=os.environ["COUNT_SCHEMES"]):
        programs = {"count_schemes": count_schemes, "scheme_seconds": os.environ["SCHEME_SECONDS"]}
        with unittest.mock.patch.object(strategies, "build"), \
                unittest.mock.patch.object(strategies, "program", lambda preset, name: programs[name]):
            return call(strategies, *(str(word) for word in arguments))

    def small(self, *arguments, out="out"):
        """Some schemes on two inputs."""
        return self.call("--schemes", "given-points", "exact", "one-worker", "--inputs", "random", "square", "--sizes",
                         400, 200, "--workers", 3, 1, "--out", os.path.join(self.folder, out), *arguments)

    def read(self, *names):
        with open(os.path.join(self.folder, *names), encoding="utf-8") as file:
            return file.read()

    def runs(self, folder="out"):
        return json.loads(self.read(folder, "strategies.json"))["runs"]

    def faked(self):
        program = os.path.join(self.folder, "count_schemes")
        with open(program, "w", encoding="utf-8") as out:
            out.write(COUNTS)
        os.chmod(program, 0o755)
        return program

    def test_every_scheme_runs_on_its_inputs_with_these_sizes_and_workers(self):
        code, printed = self.small()
        self.assertEqual(code, 0, printed)
        self.assertIn("20 runs, 0 without a certificate", printed)
        asked = [(domain, size, scheme, workers) for domain in ("random", "square") for size in (200, 400)
                 for scheme in ("given-points", "exact", "one-worker") for workers in (1, 3)
                 if scheme != "given-points" or domain == "random"]  # it meets no bounds
        self.assertEqual([(r["input"], r["size"], r["scheme"], r["workers"]) for r in self.runs()], asked)
        for run in self.runs():
            self.assertLess(abs(run["triangles"] / run["size"] - 1), 0.5, run)

    def test_the_page_and_the_pictures_are_those_of_the_runs(self):
        self.small()
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "out"))),
                         ["parallelism.svg", "strategies.json", "strategies.md", "winners.svg"])
        self.assertIn("## random, 400 triangles, 3 workers", self.read("out", "strategies.md"))
        self.assertIn("a cluster", self.read("out", "strategies.md"))
        self.assertIn("Parallelism: all work", self.read("out", "parallelism.svg"))
        self.assertIn("The fastest scheme in the model of a cluster", self.read("out", "winners.svg"))

    def test_another_machine_has_other_seconds(self):
        self.small("--machine", self.machine)
        for run in self.runs():
            self.assertLess(share(abs(run["seconds"] - run["critical"]), run["critical"]), 1e-3, run)
        for name in ("strategies.md", "winners.svg"):
            self.assertIn(MACHINE["name"], self.read("out", name))

    def test_drawing_again_counts_nothing_and_takes_the_machine_that_is_given(self):
        self.small()
        counts = [{**run, "seconds": None} for run in self.runs()]
        with unittest.mock.patch.object(strategies, "counted", side_effect=AssertionError):
            code, printed = self.call("--again", os.path.join(self.folder, "out"), "--machine", self.machine)
        self.assertEqual(code, 0, printed)
        self.assertEqual([{**run, "seconds": None} for run in self.runs()], counts)
        for run in self.runs():
            self.assertLess(share(abs(run["seconds"] - run["critical"]), run["critical"]), 1e-3, run)
        self.assertIn(MACHINE["name"], self.read("out", "strategies.md"))
        self.assertEqual(json.loads(self.read("out", "strategies.json"))["machine"], MACHINE)

    def test_runs_without_a_certificate_are_told_and_make_it_fail(self):
        for scheme, told in (("uncertified", "not certified"), ("failed", "no mesh")):
            code, printed = self.call("--schemes", "good", scheme, "--sizes", 100, "--workers", 1, "--out",
                                      os.path.join(self.folder, scheme), count_schemes=self.faked())
            self.assertEqual(code, 1, printed)
            self.assertIn(f"{scheme} on square, 100, 1 workers: {told}", printed)
            self.assertNotIn("good on square", printed)
            self.assertIn("2 runs, 1 without a certificate", printed)
            self.assertEqual([run["scheme"] for run in self.runs(scheme)], ["good", scheme])

    def test_if_all_runs_fail_all_are_told(self):
        code, printed = self.call("--schemes", "failed", "--sizes", 100, "--workers", 1, "--out",
                                  os.path.join(self.folder, "none"), count_schemes=self.faked())
        self.assertEqual(code, 1, printed)
        self.assertIn("1 runs, 1 without a certificate", printed)

    def test_unknown_names_are_refused(self):
        for option, what in (("--schemes", "scheme"), ("--inputs", "input")):
            code, printed = self.call(option, "moon", "--out", os.path.join(self.folder, "out"))
            self.assertEqual(code, 1)
            self.assertIn(f"there is no {what} moon", printed)
            self.assertEqual(os.listdir(os.path.join(self.folder, "out")), [])


if __name__ == "__main__":
    unittest.main()
