"""bench/gate, bench/track and bench/compare from end to end, on a small repository in which a commit says how many
instructions its work takes."""
import contextlib
import io
import json
import os
import sys
import tempfile
import time
import unittest
import unittest.mock
from pathlib import Path

from measuring import command, commits, history, once, pressure
from script import call, load

gate, track, compare = load("gate"), load("track"), load("compare")

# The programs below begin with the interpreter of the tests: the search of #!/usr/bin/env may take longer than they do.
# Stands for bench/workloads/once. COST is what core/cost of the commit contains.
ONCE = f"#!{sys.executable}" + """
import json, sys
if len(sys.argv) == 1:
    print("one gate threads\\ntwo gate")
elif "COST" == "fails" and sys.argv[1] == "two":
    sys.exit("the work failed")
else:
    threads = int(sys.argv[sys.argv.index("--threads") + 1])
    print(json.dumps({"workload": sys.argv[1], "threads": threads, "seconds": 0.5, "cpu_seconds": 0.25, "items": 10,
                      "triangles": True, "bytes": 400, "cycles": None, "digest": "0123456789abcdef" * 2}))
"""
# Stands for bench/scaling.
SCALING = f"#!{sys.executable}" + """
import json, sys
if "--help" in sys.argv:
    print("--json FILE")
elif "COST" == "meshes differ":
    sys.exit("the meshes differ")
else:
    with open(sys.argv[sys.argv.index("--json") + 1], "w") as out:
        json.dump({"benchmarks": [{"run_name": "scaling/pipe", "threads": 1, "real_time": 1e9, "items": 5,
                                   "bytes_per_triangle": 8}]}, out)
"""


class SmallRepository(unittest.TestCase):
    """Instead of a compiler, a build writes ONCE and SCALING; it fails if the cost is "broken"."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.compiler = "g++ 1.2.3"
        self.builds = []
        self.patch(commits, "ROOT", str(self.root))
        self.patch(commits, "build", self.build)
        self.patch(commits, "compiler", lambda folder: self.compiler)
        self.patch(once, "count", lambda program, workload, waste=0: {"f": 1000, workload: self.cost(program) + waste})
        self.patch(history, "FILE", str(self.root / "bench/history/workloads.csv"))
        self.patch(history, "machine", lambda: "m")
        self.patch(pressure.Watch, "share", lambda watch: None)  # of a quiet machine
        self.patch(track, "TREE", str(self.root / "build/track"))
        self.patch(compare, "FOLDER", str(self.root / "build/compare"))
        self.patch(gate, "REFERENCE", str(self.root / "bench/gate.json"))
        who = {f"GIT_{person}_{what}": "a" for person in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
        environment = unittest.mock.patch.dict(os.environ, who)
        environment.start()
        self.addCleanup(environment.stop)
        commits.git("init", "-q", "-b", "main")
        self.write("CMakeLists.txt", "add_subdirectory(bench/workloads)\n")
        self.write("bench/workloads/once.cpp", "the workloads")
        self.write("scripts/install-packages", "#!/bin/sh\n")
        (self.root / "scripts/install-packages").chmod(0o755)
        self.write(".gitignore", "build/\n")

    def patch(self, *what):
        patcher = unittest.mock.patch.object(*what)
        patcher.start()
        self.addCleanup(patcher.stop)

    def write(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def commit(self, cost):
        self.write("core/cost", f"{cost}\n")
        self.write("docs/count", str(len(self.builds)))
        commits.git("add", ".")
        commits.git("commit", "-q", "--allow-empty", "-m", f"cost {cost}")
        return commits.git("rev-parse", "HEAD")

    def build(self, tree, *targets, preset="bench"):
        cost = (Path(tree) / "core/cost").read_text().strip()
        self.builds.append(cost)
        if cost == "broken":
            raise commits.NotBuilt("error: it does not compile")
        for target, text in (("once", ONCE), ("scaling", SCALING)):
            if target in targets:
                program = Path(commits.program(tree, preset))
                if target != "once":
                    program = Path(tree) / "build" / preset / "bench" / target
                program.parent.mkdir(parents=True, exist_ok=True)
                program.write_text(text.replace("COST", cost))
                program.chmod(0o755)
        if targets == ("paper_tables",):
            raise commits.NotBuilt("there is no such target")
        (Path(tree) / "build" / preset / "compiler").write_text(self.compiler)

    @staticmethod
    def cost(program):
        text = (Path(program).parents[4] / "core/cost").read_text().strip()
        return int(text) if text.isdigit() else 0

    def rows(self, commit):
        return {row["workload"]: row for row in history.read() if row["commit"] == commit[:history.SHORT_COMMIT]}


class Track(SmallRepository):
    def test_a_commit_gets_rows_a_file_of_numbers_and_a_place_on_the_page(self):
        commit = self.commit(100)
        self.assertEqual(call(track)[0], 0)
        rows = self.rows(commit)
        self.assertEqual(list(rows), ["one", "one/threads:2", "two"])
        self.assertEqual((rows["one"]["instructions"], rows["one"]["seconds"]), ("1100", "0.25000"))
        self.assertEqual(rows["one"]["compiler"], "g++ 1.2.3")
        numbers = json.loads((self.root / f"build/track-{commit[:12]}.json").read_text())
        self.assertEqual(numbers["context"]["commit"], commit)
        self.assertIn("cost 100", (self.root / "bench/history/index.html").read_text())
        self.assertIn("<svg", (self.root / "bench/history/history.svg").read_text())

    def test_a_commit_that_fails_does_not_stop_the_others(self):
        failing, broken, good = self.commit("fails"), self.commit("broken"), self.commit(100)
        code, printed = call(track, failing, broken, good)
        self.assertEqual(code, 1)
        self.assertIn("the work failed", printed)
        self.assertIn("error: it does not compile", printed)
        self.assertEqual([len(self.rows(commit)) for commit in (failing, broken, good)], [0, 0, 3])
        self.assertIn("cost 100", (self.root / "bench/history/index.html").read_text())

    def test_commits_that_do_not_fit_the_workloads_are_passed_over_in_a_series(self):
        self.commit("broken")
        good = self.commit(100)
        self.assertEqual(call(track, "--last", "2")[0], 0)
        self.assertEqual(len(self.rows(good)), 3)

    def test_a_series_has_the_commits_of_which_something_is_missing(self):
        first, second = self.commit(100), self.commit(200)
        call(track, first, "--threads", "1")
        call(track, second)
        self.builds.clear()
        self.assertEqual(call(track, "--last", "2")[0], 0)
        self.assertEqual(self.builds, ["100"])
        self.builds.clear()
        call(track, "--last", "2")
        self.assertEqual(self.builds, [])
        call(track, "--last", "2", "--tables")
        self.assertEqual({"scaling/pipe"} <= set(self.rows(first)), True)
        self.builds.clear()
        call(track, "--last", "2", "--tables")
        self.assertEqual(self.builds, [])

    def test_a_table_that_fails_is_a_failure_and_a_missing_one_is_passed_over(self):
        self.commit(100)
        code, printed = call(track, "--tables")
        self.assertEqual(code, 0)
        self.assertIn("paper_tables is passed over", printed)
        commit = self.commit("meshes differ")
        code, printed = call(track, "--tables")
        self.assertEqual(code, 1)
        self.assertIn("the meshes differ", printed)
        self.assertEqual(len(self.rows(commit)), 3)

    def test_narrowing_counts_commits_until_each_change_has_one_suspect(self):
        costs = [100, 101, 102, 102, 102, 900, 901, 901, 901, 902]
        for i, cost in enumerate(costs):
            self.write("core/else", str(i))
            made = self.commit(cost)
            if cost == 900:
                culprit = made
            if i in (0, 9):
                call(track)
        self.assertIn("one of 9, the last of them", (self.root / "bench/history/index.html").read_text())
        code, printed = call(track, "--narrow", "9")
        self.assertEqual(code, 0)
        self.assertIn("each change of instructions has one suspect", printed)
        page = (self.root / "bench/history/index.html").read_text()
        self.assertNotIn("one of", page)
        self.assertIn(f"<td>{culprit[:7]} cost 900</td>", page)
        self.assertLess(len({row["commit"] for row in history.read()}), len(costs))

    def test_times_that_were_measured_survive_a_count(self):
        commit = self.commit(100)
        call(track)
        track.Tracker(1, [1], False).count(commit)
        self.assertEqual(self.rows(commit)["one"]["seconds"], "0.25000")

    def test_workloads_that_are_not_committed_are_refused(self):
        self.commit(100)
        self.write("bench/workloads/once.cpp", "other workloads")
        code, printed = call(track)
        self.assertEqual(code, 1)
        self.assertIn("not committed", printed)

    def test_wrong_arguments_are_refused(self):
        self.commit(100)
        for arguments in (["--last", "-1"], ["--threads", "0"], ["--repetitions", "0"], ["--draw", "HEAD"]):
            self.assertEqual(call(track, *arguments)[0], 2, arguments)
        code, printed = call(track, "no-such-commit")
        self.assertEqual((code, printed), (1, "track: no-such-commit: there is no such commit"))

    def test_two_processes_do_not_use_one_working_tree(self):
        self.commit(100)
        with commits.locked(track.TREE):
            code, printed = call(track)
        self.assertEqual(code, 1)
        self.assertIn("another process is using", printed)

    def test_a_folder_that_is_no_working_tree_is_not_touched(self):
        commit = self.commit(100)
        self.write("build/track/file", "somebody's")
        self.write("core/cost", "not committed")
        code, printed = call(track, commit)
        self.assertEqual(code, 1)
        self.assertIn("remove this folder", printed)
        self.assertEqual((self.root / "core/cost").read_text(), "not committed")
        self.assertEqual(commits.git("rev-parse", "--abbrev-ref", "HEAD"), "main")

    def test_a_build_of_another_compiler_is_removed(self):
        commit = self.commit(100)
        call(track)
        left = self.root / "build/track/build/bench/left"
        left.write_text("")
        commits.check_out(commit, track.TREE)
        self.assertTrue(left.exists())
        self.compiler = "g++ 4.5.6"
        commits.check_out(commit, track.TREE)
        self.assertFalse(left.exists())


class Gate(SmallRepository):
    def setUp(self):
        super().setUp()
        self.commit(100)
        self.assertEqual(call(gate, "--update")[0], 0)

    def test_unchanged_counts_pass(self):
        code, printed = call(gate)
        self.assertEqual(code, 0)
        self.assertIn("one                    1,100         1,100    +0.00 %", printed)

    def test_more_instructions_fail_with_the_function_that_grew(self):
        self.commit(130)
        code, printed = call(gate)
        self.assertEqual(code, 1)
        self.assertIn("    two: +30", printed)
        self.assertIn("more than 2 % above the reference, or missing: one, two", printed)

    def test_another_compiler_is_not_judged_and_fails_if_the_gate_is_strict(self):
        self.commit(500)
        self.compiler = "g++ 4.5.6"
        code, printed = call(gate)
        self.assertEqual(code, 0)
        self.assertIn("nothing is judged: the reference was counted with g++ 1.2.3, not g++ 4.5.6", printed)
        self.assertEqual(call(gate, "--strict")[0], 1)

    def test_it_judges_itself(self):
        self.commit(100)
        self.patch(once, "count", lambda program, workload, waste=0: {"f": 1000, "planted_slowdown": waste})
        code, printed = call(gate, "--self-test")
        self.assertEqual(code, 0)
        self.assertIn("noticed and named all planted slowdowns", printed)
        self.patch(once, "count", lambda program, workload, waste=0: {"f": 1000})
        self.assertEqual(call(gate, "--self-test")[0], 1)

    def test_a_program_that_does_not_compile_is_an_error(self):
        self.commit("broken")
        code, printed = call(gate)
        self.assertEqual(code, 1)
        self.assertIn("error: it does not compile", printed)

    def test_wrong_arguments_are_refused(self):
        self.assertEqual(call(gate, "--update", "--self-test")[0], 2)
        self.assertEqual(call(gate, "--update", "--preset", "release")[0], 2)

    def test_a_damaged_reference_is_told_before_anything_is_built(self):
        self.builds.clear()
        for text in ("", "[]", '{"workloads": {}}', "<<<<<<< HEAD"):
            self.write("bench/gate.json", text)
            code, printed = call(gate)
            self.assertEqual((code, len(self.builds)), (1, 0))
            self.assertIn("gate.json: this file is damaged; bench/gate --update records a new one", printed)


class Compare(SmallRepository):
    def compare(self, *more):
        return call(compare, "HEAD", ".", "--pairs", "8", "--workloads", "one", *more)

    def test_two_commits_have_a_line_for_each_workload(self):
        self.commit(100)
        code, printed = self.compare()
        self.assertEqual(code, 0)
        self.assertIn("A: " + commits.subject(commits.resolve("HEAD")), printed)
        self.assertIn("B: the working tree", printed)
        self.assertIn("one                               250.00    250.00   1.000", printed)

    def test_a_commit_is_built_again_only_for_other_workloads_or_another_compiler(self):
        commit = self.commit(100)
        compare.program_of(commit)
        self.builds.clear()
        compare.program_of(commit)
        self.assertEqual(len(self.builds), 0)
        self.write("bench/workloads/once.cpp", "other workloads")
        compare.program_of(commit)
        self.assertEqual(len(self.builds), 1)
        self.compiler = "g++ 4.5.6"
        compare.program_of(commit)
        self.assertEqual(len(self.builds), 2)
        os.remove(commits.program(os.path.join(compare.FOLDER, commit[:12])))
        compare.program_of(commit)
        self.assertEqual(len(self.builds), 3)

    def test_what_cannot_be_compared_is_an_error(self):
        self.commit("broken")
        self.assertIn("error: it does not compile", self.compare()[1])
        self.commit("fails")
        code, printed = call(compare, "HEAD", ".", "--pairs", "8", "--workloads", "two")
        self.assertEqual(code, 1)
        self.assertIn("the work failed", printed)
        self.assertEqual(call(compare, "HEAD")[0], 2)
        self.builds.clear()
        self.assertIn("nothing: there is no such commit", call(compare, "HEAD", "nothing")[1])
        self.assertEqual(len(self.builds), 0)
        self.assertEqual(call(compare, "HEAD", ".", "--workloads", "three")[0], 2)


class Commands(unittest.TestCase):
    def run_script(self, main):
        with contextlib.redirect_stderr(io.StringIO()), unittest.mock.patch("signal.signal"), \
                self.assertRaises(SystemExit) as end:
            command.run("name", main)
        return end.exception.code

    def test_what_fails_ends_a_script_with_a_message(self):
        self.assertEqual(self.run_script(lambda: command.output("/no/such/program")),
                         "name: /no/such/program cannot be started: No such file or directory")
        self.assertEqual(self.run_script(lambda: command.output("sh", "-c", "echo out; echo why >&2; exit 3")),
                         "name: sh -c echo out; echo why >&2; exit 3 failed\nout\nwhy\n")

    def test_a_command_that_takes_too_long_is_ended(self):
        with unittest.mock.patch.object(command, "LONGEST", 0.1), self.assertRaisesRegex(command.Failed, "took more than"):
            command.output("sleep", "20")

    def test_a_command_is_ended_with_the_processes_that_it_has_started(self):
        with tempfile.TemporaryDirectory() as folder:
            with unittest.mock.patch.object(command, "LONGEST", 1), self.assertRaises(command.Failed):
                command.output("sh", "-c", f"(sleep 2; touch {folder}/went_on) & wait")
            time.sleep(1.5)
            self.assertFalse(os.path.exists(f"{folder}/went_on"))

    def test_an_error_of_the_system_ends_a_script_with_a_message(self):
        self.assertEqual(self.run_script(lambda: open("/no/such/file")),
                         "name: [Errno 2] No such file or directory: '/no/such/file'")

    def test_an_interrupt_has_its_exit_code(self):
        def interrupted():
            raise KeyboardInterrupt
        self.assertEqual(self.run_script(interrupted), 130)


if __name__ == "__main__":
    unittest.main()
