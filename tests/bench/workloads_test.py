"""The program that runs one workload, and the comparison of two programs by real runs. ONCE names the program."""
import os
import random
import subprocess
import unittest

from measuring import commits, once
from script import load

PROGRAM = os.environ["ONCE"]
OF_ONE_MESH = ["check", "files", "write_node", "read_node", "write_vtu", "read_vtu", "write_msh", "read_msh"]


def counted(workload, threads=1):
    return once.run(PROGRAM, workload, threads, timed=False)


class Workloads(unittest.TestCase):
    def test_the_gate_has_the_nine_workloads_of_its_reference(self):
        with open(os.path.join(commits.ROOT, "bench", "gate.json")) as reference:
            text = reference.read()
        names = once.workloads(PROGRAM, "gate")
        self.assertEqual(len(names), 9)
        for name in names:
            self.assertIn(f'"{name}": {{\n   "instructions"', text)

    def test_each_workload_runs_and_says_what_it_did(self):
        names = once.workloads(PROGRAM)
        self.assertEqual(len(names), len(set(names)))
        for name in names:
            with self.subTest(name):
                result = counted(name)
                self.assertEqual((result["workload"], result["threads"]), (name, 1))
                self.assertGreater(result["items"], 1000)
                self.assertGreater(result["seconds"], 0)
                self.assertEqual(result["triangles"], result["digest"] is not None)

    def test_the_mesh_is_the_same_in_each_run_and_on_two_threads(self):
        for name in once.workloads(PROGRAM, "threads"):
            with self.subTest(name):
                meshes = {(one["digest"], one["items"]) for one in (counted(name), counted(name), counted(name, 2))}
                self.assertEqual(len(meshes), 1)
                self.assertRegex(next(iter(meshes))[0], "^[0-9a-f]{32}$")

    def test_a_file_that_was_written_and_read_has_the_mesh_that_was_made(self):
        made = counted("refinement")["digest"]
        self.assertEqual({name: counted(name)["digest"] for name in OF_ONE_MESH}, dict.fromkeys(OF_ONE_MESH, made))

    @unittest.skipIf(os.environ.get("SANITIZED"), "a sanitizer needs much memory of its own")
    def test_the_memory_of_a_mesh_is_that_of_the_work_alone(self):
        """The finished triangles take 24 bytes each, their points 16 bytes per two. The input of `check` is a mesh, but
        the check itself takes less."""
        made = once.run(PROGRAM, "refinement")
        if made["bytes"] == 0:
            self.skipTest("the kernel does not tell the peak of memory")
        self.assertTrue(32 < made["bytes"] / made["items"] < 100, made)
        checked = once.run(PROGRAM, "check")
        self.assertLess(checked["bytes"], made["bytes"])

    def test_wrong_arguments_are_refused(self):
        for arguments in (["no_such_workload"], ["fill", "--threads"], ["fill", "--threads", "0"], ["fill", "--waste", "x"],
                          ["fill", "--waste", "-1"], ["fill", "extra"]):
            with self.subTest(arguments):
                result = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
                self.assertEqual(result.returncode, 2)
                self.assertIn("usage", result.stderr)


class RealComparison(unittest.TestCase):
    CASES = [("refinement", 1), ("incircle_corrected", 1)]

    def lines(self, twice):
        compare = load("compare")
        return compare.compare(lambda case: once.run(PROGRAM, *case, timed=False),
                               lambda case: once.run(PROGRAM, *case, timed=False, twice=twice), self.CASES, 15, 0.99,
                               random.Random())

    def test_a_workload_that_does_its_work_twice_is_said_to_be_slower(self):
        for case, line in self.lines(twice=True).items():
            self.assertEqual(line["verdict"], "B is slower", (case, line))
            self.assertTrue(line["same_mesh"])

    def test_an_unchanged_program_is_not_said_to_differ(self):
        """One in 100 comparisons may be wrong, so two of four wrong ones are a defect: 1 in 1700 by chance."""
        verdicts = [line["verdict"] for _ in range(2) for line in self.lines(twice=False).values()]
        self.assertLessEqual(sum("includes 1" not in verdict for verdict in verdicts), 1, verdicts)


if __name__ == "__main__":
    unittest.main()
