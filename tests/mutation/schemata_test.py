"""The mutants of sample.cpp: they are found, one build contains all of them, and each changes what it says."""
import os
import pathlib
import subprocess
import tempfile
import unittest

from mutation import build, report, rewrite, sites

FOLDER = pathlib.Path(__file__).resolve().parent


def variables(**more):
    return {k: v for k, v in os.environ.items() if not k.startswith("PARDEL_MUTATION")} | more


class Schemata(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        found = sites.find_sites(FOLDER / "sample.cpp", ["-std=c++20"], FOLDER, ["."])["sample.cpp"]
        cls.mutants = {}
        pairs = build.numbered(found)
        for number, site in pairs:
            for i, what in enumerate(site.mutants):
                cls.last = number + i
                cls.mutants[site.function, report.snippet(FOLDER, site), what] = number + i
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        source, cls.program = pathlib.Path(cls.place.name) / "sample.cpp", pathlib.Path(cls.place.name) / "sample"
        source.write_bytes(rewrite.with_mutants((FOLDER / "sample.cpp").read_bytes(), pairs))
        subprocess.run([os.environ.get("CXX", "g++"), "-std=c++20", "-include", build.SCHEMATA, source, "-o", cls.program],
                       check=True)

    def output(self, *mutant, **more):
        number = {"PARDEL_MUTATION": str(self.mutants[mutant])} if mutant else {}
        return subprocess.run([self.program], env=variables(**number, **more), check=True, capture_output=True,
                              text=True).stdout.split()

    def expect(self, place, value, *mutant):
        """The mutant changes one printed value."""
        expected = self.output()
        self.assertNotEqual(expected[place], value)
        expected[place] = value
        self.assertEqual(self.output(*mutant), expected)

    def test_a_program_without_a_mutant_does_what_the_source_says(self):
        self.assertEqual(self.output(), "0 0 0 1 2 14 -4 8 8 3 1.45455".split())

    def test_each_mutant_changes_what_it_says(self):
        self.expect(1, "1", "is_equal", "a == b", "== is negated")
        self.expect(3, "0", "is_outside", "!inside", "! is left out")
        self.expect(2, "1", "is_between", "is_less(b, c)", "the right operand of && is left out")
        self.expect(5, "16", "with_seven", "7", "the constant becomes the next one")
        self.expect(5, "9", "with_seven", "7 * a", "* becomes +")
        self.expect(6, "4", "opposite", "-a", "the sign is left out")
        self.expect(7, "-8", "reversed_difference", "b", "b and a are swapped")
        self.expect(8, "4", "number_of_steps", "is_small(n)", "the condition is negated")
        self.expect(8, "10", "number_of_steps", "continue", "continue is left out")
        self.expect(8, "4", "number_of_steps", "steps += i", "the statement is left out")
        self.expect(8, "0", "number_of_steps", "steps += i", "+= becomes -=")
        self.expect(8, "0", "number_of_steps", "number_of_steps()", "the function returns at once")
        self.expect(10, "0.727273", "nested", "a + b", "+ becomes -")
        self.expect(10, "44", "nested", "(a + b) * (a - b) / (a + 2.5)", "/ becomes *")
        self.expect(10, "1", "nested", "2.5", "the constant is doubled")

    def test_a_comparison_has_two_mutants(self):
        self.assertEqual(self.output("is_below", "a < b", "< becomes <=")[0], "1")
        self.assertEqual(self.output("is_below", "a < b", "< is negated")[0], "1")

    def test_constants_of_the_compiler_have_no_mutants(self):
        self.assertFalse([m for m in self.mutants if m[0] != "main" and m[1] in ("4", "4 - 1", "limit < 5")])
        self.assertFalse([m for m in self.mutants if m[0] == "six"])
        self.assertFalse([m for m in self.mutants if m[0] == "two_names" and m[1] == "2"])

    def test_texts_have_no_minus(self):
        self.assertFalse([m for m in self.mutants if m[0] in ("two_names", "longer") and "+" in m[2]])

    def test_nothing_that_is_never_evaluated_or_has_no_order_has_a_mutant(self):
        found = [m[1:] for m in self.mutants if m[0] == "of_a_type"]
        self.assertIn(("sum + std::min(a, b)", "+ becomes -"), found)
        self.assertFalse([m for m in found if m[0] in ("a + 1", "1", "a")])

    def test_a_trace_contains_the_evaluated_mutants(self):
        with tempfile.TemporaryDirectory() as folder:
            self.output(PARDEL_MUTATION_TRACE=folder)
            reached = {int(n) for file in pathlib.Path(folder).iterdir() for n in file.read_text().split()}
        self.assertIn(self.mutants["is_below", "a < b", "< becomes <="], reached)
        self.assertNotIn(self.mutants["never_called", "a", "the condition is negated"], reached)
        self.assertLessEqual(reached, set(range(1, self.last + 1)))


if __name__ == "__main__":
    unittest.main()
