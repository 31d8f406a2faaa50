"""The report, the choice of tests, and the search for places that do not compile."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

from mutation import build, report, sites, trials


def row(result, number=0, file="parallel/refinement/task.cpp"):
    return {"number": number, "file": file, "line": 7, "function": "f", "text": "a < b", "mutant": "< becomes <=",
            "result": result}


class Report(unittest.TestCase):
    def test_the_score_is_the_share_of_the_mutants_that_a_test_noticed(self):
        rows = [row(r) for r in ("failed", "crashed", "time-out", "survived", "not decided")]
        self.assertEqual(report.score(rows).strip(), "60.0")

    def test_an_equivalent_mutant_does_not_count(self):
        rows = [row("survived"), row("failed")]
        known = {report.key(rows[0]): "both sides are equal only if …"}
        text = report.text(rows, known)
        self.assertRegex(text, r"all +2 +1 +0 +0 +0 +0 +0 +1 +100\.0")
        self.assertNotIn("task.cpp:7", text)

    def test_a_survivor_is_listed_with_its_place(self):
        self.assertIn("parallel/refinement/task.cpp:7 | f | a < b | < becomes <= | survived", report.text([row("survived")], {}))

    def test_the_list_of_equivalent_mutants_has_five_columns(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "equivalent"
            file.write_text("# comment\n\na.cpp | f | x < y | < becomes <= | both give 0\n")
            self.assertEqual(report.equivalents(file), {("a.cpp", "f", "x < y", "< becomes <="): "both give 0"})


class Trials(unittest.TestCase):
    @staticmethod
    def program(script):
        return trials.Program(("sh", "-c", script), "/")

    def test_tests_of_one_program_run_together_for_a_second_the_quickest_first(self):
        a, b = self.program("a"), self.program("b")
        tests = [trials.Test(name, program, name, seconds, mutants=1) for name, program, seconds in
                 (("long", a, 5), ("half", a, 0.5), ("third", a, 0.3), ("other", b, 0.1), ("more", a, 0.4))]
        self.assertEqual([[t.name for t in chunk] for chunk in trials.chunks(tests)],
                         [["other"], ["third", "more"], ["half"], ["long"]])

    def test_of_equally_quick_tests_the_one_that_evaluates_fewer_mutants_comes_first(self):
        tests = [trials.Test(name, self.program(name), name, 0.1, mutants=mutants) for name, mutants in
                 (("all", 2000), ("room", 30), ("library", 400))]
        self.assertEqual([chunk[0].name for chunk in trials.chunks(tests)], ["room", "library", "all"])

    def test_tests_with_another_number_of_cases_run_apart(self):
        program = self.program("")
        tests = [trials.Test("few", program, "few", 0.1, 100), trials.Test("all", program, "all", 0.2)]
        self.assertEqual(trials.chunks(tests), [[tests[0]], [tests[1]]])

    def test_a_test_that_noticed_mutants_of_the_same_function_comes_first(self):
        def site(file, function):
            return sites.Site(file, 1, function, [], [])
        killers, tests = trials.Killers(), [trials.Test(name, self.program(""), name, 0.1) for name in "abcd"]
        for place, test in ((("x.cpp", "f"), "b"), (("x.cpp", "g"), "c"), (("y.cpp", "f"), "d")):
            killers.add(site(*place), test)
        order = trials.in_order(site("x.cpp", "f"), tests, killers)
        self.assertEqual([[t.name for t in chunk] for chunk in order], [["b"], ["c"], ["d"], ["a"]])

    def trial(self, *scripts, **limits):
        groups = [[trials.Test("t", self.program(script), "")] for script in scripts]
        return trials.try_mutant(7, groups, **limits)[:2]

    def test_a_mutant_ends_as_its_first_test_that_notices_it(self):
        self.assertEqual(self.trial("exit 0"), ("survived", ""))
        self.assertEqual(self.trial("exit 0", "exit 1"), ("failed", "t"))
        self.assertEqual(self.trial("echo '[  FAILED  ] Suite.sentence, where'; exit 1"), ("failed", "Suite.sentence"))
        self.assertEqual(self.trial("echo '[ RUN      ] Suite.sentence'; kill -SEGV $$"), ("crashed", "Suite.sentence"))
        self.assertEqual(self.trial(), ("never evaluated", ""))

    def test_a_program_that_computes_too_long_is_stopped(self):
        self.assertEqual(self.trial("while :; do :; done"), ("time-out", "t"))

    def test_interrupts_reach_a_test_also_if_the_run_ignores_them(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.SIG_IGN))
        self.assertEqual(self.trial("kill -INT $$; exit 0"), ("crashed", "t"))

    def test_a_mutant_whose_tests_take_too_long_is_not_decided(self):
        self.assertEqual(self.trial("exit 0", "exit 1", most_seconds=0), ("not decided", ""))

    def test_a_program_gets_the_number_of_its_mutant(self):
        self.assertEqual(self.trial("exit $PARDEL_MUTATION")[0], "crashed")

    def test_a_property_that_fails_with_few_cases_gets_the_usual_number(self):
        def traced(script):
            result = trials.trace(trials.Test("t", self.program(script), ""), 100)
            return result.passed, result.cases
        self.assertEqual(traced("exit 0"), (True, 100))
        self.assertEqual(traced("case $RC_PARAMS in *max_success*) exit 1;; esac"), (True, 0))
        self.assertEqual(traced("exit 1"), (False, 0))

    def test_a_test_is_traced_again_only_if_its_program_changes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "program"
            file.write_text("#!/bin/sh\necho 5 > $PARDEL_MUTATION_TRACE/trace\n")
            file.chmod(0o755)
            test, traces = trials.Test("t", trials.Program((str(file),), folder), ""), {}
            trials.trace_all([test], 0, traces, 1)
            first = traces.copy()
            trials.trace_all([test], 0, traces, 1)
            self.assertEqual(traces, first)
            reaching, failing = trials.tests_of_mutants([test], 0, traces)
            self.assertEqual(([t.name for t in reaching[5]], failing), (["t"], []))
            os.utime(file, ns=(0, 0))
            trials.trace_all([test], 0, traces, 1)
            self.assertEqual(len(traces), 2)


class Copy(unittest.TestCase):
    def test_new_tests_come_to_a_copy_whose_mutated_sources_stay(self):
        with tempfile.TemporaryDirectory() as folder:
            root, copy = pathlib.Path(folder) / "project", pathlib.Path(folder) / "copy"
            for name, text in {"core/a.cpp": "old", "core_test.cpp": "old", "same.cpp": "same"}.items():
                for place, content in {root: text.replace("old", "new"), copy: text}.items():
                    (place / name).parent.mkdir(parents=True, exist_ok=True)
                    (place / name).write_text(content)
            subprocess.run(["git", "init", "-q", str(root)], check=True)
            before = (copy / "same.cpp").stat().st_mtime_ns
            build.copy_project(root, copy, without=["core"])
            self.assertEqual((copy / "core/a.cpp").read_text(), "old")
            self.assertEqual((copy / "core_test.cpp").read_text(), "new")
            self.assertEqual((copy / "same.cpp").stat().st_mtime_ns, before, "what has not changed is not built again")


class Again(unittest.TestCase):
    def test_without_an_earlier_run_nothing_is_copied_or_built(self):
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(build.__file__).parent.parent / "mutate"
            ran = subprocess.run([sys.executable, script, "core", "--again", "--folder", folder], capture_output=True,
                                 text=True)
            self.assertEqual(ran.returncode, 1)
            self.assertIn("there is no earlier run with these arguments", ran.stderr)
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])


class BrokenLines(unittest.TestCase):
    def test_are_those_that_the_compiler_names_with_an_error(self):
        source = pathlib.Path("/copy/source")
        output = ("/copy/source/core/a.hpp:12:5: error: no match\n/copy/source/core/a.hpp:13:5: warning: unused\n"
                  "../source/ref/b.cpp:7:1:   required from here\n/elsewhere/c.hpp:1:1: error: x\n")
        self.assertEqual(build.broken_lines(output, source, pathlib.Path("/copy/build")),
                         {("core/a.hpp", 12), ("ref/b.cpp", 7)})


if __name__ == "__main__":
    unittest.main()
