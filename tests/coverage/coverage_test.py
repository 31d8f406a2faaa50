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


def gcovr_line(number, count, branches=(), noncode=False):
    return {"line_number": number, "count": count, "branches": [{"count": n} for n in branches], "gcovr/noncode": noncode}


def lines(file, covered, missed=0, branches=0, taken=0):
    """Lines of a file, the first of which has all branches."""
    found = [coverage.Line(file, i + 1, i < covered, 0, 0) for i in range(covered + missed)]
    return [found[0]._replace(branches=branches, taken=taken)] + found[1:]


class Coverage(unittest.TestCase):
    def test_lines_without_code_do_not_count(self):
        gcovr = {"files": [{"file": "core/a.cpp", "lines": [gcovr_line(1, 5, (3, 0)), gcovr_line(2, 0),
                                                             gcovr_line(3, 0, noncode=True)]}]}
        self.assertEqual(coverage.lines_of(gcovr), [("core/a.cpp", 1, True, 2, 1), ("core/a.cpp", 2, False, 0, 0)])

    def test_a_folder_has_a_row_of_its_own_and_its_parent_has_one_for_all(self):
        rows = coverage.table(lines("core/a.cpp", 3, 1, 4, 3) + lines("core/formats/b.cpp", 1, 3))
        self.assertEqual(rows[:3], [("core, all", 8, 50, 4, 75), ("core", 4, 75, 4, 75), ("core/formats", 4, 25, 0, 100)])

    def test_a_floor_that_is_not_met_is_named(self):
        good = lines("core/a.cpp", 95, 5, 10, 9) + lines("parallel/arithmetic/p.hpp", 10) + lines("properties/checker/c.cpp", 1)
        self.assertEqual(coverage.below_floors(good), [])
        self.assertEqual(coverage.below_floors(good + lines("core/b.cpp", 1, 1)),
                         ["core: 94.12 % of the lines, at least 95 % are required"])
        self.assertEqual(coverage.below_floors(good + lines("core/b.cpp", 1, 0, 10, 8)),
                         ["core: 85.00 % of the branches, at least 90 % are required"])
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
