"""fuzz/campaign and fuzz/afl and their parts, with small scripts in place of the programs of libFuzzer and AFL++."""
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "fuzz"))
from campaigns import finds, programs, slices, summary  # noqa: E402
from campaigns.child import Children  # noqa: E402

# Fails if the input has the word "bug", and later a "7". RUNS: a file to which each run adds a byte.
REPLAY = r"""#!/bin/sh
[ -z "$RUNS" ] || printf . >> "$RUNS"
[ -z "$SLOW" ] || sleep "$SLOW"
if tr '\n\0' '  ' < "$1" | grep -q 'bug.*7'; then
  echo "fuzz: the property failed: vertex 12 at (0.5, 3) is missing"
  echo "    #4 0x55e0 in pardel::find_it(int) /source/find.cpp:3"
  exit 1
fi
"""

# Speaks as libFuzzer does. The first argument that is a folder is the corpus. A run ends after LASTS seconds, or by
# SIGTERM. A merge fails; that of the target `fake` waits for a process of its own that takes MERGES seconds. With
# MERGE_FINDS, the merge leaves a failing input, and the run after it does not.
FUZZER = f"#!{sys.executable}" + r"""
import os, re, signal, subprocess, sys, time
from pathlib import Path
options = dict(re.findall(r"-(\w+)=(\S+)", " ".join(sys.argv[1:])))
folders = [Path(a) for a in sys.argv[1:] if not a.startswith("-")]
if "merge" in options:
    if "MERGES" in os.environ and sys.argv[0].endswith("fake"):
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        waits = subprocess.Popen(["sleep", os.environ["MERGES"]])
        Path(folders[0].parent / "merging").write_text(str(waits.pid))
        waits.wait()
    if "MERGE_FINDS" in os.environ:
        print("fuzz: the property failed: vertex 99 at (1, 2) is missing", flush=True)
        Path(options["artifact_prefix"] + "crash-2").write_bytes(b"a bug with a 7")
    sys.exit(1)
end = time.time() + float(os.environ.get("LASTS", "1"))
signal.signal(signal.SIGTERM, lambda *_: globals().__setitem__("end", 0))
print("#10 INITED cov: 100 ft: 200 corp: 5/50b exec/s: 0", flush=True)
while time.time() < end:
    time.sleep(0.05)
(folders[0] / "new").write_text("input")
if "MERGE_FINDS" not in os.environ:
    Path(options["artifact_prefix"] + "crash-1").write_bytes(b"some text\nbug number 7 in the middle\nmore\n")
print("fuzz: the property failed: vertex 99 at (1, 2) is missing", flush=True)
print("stat::number_of_executed_units: 110\n#110 DONE cov: 120 ft: 260 corp: 6/60b exec/s: 100", flush=True)
sys.exit(1)
"""

# A merge that writes one input. The first argument that is a folder is that of the result.
MERGER = """#!/bin/sh
for word; do case $word in -*) ;; *) printf '{text}' > "$word/{name}"; exit 0 ;; esac; done
"""


def ended(process):
    """Has the process with this number ended?"""
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z"
    except OSError:
        return True


class FakeBuild(unittest.TestCase):
    """A build folder with one target, `fake`."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)
        (self.folder / "build/fuzz").mkdir(parents=True)
        (self.folder / "build/fuzz/targets").write_text("fake\n")
        self.write("build/fuzz/replay_fake", REPLAY)
        self.write("build/fuzz/fuzz_fake", FUZZER)
        self.target = programs.targets(self.folder / "build")[0]

    def write(self, name, text):
        file = self.folder / name
        file.write_text(text)
        file.chmod(0o755)
        return file

    def find(self, text, seconds=20):
        file = self.folder / "crash-0"
        file.write_bytes(text)
        return finds.record(self.target, file, "", self.folder / "finds", seconds)


class Processes(unittest.TestCase):
    def test_that_are_killed_leave_no_file_of_the_openmp_library(self):
        started = Children().start(["sh", "-c", 'touch /dev/shm/__KMP_REGISTERED_LIB_$$_$(id -u); kill -KILL $$'])
        self.assertIsNotNone(started.wait(20))
        self.assertEqual(started.returncode, -signal.SIGKILL)
        self.assertFalse(Path(f"/dev/shm/__KMP_REGISTERED_LIB_{started.process.pid}_{os.getuid()}").exists())


class Signatures(unittest.TestCase):
    def test_numbers_of_an_input_do_not_tell_verdicts_apart(self):
        one = finds.signature("fuzz: the property failed: vertex 12 at (0.5, 3) is missing\n")
        other = finds.signature("fuzz: the property failed: vertex 7 at (1e9, -2) is missing\n")
        self.assertEqual(one["verdict"], other["verdict"])
        self.assertNotEqual(one["message"], other["message"])

    def test_the_stack_has_the_innermost_functions_of_the_project(self):
        output = ("==1==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x60\n"
                  "    #0 0x51 in __asan_memcpy (/bin/x+0x1)\n"
                  "    #1 0x52 in pardel::(anonymous namespace)::read_row(int) /source/a.cpp:1:2\n"
                  "    #2 0x53 in pardel::read_file(char const*) /source/a.cpp:9:2\n"
                  "    #3 0x54 in pardel::fuzz::fuzz_one(char const*) /source/b.cpp:9:2\n")
        found = finds.signature(output)
        self.assertEqual(found["verdict"], "AddressSanitizer: heap-buffer-overflow")
        self.assertEqual(found["stack"], ["pardel::read_row", "pardel::read_file"])

    def test_types_of_results_and_arguments_do_not_hide_a_function(self):
        for name, plain in (
                ("pardel::engine::triangulate_domain(pardel::Pslg const&, bool)", "pardel::engine::triangulate_domain"),
                ("pardel::read_row(std::basic_string_view<char, std::char_traits<char> >, int)", "pardel::read_row"),
                ("std::vector<pardel::Point> pardel::remaining<std::less<int> >(pardel::Array<int> const&)",
                 "pardel::remaining"),
                ("pardel::Array<(anonymous namespace)::Domain>::operator[](unsigned long) const",
                 "pardel::Array::operator[]"),
                ("pardel::f(int)::{lambda(int)#1}::operator()(int) const", "pardel::f")):
            found = finds.signature(f"ERROR: AddressSanitizer: heap-buffer-overflow on\n    #1 0x52 in {name} /a.cpp:1\n")
            self.assertEqual(found["stack"], [plain])

    def test_functions_of_libraries_are_left_out(self):
        names = ("std::vector<pardel::Point>::at(unsigned long)", "operator new(unsigned long)", "abort", "main",
                 "void std::sort<pardel::Less>(pardel::Less)", "__libc_start_main", "pardel::fuzz::fail(std::string const&)")
        output = "".join(f"    #{i} 0x52 in {name} /a.cpp:1\n" for i, name in enumerate(names))
        self.assertEqual(finds.signature(output)["stack"], [])

    def test_different_stacks_are_different_finds(self):
        found = {"verdict": "crash", "stack": ["a", "b"]}
        self.assertNotEqual(finds.key("t", found), finds.key("t", {**found, "stack": ["a", "c"]}))
        self.assertNotEqual(finds.key("t", found), finds.key("u", found))


class Finds(FakeBuild):
    def test_a_find_is_shrunk_to_the_smallest_input_that_fails_in_the_same_way(self):
        entry = self.find(b"first line\nhere is a bug, and more\0words; then 1234567890\nlast line\n" * 3)
        place = self.folder / "finds" / "fake" / entry["key"]
        self.assertEqual((place / "input").read_bytes(), b"bug7")
        self.assertIn("vertex 12", (place / "output.txt").read_text())
        self.assertEqual(finds.all_in(self.folder / "finds"), [entry])
        command = entry["replay"].split()
        self.assertEqual(subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode, 1)

    def test_a_byte_that_cannot_be_zero_becomes_smaller(self):
        def fails(data):
            return len(data) == 2 and 11 <= data[0] < 200

        self.assertEqual(finds.with_less_at(0, b"\xc0\x07", fails, lambda: False), b"\x0b\x07")
        self.assertEqual(finds.with_less_at(0, b"\xc0\x07", fails, lambda: True), b"\xc0\x07")
        self.assertEqual(finds.with_less_at(0, b"\x61", lambda data: data[0] > 0, lambda: False), b"\x01")

    def test_the_same_failure_is_counted_and_not_filed_again(self):
        self.assertIsNotNone(self.find(b"bug 7"))
        self.assertIsNone(self.find(b"another bug and 7"))
        self.assertEqual([entry["times"] for entry in finds.all_in(self.folder / "finds")], [2])

    def test_a_find_whose_shrinking_was_interrupted_is_made_again(self):
        file = self.folder / "crash-0"
        file.write_bytes(b"a bug that takes long to shrink, because each run sleeps: 7")
        code = (f"import sys; sys.path.insert(0, {str(ROOT / 'fuzz')!r})\n"
                f"from campaigns import finds, programs\n"
                f"target = programs.targets({str(self.folder / 'build')!r})[0]\n"
                f"finds.record(target, {str(file)!r}, '', {str(self.folder / 'finds')!r}, 60)\n")
        runs = self.folder / "runs"
        environment = dict(os.environ, SLOW="0.05", RUNS=str(runs))
        shrinking = subprocess.Popen([sys.executable, "-c", code], env=environment)
        while not runs.exists() or runs.stat().st_size < 5:
            time.sleep(0.02)
        shrinking.kill()
        shrinking.wait()
        self.assertEqual(finds.all_in(self.folder / "finds"), [])
        self.assertIsNotNone(self.find(file.read_bytes()))
        self.assertEqual([entry["bytes"] for entry in finds.all_in(self.folder / "finds")], [4])

    def test_a_folder_without_an_entry_is_made_again(self):
        entry = self.find(b"bug 7")
        place = self.folder / "finds" / "fake" / entry["key"]
        (place / "find.json").unlink()
        self.assertEqual(self.find(b"bug 7")["key"], entry["key"])

    def test_a_time_out_that_does_not_happen_again_is_no_find(self):
        file = self.folder / "timeout-0"
        file.write_bytes(b"harmless")
        folder = self.folder / "finds"
        self.assertIsNone(finds.record(self.target, file, "ERROR: libFuzzer: timeout after 30 seconds", folder, 1))
        # The log of a merge may name the failure of another input first.
        segv = "ERROR: AddressSanitizer: SEGV on unknown address"
        self.assertIsNone(finds.record(self.target, file, segv, folder, 1))
        crash = self.folder / "crash-0"
        crash.write_bytes(b"harmless")
        self.assertFalse(finds.record(self.target, crash, segv, folder, 1)["repeats"])


class Slices(FakeBuild):
    def test_executions_do_not_count_what_was_read(self):
        found = slices.numbers("#10 INITED cov: 5 ft: 6 corp: 3/9b\n#64 NEW cov: 7 ft: 9 corp: 4/12b\n"
                               "stat::number_of_executed_units: 100\n")
        self.assertEqual((found["executions"], found["read"], found["coverage"], found["features"], found["inputs"],
                          found["features_before"]), (90, 10, 7, 9, 4, 6))

    def test_a_corpus_survives_an_interrupted_replacement(self):
        corpus = self.folder / "corpus" / "fake"
        for interrupted in ("before", "between", "after"):
            for name in ("fake", "fake.merged", "fake.old"):
                slices.remove(corpus.parent / name)
            kept = {"before": "fake", "between": "fake.old", "after": "fake"}[interrupted]
            (corpus.parent / kept).mkdir(parents=True)
            (corpus.parent / kept / "input").write_text(interrupted)
            if interrupted == "before":
                (corpus.parent / "fake.merged").mkdir()
            if interrupted == "after":
                (corpus.parent / "fake.old").mkdir()
            slices.recover(corpus)
            self.assertEqual([f.name for f in corpus.parent.iterdir()], ["fake"], interrupted)
            self.assertEqual((corpus / "input").read_text(), interrupted)

    def test_a_merge_that_fails_leaves_the_corpus(self):
        corpus = self.folder / "corpus" / "fake"
        corpus.mkdir(parents=True)
        (corpus / "input").write_text("kept")
        work = self.folder / "work"
        work.mkdir()
        # On a full disk libFuzzer writes a part of an input, and its exit code is 0.
        name = hashlib.sha1(b"kept").hexdigest()
        for program in (FUZZER, "#!/bin/sh\n", MERGER.format(text="ke", name=name), MERGER.format(text="", name=name)):
            self.write("build/fuzz/fuzz_fake", program)
            self.assertFalse(slices.minimise(self.target, corpus, work, 10, Children()))
            self.assertEqual([f.name for f in corpus.parent.iterdir()], ["fake"])
            self.assertEqual((corpus / "input").read_text(), "kept")

    def test_a_merge_replaces_the_corpus_with_its_folders(self):
        corpus = self.folder / "corpus" / "fake"
        (corpus / "folder").mkdir(parents=True)
        (corpus / "folder/input").write_text("kept")
        name = hashlib.sha1(b"kept").hexdigest()
        self.write("build/fuzz/fuzz_fake", MERGER.format(text="kept", name=name))
        self.assertTrue(slices.minimise(self.target, corpus, self.folder, 10, Children()))
        self.assertEqual([f.name for f in corpus.parent.iterdir()], ["fake"])
        self.assertEqual([(f.name, f.read_text()) for f in corpus.iterdir()], [(name, "kept")])


class Summaries(unittest.TestCase):
    def test_the_plot_has_a_line_for_each_target_that_ran(self):
        picture = summary.plot({"a": [(0.1, 5), (0.2, 9)], "b": [(0.1, 7)], "c": []}, "hours", "edges")
        self.assertEqual(len(re.findall("<polyline", picture)), 2)
        self.assertIn("a: 9 edges", picture)

    def test_finds_are_listed_by_verdict(self):
        def find(verdict, target):
            return {"target": target, "key": "0", "times": 1, "message": verdict, "verdict": verdict, "stack": [],
                    "bytes": 3, "replay": f"replay_{target}"}
        with tempfile.TemporaryDirectory() as folder:
            for number, (verdict, target) in enumerate([("b", "x"), ("a", "z"), ("b", "w")]):
                place = Path(folder) / target / str(number)
                place.mkdir(parents=True)
                (place / "find.json").write_text(json.dumps(find(verdict, target)))
            lines = summary.list_of_finds(finds.all_in(folder))
        self.assertEqual([line.split()[1] for line in lines if line.startswith(("###", "- "))],
                         ["a", "**z**", "b", "**w**", "**x**"])


class Campaigns(FakeBuild):
    def begin(self, *options, **environment):
        return subprocess.Popen(
            [sys.executable, ROOT / "fuzz/campaign", "--no-build", "--build", self.folder / "build", "--slice", "60",
             *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
            env=dict(os.environ, **environment))

    def wait_until(self, is_reached):
        deadline = time.time() + 20
        while not is_reached():
            self.assertLess(time.time(), deadline)
            time.sleep(0.02)

    def wait_for(self, words):
        """Waits until the log of the first slice has these words."""
        log = self.folder / "run/work/fake-0/log"
        self.wait_until(lambda: log.exists() and words in log.read_text())

    def add_target(self, name):
        """A target without finds, beside `fake`."""
        with open(self.folder / "build/fuzz/targets", "a") as targets:
            targets.write(f"{name}\n")
        self.write(f"build/fuzz/replay_{name}", REPLAY)
        without_finds = re.sub(r'^if "MERGE_FINDS" not in.*\n.*\n', "", FUZZER, flags=re.MULTILINE)
        self.write(f"build/fuzz/fuzz_{name}", without_finds)

    def write_state(self, **slices_made):
        """The folder of a campaign with targets that had so many slices. Before its fourth one, a target minimises."""
        known = {"cpu_seconds": 0.0, "executions": 0, "coverage": 0, "features": 0, "inputs": 0, "new_per_second": 0.0,
                 "seconds_to_read": 0.0, "history": []}
        (self.folder / "run").mkdir()
        (self.folder / "run/state.json").write_text(json.dumps(
            {"targets": {name: {**known, "slices": made} for name, made in slices_made.items()}, "next": 0}))

    def slices_made(self):
        return {name: entry["slices"] for name, entry in self.read()["targets"].items()}

    def read(self):
        return json.loads((self.folder / "run/summary.json").read_text())

    def test_a_campaign_counts_its_runs_and_files_its_finds(self):
        # No slice begins in the last five seconds; so there is time for one.
        campaign = self.begin("--out", self.folder / "run", "--hours", str(5.9 / 3600))
        said = campaign.communicate()[0]
        self.assertEqual(campaign.returncode, 1, said)
        found = self.read()
        self.assertEqual((found["targets"]["fake"]["slices"], found["executions"]), (1, 100))
        self.assertEqual([(f["bytes"], f["times"]) for f in found["finds"]], [(4, 1)])
        self.assertIn("vertex 12", (self.folder / "run/summary.md").read_text())
        self.assertIn("vertex 12", said)
        self.assertIn("fake: 100 executions in ", said)
        self.assertIn("100 executions, 1 find. ", said)
        self.assertTrue((self.folder / "run/corpus/fake/new").exists())

    def test_a_campaign_that_is_killed_and_resumed_loses_nothing(self):
        campaign = self.begin("--out", self.folder / "run", "--hours", "1", LASTS="60")
        self.wait_for("INITED")
        campaign.kill()
        campaign.communicate()
        self.wait_for("DONE")  # libFuzzer ends with its figures
        resumed = self.begin("--resume", self.folder / "run", "--hours", "0")
        said = resumed.communicate()[0]
        self.assertEqual(resumed.returncode, 1, said)
        found = self.read()
        self.assertEqual((found["executions"], found["targets"]["fake"]["slices"]), (100, 1), said)
        self.assertEqual([f["times"] for f in found["finds"]], [1])
        self.assertGreater(found["targets"]["fake"]["seconds_to_read"], 0)

    def test_an_interrupted_campaign_ends_with_its_summary(self):
        campaign = self.begin("--out", self.folder / "run", "--hours", "1", LASTS="60")
        self.wait_for("INITED")
        campaign.send_signal(signal.SIGTERM)
        said = campaign.communicate(timeout=30)[0]
        self.assertEqual(campaign.returncode, 1, said)
        self.assertEqual(self.read()["executions"], 100)
        self.assertGreater(self.read()["targets"]["fake"]["cpu_seconds"], 0)

    def test_a_signal_of_the_terminal_ends_shrinking_and_keeps_the_find(self):
        runs = self.folder / "runs"
        campaign = self.begin("--out", self.folder / "run", "--hours", "1", "--shrink", "60",
                              SLOW="0.5", RUNS=str(runs))
        self.wait_until(lambda: runs.exists() and runs.stat().st_size > 2)
        os.killpg(campaign.pid, signal.SIGINT)
        said = campaign.communicate(timeout=30)[0]
        self.assertEqual(campaign.returncode, 1, said)
        found, = self.read()["finds"]
        self.assertIn("vertex 12", found["message"])
        self.assertGreater(found["bytes"], 4)

    def test_a_signal_ends_a_merge_with_all_its_processes(self):
        self.write_state(fake=3)
        campaign = self.begin("--resume", self.folder / "run", "--hours", "1", MERGES="60")
        merging = self.folder / "run/corpus/merging"
        self.wait_until(lambda: merging.exists() and merging.read_text())
        campaign.send_signal(signal.SIGINT)
        said = campaign.communicate(timeout=30)[0]
        self.assertEqual(campaign.returncode, 0, said)
        self.wait_until(lambda: ended(merging.read_text()))

    def test_other_targets_go_on_while_a_corpus_is_minimised(self):
        self.add_target("other")
        self.write_state(fake=3, other=4)
        # The merge takes longer than the time in which slices begin.
        campaign = self.begin("--resume", self.folder / "run", "--jobs", "2", "--hours", str(12 / 3600), MERGES="8")
        self.assertEqual(campaign.wait(), 0, campaign.stdout.read())
        campaign.stdout.close()
        self.assertEqual(self.slices_made()["fake"], 3)
        self.assertGreaterEqual(self.slices_made()["other"], 6)

    def test_other_targets_go_on_while_a_find_is_shrunk(self):
        self.add_target("other")
        # Shrinking takes longer than the time in which slices begin.
        campaign = self.begin("--out", self.folder / "run", "--jobs", "2", "--hours", str(11 / 3600), "--shrink", "7",
                              SLOW="0.3")
        said = campaign.communicate()[0]
        self.assertEqual(campaign.returncode, 1, said)
        self.assertEqual(self.slices_made()["fake"], 1)
        self.assertGreaterEqual(self.slices_made()["other"], 2)

    def test_an_input_that_fails_while_a_corpus_is_minimised_is_a_find(self):
        self.write_state(fake=3)
        campaign = self.begin("--resume", self.folder / "run", "--hours", str(5.9 / 3600), MERGE_FINDS="1")
        said = campaign.communicate()[0]
        self.assertEqual(campaign.returncode, 1, said)
        self.assertEqual([f["message"] for f in self.read()["finds"]],
                         ["vertex 12 at (0.5, 3) is missing"], said)

    def test_a_program_that_is_missing_is_named(self):
        (self.folder / "build/fuzz/fuzz_fake").unlink()
        campaign = self.begin("--out", self.folder / "run")
        said = campaign.communicate()[0]
        self.assertEqual(campaign.returncode, 2)
        self.assertIn("fuzz/fuzz_fake is missing", said)

    def test_an_unknown_target_or_folder_is_an_error(self):
        (self.folder / "other").mkdir()
        self.write_state(fake=1)
        for options, message in ((("--targets", "none", "--out", self.folder / "new"), "there is no target none"),
                                 (("--resume", self.folder / "nowhere"), "there is no campaign in this folder"),
                                 (("--resume", self.folder / "other"), "there is no campaign in this folder"),
                                 (("--out", self.folder / "run"), "--resume continues it"),
                                 (("--jobs", "0"), "--jobs has to be a number from 1 on"),
                                 (("--hours", "nan"), "--hours has to be a number from 0 on"),
                                 (("--slice", "3"), "--slice has to be a number from 4 on"),
                                 (("--resume", self.folder / "run", "--out", self.folder / "new"),
                                  "--resume and --out")):
            campaign = self.begin(*options)
            said = campaign.communicate()[0]
            self.assertNotEqual(campaign.returncode, 0)
            self.assertIn(message, said)

    def test_a_campaign_that_cannot_run_leaves_no_folder(self):
        for options in (("--targets", "none"), ("--hours", "0")):
            campaign = self.begin(*options, "--out", self.folder / "new")
            campaign.communicate()
            self.assertEqual(campaign.returncode, 2)
            self.assertFalse((self.folder / "new").exists())

    def test_a_resumed_campaign_has_the_targets_and_the_slices_of_its_beginning(self):
        self.add_target("other")
        campaign = self.begin("--out", self.folder / "run", "--targets", "other", "--hours", str(5.9 / 3600))
        campaign.communicate()
        resumed = subprocess.run(
            [sys.executable, ROOT / "fuzz/campaign", "--no-build", "--build", self.folder / "build", "--resume",
             self.folder / "run", "--hours", str(5.9 / 3600)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True, check=False)
        self.assertEqual(self.slices_made(), {"other": 2}, resumed.stdout)
        self.begin("--resume", self.folder / "run", "--targets", "fake", "--hours", "0", "--slice", "70").communicate()
        self.assertEqual(json.loads((self.folder / "run/state.json").read_text())["chosen"], "other")
        self.assertEqual(json.loads((self.folder / "run/state.json").read_text())["slice"], 60)

    def test_a_program_that_does_not_start_ends_the_campaign(self):
        self.write("build/fuzz/fuzz_fake", "#!/bin/sh\necho 'a shared library is missing'\nexit 127\n")
        campaign = self.begin("--out", self.folder / "run")
        said = campaign.communicate(timeout=30)[0]
        self.assertEqual(campaign.returncode, 2)
        self.assertIn("fuzz_fake ended with exit code 127\na shared library is missing", said)

    def test_the_build_folder_may_be_relative(self):
        campaign = subprocess.run(
            [sys.executable, ROOT / "fuzz/campaign", "--no-build", "--build", "build", "--out", "run", "--hours",
             str(5.9 / 3600), "--slice", "60"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True, check=False)
        self.assertEqual(self.read()["executions"], 100, campaign.stdout)

    def test_a_damaged_file_is_named_and_kept(self):
        state = self.folder / "run/state.json"
        for text in ("", '{"targets": {', "[]", '{"next": 3}'):
            state.parent.mkdir(exist_ok=True)
            state.write_text(text)
            campaign = self.begin("--resume", self.folder / "run")
            said = campaign.communicate()[0]
            self.assertEqual(campaign.returncode, 2)
            self.assertRegex(said, r"^campaign: \S+/run/state.json: this file is damaged: [^\n]+\n$")
            self.assertEqual(state.read_text(), text)

    def test_a_slice_whose_time_of_start_is_lost_does_not_stop_the_next_campaign(self):
        self.write_state(fake=1)
        work = self.folder / "run/work/fake-0"
        work.mkdir(parents=True)
        (work / "log").write_text("#9 DONE cov: 1 ft: 1 corp: 1/1b\n")
        (work / "began").touch()
        (self.folder / "run/work/notes").touch()
        campaign = self.begin("--resume", self.folder / "run", "--hours", "0")
        said = campaign.communicate()[0]
        self.assertEqual(campaign.returncode, 0, said)
        self.assertEqual(self.slices_made(), {"fake": 2})

    def test_a_path_that_libfuzzer_cannot_use_is_an_error(self):
        campaign = self.begin("--out", self.folder / "a run")
        self.assertIn("where a path contains ' '", campaign.communicate()[0])
        self.assertEqual(campaign.returncode, 2)

    def test_of_fuzz_targets_cannot_be_continued_with_a_mesher(self):
        self.write_state(fake=1)
        campaign = self.begin("--resume", self.folder / "run", "--harness", "mesher {poly}")
        self.assertIn("this campaign is of the fuzz targets, not of a mesher", campaign.communicate()[0])
        self.assertEqual(campaign.returncode, 2)

    def test_two_processes_do_not_work_on_one_campaign(self):
        first = self.begin("--out", self.folder / "run", "--hours", "1", LASTS="60")
        self.wait_for("INITED")
        second = self.begin("--resume", self.folder / "run", "--hours", "0")
        self.assertIn("another process is working on this campaign", second.communicate()[0])
        self.assertEqual(second.returncode, 2)
        first.send_signal(signal.SIGTERM)
        self.assertEqual(first.communicate(timeout=30)[1], None)
        self.assertEqual(self.read()["executions"], 100)

    def test_a_slice_that_was_accounted_for_does_not_count_again(self):
        self.write_state(fake=1)
        state = self.folder / "run/state.json"
        state.write_text(json.dumps({**json.loads(state.read_text()), "accounted": "fake-0"}))
        work = self.folder / "run/work/fake-0"
        work.mkdir(parents=True)
        (work / "log").write_text("#9 DONE cov: 1 ft: 1 corp: 1/1b\n")
        self.begin("--resume", self.folder / "run", "--hours", "0").communicate()
        self.assertEqual(self.slices_made(), {"fake": 1})
        self.assertFalse(work.exists())


# Writes the report of a harness that has found one failure. The mesher is `seed N`: it fails for seeds below N. END: at
# this seed the harness ends as if it had been interrupted.
HARNESS = f"#!{sys.executable}" + r"""
import json, os, sys
from pathlib import Path
options = dict(zip(sys.argv[1::2], sys.argv[2::2]))
if options["--mesher"] == "fails":
    sys.exit(5)
seed, failing = int(options["--seed"]), int(options["--mesher"].split()[1])
if seed >= int(os.environ["END"]):
    sys.exit(130)
if "--name" in options:
    with open(Path(sys.argv[0]).parent / "names", "a") as names:
        names.write(options["--name"] + "\n")
bad = seed < failing
kinds = [{"verdict": "wrong", "kind": "overlap", "cases": 2, "first": 3, "message": "triangles 1 and 2 overlap",
          "smallest": {"poly": "failures/case_3.poly"}}] if bad else []
Path(options["--json"]).write_text(json.dumps({
    "families": {"cracks": {"valid": 8 if bad else 10, **({"wrong": 2} if bad else {})}}, "kinds": kinds,
    "failures": [{"case": 3, "replay": f"pardel-harness --seed {seed} --case 3"}] if bad else []}))
if bad:
    Path(options["--failures"]).mkdir()
    (Path(options["--failures"]) / "case_3.poly").write_text("")
sys.exit(1 if bad else 0)
"""


class HarnessCampaigns(FakeBuild):
    def run_campaign(self, *options, end=0):
        program = self.write("harness", HARNESS)
        return subprocess.run([sys.executable, ROOT / "fuzz/campaign", "--harness-program", program, *options],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
                              env=dict(os.environ, END=str(end)))

    def test_rounds_are_added_up_and_failures_of_one_kind_are_one_find(self):
        run = self.folder / "run"
        ran = self.run_campaign("--harness", "seed 3", "--out", run, end=5)
        self.assertEqual(ran.returncode, 1, ran.stdout)
        state = json.loads((run / "state.json").read_text())
        self.assertEqual((state["rounds"], state["cases"]), (4, 40))
        self.assertEqual(state["verdicts"], {"valid": 36, "wrong": 4})
        self.assertEqual([(f["kind"], f["times"], f["replay"]) for f in state["finds"]],
                         [("overlap", 4, "pardel-harness --seed 1 --case 3")])
        self.assertTrue((run / "finds/case_3.poly").exists())

        again = self.run_campaign("--resume", run, end=7)
        self.assertEqual(again.returncode, 1, again.stdout)
        self.assertEqual(json.loads((run / "state.json").read_text())["rounds"], 6)
        other = self.run_campaign("--harness", "seed 5", "--resume", run)
        self.assertIn("this campaign has --harness 'seed 3'; it cannot be changed", other.stdout)

    def test_the_options_of_a_campaign_are_those_of_its_beginning(self):
        run = self.folder / "run"
        ran = self.run_campaign("--harness", "seed 0", "--out", run, "--harness-options", "--name 'of two words'", end=3)
        self.assertEqual(ran.returncode, 0, ran.stdout)
        self.assertIn("round 2: 20 cases so far, 0 kinds of failures", ran.stdout)
        again = self.run_campaign("--resume", run, end=5)
        self.assertEqual(again.returncode, 0, again.stdout)
        self.assertEqual((self.folder / "names").read_text(), 4 * "of two words\n")
        for option, value in (("--harness-options", "--name other"), ("--cases", "7")):
            other = self.run_campaign("--resume", run, option, value)
            self.assertEqual(other.returncode, 2)
            self.assertIn(f"this campaign has {option}", other.stdout)

    def test_an_interruption_of_the_first_round_leaves_a_campaign(self):
        run = self.folder / "run"
        ran = self.run_campaign("--harness", "seed 0", "--out", run, end=1)
        self.assertEqual(ran.returncode, 0, ran.stdout)
        self.assertIn("0 cases in 0 rounds", (run / "summary.md").read_text())
        self.assertIn("No failures.", (run / "summary.md").read_text())
        again = self.run_campaign("--resume", run, end=2)
        self.assertEqual(json.loads((run / "state.json").read_text())["cases"], 10, again.stdout)

    def test_a_harness_that_cannot_run_is_named(self):
        ran = self.run_campaign("--harness", "fails", "--out", self.folder / "run")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("harness ended with exit code 5", ran.stdout)
        self.assertNotIn("summary.md", ran.stdout)
        again = self.run_campaign("--harness", "seed 0", "--out", self.folder / "run", end=2)
        self.assertEqual(again.returncode, 0, again.stdout)

    def test_options_that_are_no_words_and_those_that_were_not_stored_are_errors(self):
        run = self.folder / "run"
        ran = self.run_campaign("--harness", "seed 0", "--out", run, "--harness-options", "--name 'of")
        self.assertEqual((ran.returncode, run.exists()), (2, False))
        self.assertIn("--harness-options: No closing quotation", ran.stdout)
        self.run_campaign("--harness", "seed 0", "--out", run, end=2)
        state = json.loads((run / "state.json").read_text())
        del state["options"]
        (run / "state.json").write_text(json.dumps(state))
        self.assertIn("did not store --harness-options", self.run_campaign("--resume", run).stdout)
        ran = self.run_campaign("--resume", run, "--harness-options", "", end=3)
        self.assertEqual(ran.returncode, 0, ran.stdout)


# Leaves what afl-fuzz leaves: one old and one new input, a crash, and an input that took too long.
AFL_FUZZ = f"#!{sys.executable}" + r"""
import os, signal, sys, time
from pathlib import Path
options = dict(zip(sys.argv[1:], sys.argv[2:]))
if "ASAN_OPTIONS" in os.environ or options["-m"] != "none" or not os.listdir(options["-i"]):
    sys.exit("called in a wrong way")
made = Path(options["-o"]) / "default"
for name, text in (("queue/id:000000,time:0,execs:0,orig:seed", "old"), ("queue/id:000001,src:000000,time:7", "new"),
                   ("crashes/id:000000,sig:06", "words, a bug, more words, and 7 words"), ("crashes/README.txt", ""),
                   ("hangs/id:000000,src:000000", "harmless"),
                   ("fuzzer_stats", "execs_done : 1200\nexecs_per_sec : 40.25\nedges_found : 77\ncorpus_count : 2\n"
                                    "saved_crashes : 1\nsaved_hangs : 1\nafl_banner : fuzz: fake\n")):
    (made / name).parent.mkdir(parents=True, exist_ok=True)
    (made / name).write_text(text)
if os.environ.get("BROKEN"):
    sys.exit("this machine is not fit for afl-fuzz")
end = time.time() + float(os.environ.get("LASTS", "0"))
signal.signal(signal.SIGTERM, lambda *_: globals().__setitem__("end", 0))
(made / "ready").write_text("")
while time.time() < end:
    time.sleep(0.05)
"""


OTHER_FIND = {"target": "other", "key": "0123456789", "times": 1, "bytes": 3, "replay": "replay_other", "verdict": "wrong",
              "stack": [], "message": "wrong"}


class Afl(FakeBuild):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        self.write("bin/afl-fuzz", AFL_FUZZ)

    def begin(self, *options, **environment):
        return subprocess.Popen(
            [sys.executable, ROOT / "fuzz/afl", "--no-build", "--build", self.folder / "build", "--out",
             self.folder / "out", *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            env=dict(os.environ, PATH=f"{self.folder / 'bin'}:{os.environ['PATH']}", **environment))

    def run_afl(self, *options, **environment):
        """Returns the exit code and the output."""
        process = self.begin(*options, **environment)
        said = process.communicate()[0]
        return process.returncode, said

    def test_a_run_has_a_row_and_its_crash_is_a_find_as_in_a_campaign(self):
        (self.folder / "out/finds/other/0123456789").mkdir(parents=True)
        (self.folder / "out/finds/other/0123456789/find.json").write_text(json.dumps(OTHER_FIND))
        for _ in range(2):  # the second run replaces the first one
            code, said = self.run_afl()
            self.assertEqual(code, 1, said)
            self.assertIn("| fake | 1,200 | 40 | 77 | 2 | 1 | 1 | 1 |", said)
        found, other = finds.all_in(self.folder / "out/finds")  # the time-out does not happen again, and is none
        self.assertEqual((found["times"], other), (1, OTHER_FIND))
        self.assertEqual((self.folder / "out/finds/fake" / found["key"] / "input").read_bytes(), b"bug7")

    def test_finds_of_other_targets_do_not_count(self):
        (self.folder / "out/finds/other/0123456789").mkdir(parents=True)
        (self.folder / "out/finds/other/0123456789/find.json").write_text(json.dumps(OTHER_FIND))
        self.write("build/fuzz/replay_fake", "#!/bin/sh\n")
        self.write("bin/afl-fuzz", AFL_FUZZ.replace('("crashes/id:000000', '("crashes/none'))
        code, said = self.run_afl()
        self.assertEqual(code, 0, said)

    def test_a_campaign_gets_the_new_inputs_and_the_finds(self):
        corpus = self.folder / "run/corpus/fake"
        corpus.mkdir(parents=True)
        (self.folder / "run/state.json").write_text("{}")
        (corpus / "seed").write_text("old")
        for times in (1, 2):
            self.run_afl("--campaign", self.folder / "run")
            self.assertEqual(sorted(file.read_text() for file in corpus.iterdir()), ["new", "old"])
            self.assertEqual([find["times"] for find in finds.all_in(self.folder / "run/finds")], [times])

    def test_an_interrupted_run_files_what_it_has(self):
        process = self.begin(LASTS="60")
        deadline = time.time() + 20
        while not (self.folder / "out/fake/default/ready").exists():
            self.assertLess(time.time(), deadline)
            time.sleep(0.02)
        process.send_signal(signal.SIGTERM)
        said = process.communicate(timeout=30)[0]
        self.assertEqual(process.returncode, 1, said)
        self.assertEqual(len(finds.all_in(self.folder / "out/finds")), 1)

    def test_what_afl_says_when_it_fails_is_shown(self):
        code, said = self.run_afl(BROKEN="1")
        self.assertEqual(code, 2)
        self.assertIn("this machine is not fit for afl-fuzz", said)

    def test_a_wrong_target_or_folder_is_an_error(self):
        (self.folder / "run").mkdir()
        (self.folder / "run/state.json").write_text("{}")
        for options, message in ((("--targets", "none"), "there is no target none"),
                                 (("--campaign", self.folder / "nowhere"), "there is no campaign in this folder"),
                                 (("--out", self.folder / "run"), "this is the folder of a campaign")):
            code, said = self.run_afl(*options)
            self.assertEqual(code, 2)
            self.assertIn(message, said)


class Pictures(unittest.TestCase):
    """TARGETS: the list of targets of a build, which also has draw_case."""

    def test_of_every_target_whose_input_is_a_domain_can_be_drawn(self):
        drawing = [t for t in programs.targets(Path(os.environ["TARGETS"]).parents[1]) if t.draws]
        self.assertGreater(len(drawing), 5)
        for target in drawing:
            with self.subTest(target.name), tempfile.TemporaryDirectory() as folder:
                stem = Path(folder) / "domain"
                input_of_corpus = min(target.committed.iterdir())
                said = subprocess.run([target.folder / "draw_case", target.name, input_of_corpus, stem], check=True,
                                      capture_output=True, text=True).stdout
                self.assertRegex(said, r"^[1-9]\d* points, [1-9]\d* segments")
                self.assertIn("<svg", stem.with_suffix(".svg").read_text())
                header, _, points = stem.with_suffix(".poly").read_text().partition("\n")
                self.assertEqual(header.split()[0], said.split()[0])
                self.assertIn("\n", points)


class Canaries(unittest.TestCase):
    """TARGETS: the list of targets of a build."""

    def test_every_target_has_a_canary_that_is_a_known_mistake(self):
        def words(path, at):
            lines = path.read_text().splitlines()
            return [line.split()[at] for line in lines if line.strip() and not line.startswith("#")]

        targets = words(Path(os.environ["TARGETS"]), 0)
        self.assertEqual(set(words(ROOT / "fuzz/canaries.list", 0)), set(targets))
        mistakes = set(words(ROOT / "properties/mutants/registry", 0))
        self.assertEqual(set(words(ROOT / "fuzz/canaries.list", 1)) - mistakes, set())


if __name__ == "__main__":
    unittest.main()
