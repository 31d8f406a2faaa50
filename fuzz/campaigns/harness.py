"""Campaigns for any mesher: rounds of pardel-harness, with a new seed each. The finds are the failures that the harness
shrinks; their replay lines are those of its report."""
import json
import os
import shlex
import shutil
import subprocess
import time
from pathlib import Path

import safe_files

from . import programs, summary
from .child import Children
from .script import Stop, read_json

INTERRUPTED = 130  # the exit code of the harness after SIGINT


def add_options(parser):
    parser.add_argument("--harness", metavar="MESHER", help="run pardel-harness with this mesher, not the fuzz targets")
    parser.add_argument("--harness-program", type=Path,
                        help="the harness (default: that of the preset `release`, which is built)")
    parser.add_argument("--harness-options", help="further options of pardel-harness, such as '--format vtu'")
    parser.add_argument("--cases", type=int, help="cases of a round of the harness (default 220)")


def check(parser, options):
    """Ends the script with a message if the options of the harness cannot be divided into words."""
    try:
        shlex.split(options.harness_options or "")
    except ValueError as error:
        parser.error(f"--harness-options: {error}")


def built_program(build):
    """The harness of the preset `release`, which is built if `build` is true."""
    release = programs.ROOT / "build" / "release"
    if build:
        programs.build(release, ["pardel-harness"], os.cpu_count() or 1, "release")
    return release / "cli" / "pardel-harness"


class Rounds:
    def __init__(self, folder, options):
        self.folder, self.options, self.children = folder, options, Children()
        self.state = {
            "mesher": options.harness, "cases_of_a_round": options.cases or 220,
            "options": options.harness_options or "", "seed": options.seed, "rounds": 0, "cases": 0, "seconds": 0.0,
            "verdicts": {},
            "families": {}, "finds": [], "history": []}
        state = folder / "state.json"
        if state.exists():
            if not has_begun(folder):
                raise Stop(f"{folder}: this campaign is of the fuzz targets, not of a mesher")
            self.state = read_json(state, self.state.keys() - {"cases_of_a_round", "options"})
            self.keep("--harness", "mesher", options.harness)
            self.keep("--harness-options", "options", options.harness_options)
            self.keep("--cases", "cases_of_a_round", options.cases)

    def keep(self, option, key, given):
        """One campaign has one mesher and one set of options: its figures are added up."""
        stored = self.state.get(key)
        if stored is None and given is None:
            raise Stop(f"{self.folder}: an earlier version began this campaign, and did not store {option}; "
                       "give it again")
        if stored is None or given is not None and self.state["rounds"] == 0:
            self.state[key] = given
        elif given not in (None, stored):
            raise Stop(f"{self.folder}: this campaign has {option} '{stored}'; it cannot be changed")

    def command(self, program, work):
        return [str(program), "--mesher", self.state["mesher"],
                "--cases", str(self.state["cases_of_a_round"]), "--seed", str(self.state["seed"]),
                "--jobs", str(self.options.jobs), "--json", str(work / "report.json"),
                "--report", str(work / "report.md"), "--failures", str(work / "failures"),
                *shlex.split(self.state["options"])]

    def account(self, work, seconds):
        report = read_json(work / "report.json", ("families", "failures", "kinds"))
        state = self.state
        state["rounds"] += 1
        state["seed"] += 1
        state["seconds"] += seconds
        for family, row in report["families"].items():
            counts = state["families"].setdefault(family, {})
            for verdict, count in row.items():
                counts[verdict] = counts.get(verdict, 0) + count
                state["verdicts"][verdict] = state["verdicts"].get(verdict, 0) + count
                state["cases"] += count
        replays = {failure["case"]: failure["replay"] for failure in report["failures"]}
        known = {(f["verdict"], f["kind"]): f for f in state["finds"]}
        for kind in report["kinds"]:
            entry = known.get((kind["verdict"], kind["kind"]))
            if entry:
                entry["times"] += kind["cases"]
                continue
            state["finds"].append({"verdict": kind["verdict"], "kind": kind["kind"], "times": kind["cases"],
                                   "case": kind["first"], "message": kind["message"],
                                   "poly": Path(kind.get("smallest", {}).get("poly", "")).name,
                                   "replay": replays.get(kind["first"], "")})
        if (work / "failures").is_dir():
            for file in (work / "failures").iterdir():
                place = self.folder / "finds" / file.name
                place.parent.mkdir(exist_ok=True)
                if not place.exists():
                    shutil.move(str(file), str(place))
        state["history"].append([round(state["seconds"], 1), state["cases"], len(state["finds"])])

    def save(self):
        safe_files.replace(self.folder / "state.json", json.dumps(self.state))
        (self.folder / "summary.json").write_text(
            json.dumps({"schema": "pardel.campaign/1", **self.state}, indent=1) + "\n")
        verdicts = sorted(self.state["verdicts"])
        text = [f"# Campaign: `{self.state['mesher']}`", "",
                f"{self.state['cases']:,} cases in {self.state['rounds']} rounds, "
                f"{summary.duration(self.state['seconds'])}, "
                f"{summary.counted(len(self.state['finds']), 'kind')} of failures.", "",
                "| family | " + " | ".join(verdicts) + " |", "|---|" + "---:|" * len(verdicts)]
        for family, counts in self.state["families"].items():
            text.append(f"| {family} | " + " | ".join(str(counts.get(v, 0)) for v in verdicts) + " |")
        text += ["", "![kinds of failures over time](coverage.svg)", "", "## Failures", ""]
        if not self.state["finds"]:
            text.append("No failures.")
        for find in sorted(self.state["finds"], key=lambda find: (find["verdict"], find["kind"])):
            text += [f"- **{find['verdict']}** {find['kind']}, {summary.counted(find['times'], 'time')}"
                     + (f": {find['message']}" if find["message"] else ""),
                     f"  - smallest: finds/{find['poly']}", f"  - replay: `{find['replay']}`"]
        (self.folder / "summary.md").write_text("\n".join(text) + "\n")
        (self.folder / "coverage.svg").write_text(summary.plot(
            {"cases": [(s / 3600, c) for s, c, _ in self.state["history"]],
             "kinds of failures": [(s / 3600, f) for s, _, f in self.state["history"]]}, "hours", ""))

    def run(self, program):
        end = time.time() + 3600 * self.options.hours
        while not self.children.stopping and time.time() < end:
            work = self.folder / "work"
            shutil.rmtree(work, ignore_errors=True)
            work.mkdir()
            began = time.time()
            child = self.children.start(self.command(program, work), stdout=subprocess.DEVNULL)
            child.wait()
            if child.returncode == INTERRUPTED or self.children.stopping:
                self.save()  # an interruption of the first round leaves a campaign, too
                break
            if child.returncode not in (0, 1):
                raise Stop(f"{program} ended with exit code {child.returncode}")
            self.account(work, time.time() - began)
            self.save()
            print(f"round {self.state['rounds']}: {self.state['cases']:,} cases so far, "
                  f"{summary.counted(len(self.state['finds']), 'kind')} of failures", flush=True)
        shutil.rmtree(self.folder / "work", ignore_errors=True)


def has_begun(folder):
    """Is the campaign in this folder one of a mesher?"""
    state = folder / "state.json"
    return state.exists() and "mesher" in read_json(state, ())


def run(folder, options):
    rounds = Rounds(folder, options)
    program = options.harness_program or built_program(not options.no_build)
    rounds.children.stop_on_signals()
    rounds.run(program)
    print(folder / "summary.md")
    return 1 if rounds.state["finds"] else 0
