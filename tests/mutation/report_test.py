"""The report, the choice of tests, and the search for places that do not compile."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from mutation import build, report, trials


def row(result, number=0, file="parallel/refinement/task.cpp"):
    return {"number": number, "file": file, "line": 7, "function": "f", "text": "a < b", "mutant": "< becomes <=",
            "result": result}


class Report(unittest.TestCase):
    def test_the_score_is_the_share_of_the_mutants_that_a_test_noticed(self):
        rows = [row(r) for r in ("failed", "crashed", "time-out", "survived", "never evaluated")]
        self.assertEqual(report.score(rows).strip(), "60.0")

    def test_an_equivalent_mutant_does_not_count(self):
        rows = [row("survived"), row("failed")]
        known = {report.key(rows[0]): "both sides are equal only if …"}
        text = report.text(rows, known)
        self.assertRegex(text, r"all +2 +1 +0 +0 +0 +0 +1 +100\.0")
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

    def test_the_quickest_program_comes_first(self):
        slow, quick = self.program("exit 0"), self.program("exit 1")
        tests = [trials.Test("a", slow, "", 5), trials.Test("b", quick, "", 2), trials.Test("c", quick, "", 2)]
        self.assertEqual([[t.name for t in group] for group in trials.by_program(tests)], [["b", "c"], ["a"]])

    def test_a_mutant_ends_as_its_first_test_that_notices_it(self):
        def result(script):
            return trials.try_mutant(1, [trials.Test("t", self.program(script), "", 0)])
        self.assertEqual(result("exit 0"), ("survived", ""))
        self.assertEqual(result("echo '[  FAILED  ] Suite.sentence, where'; exit 1"), ("failed", "Suite.sentence"))
        self.assertEqual(result("echo '[ RUN      ] Suite.sentence'; kill -SEGV $$"), ("crashed", "Suite.sentence"))

    def test_a_program_that_runs_too_long_is_stopped(self):
        self.assertEqual(trials.run(self.program("sleep 60"), [], 0.1, {}), (None, ""))

    def test_a_program_gets_the_number_of_its_mutant(self):
        self.assertEqual(trials.try_mutant(7, [trials.Test("t", self.program("exit $PARDEL_MUTATION"), "", 0)])[0], "crashed")


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
