"""What scripts/coverage computes from the counters."""
import importlib.machinery
import importlib.util
import os
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
loader = importlib.machinery.SourceFileLoader("coverage", os.path.join(ROOT, "scripts", "coverage"))
coverage = importlib.util.module_from_spec(importlib.util.spec_from_loader("coverage", loader))
loader.exec_module(coverage)


def lines(file, covered, missed=0, branches=0, taken=0):
    """Lines of a file, the first of which has all branches."""
    found = [coverage.Line(file, i + 1, i < covered, 0, 0) for i in range(covered + missed)]
    return [found[0]._replace(branches=branches, taken=taken)] + found[1:]


class Coverage(unittest.TestCase):
    def test_a_line_counts_what_reaches_it_from_above_and_what_begins_there(self):
        # 1: f() {  2: if (a)  3: g();  4: h(); }   5 has no code. g() was not executed.
        segments = [[1, 5, 7, True, True, False], [2, 8, 0, True, True, True], [3, 5, 0, True, True, False],
                    [3, 8, 7, True, False, False], [4, 12, 0, False, False, False]]
        self.assertEqual(coverage.lines_with_counts(segments), {1: 7, 2: 7, 3: 0, 4: 7})

    def test_an_outcome_in_one_instance_of_a_template_counts(self):
        instances = [[3, 7, 3, 9, 4, 0, 0, 0, 4], [3, 7, 3, 9, 0, 2, 0, 0, 4], [3, 13, 3, 15, 5, 0, 0, 0, 4]]
        self.assertEqual(coverage.branches_at_lines(instances), {3: [4, 3]})

    def test_a_condition_that_the_compiler_decides_is_no_branch(self):
        text = ["  if (a)", "  if constexpr (f(n) && m)", "  if constexpr (n) return b ? 1 : 2;"]
        run = [[1, 7, 1, 8, 4, 0, 0, 0, 4], [3, 27, 3, 28, 4, 0, 0, 0, 4]]
        decided = [[2, 17, 2, 21, 5, 0, 0, 0, 4], [2, 25, 2, 26, 5, 0, 0, 0, 4], [3, 17, 3, 18, 5, 0, 0, 0, 4]]
        self.assertEqual(coverage.decided_when_run(run + decided, text), run)

    def test_a_file_with_two_names_counts_once(self):
        def file(name, count, when_false):
            return {"filename": name, "branches": [[2, 1, 2, 3, 1, when_false, 0, 0, 4]],
                    "segments": [[1, 1, count, True, True, False], [2, 9, 0, False, False, False]]}
        found = coverage.lines_of({"data": [{"files": [file(os.path.join(ROOT, "core", "a.cpp"), 0, 0),
                                                       file("build/coverage/../../core/a.cpp", 3, 0),
                                                       file("/usr/include/core/b.hpp", 1, 1)]}]},
                                  lambda name: ["", "  if (a)"])
        self.assertEqual(found, [("core/a.cpp", 1, True, 0, 0), ("core/a.cpp", 2, True, 2, 1)])
        self.assertEqual(coverage.undecided(found, lambda name: ["", "  if (a)"]), ["core/a.cpp:2: 1 of 2: if (a)"])

    def test_a_folder_has_a_row_of_its_own_and_its_parent_has_one_for_all(self):
        rows = coverage.table(lines("core/a.cpp", 3, 1, 4, 3) + lines("core/formats/b.cpp", 1, 3))
        self.assertEqual(rows[:3], [("core, all", 8, 50, 4, 75), ("core", 4, 75, 4, 75), ("core/formats", 4, 25, 0, 100)])

    def test_a_floor_that_is_not_met_is_named(self):
        good = lines("core/a.cpp", 95, 5, 10, 9) + lines("parallel/arithmetic/p.hpp", 10) + \
            lines("distributed/d.cpp", 1) + lines("properties/checker/c.cpp", 1)
        self.assertEqual(coverage.below_floors(good), [])
        self.assertEqual(coverage.below_floors(good + lines("core/b.cpp", 1, 1)),
                         ["core: 94.12 % of the lines, at least 95 % are required"])
        self.assertEqual(coverage.below_floors(good + lines("core/b.cpp", 1, 0, 10, 8)),
                         ["core: 85.00 % of the branches, at least 90 % are required"])
        self.assertEqual(coverage.below_floors(good + lines("parallel/arithmetic/q.hpp", 1, 0, 200, 199)),
                         ["parallel/arithmetic: 99.50 % of the branches, at least 100 % are required"])
        self.assertEqual(coverage.below_floors(good + lines("parallel/arithmetic/q.hpp", 199, 1)),
                         ["parallel/arithmetic: 99.52 % of the lines, at least 100 % are required"])

    def test_accepted_lines_are_not_listed_and_those_that_are_executed_now_are_named(self):
        source = {"core/a.cpp": ["int f() {", "  return 1;", "  abort();"]}
        accepted = {("core/a.cpp", "abort();"): "r", ("core/a.cpp", "gone();"): "r"}
        found = coverage.uncovered(lines("core/a.cpp", 1, 2), accepted, source.get)
        self.assertEqual(found, (["core/a.cpp:2: return 1;"], 1, [("core/a.cpp", "gone();")]))

    def test_the_comment_above_accepted_lines_is_their_reason(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "accepted")

            def write(text):
                with open(file, "w") as out:
                    out.write(text)
            write("# Title.\n\n# It ends\n# the process.\ncore/a.cpp: if (a | b) abort();\ncore/b.cpp: f(x);\n")
            reason = "It ends the process."
            self.assertEqual(coverage.read_accepted(file),
                             {("core/a.cpp", "if (a | b) abort();"): reason, ("core/b.cpp", "f(x);"): reason})
            write("# A reason.\n\ncore/a.cpp: f();\n")
            with self.assertRaisesRegex(SystemExit, "without a reason"):
                coverage.read_accepted(file)

    def test_each_accepted_line_exists(self):
        for name, text in coverage.read_accepted():
            self.assertIn(text, [line.strip() for line in coverage.read_source(name)])


if __name__ == "__main__":
    unittest.main()
