"""Commits of this repository, and how the present workloads are built in them."""
import os
import shutil
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WORKLOADS = os.path.join("bench", "workloads")
BUILD = os.path.join("build", "bench")
# Commits that change nothing else have the instructions of the commit before.
MEASURED = ["core", "parallel", "properties/checker", "properties/domains", "cmake", "CMakeLists.txt", "CMakePresets.json"]


def git(*arguments, cwd=None):
    return subprocess.run(["git", *arguments], cwd=cwd or ROOT, check=True, capture_output=True, text=True).stdout.strip()


def resolve(name):
    """The full hash of a commit. Raises ValueError if there is no such commit."""
    try:
        return git("rev-parse", "--verify", "--quiet", name + "^{commit}")
    except subprocess.CalledProcessError:
        raise ValueError(f"{name}: there is no such commit") from None


def subject(commit):
    try:
        return git("show", "-s", "--format=%h %s", commit)
    except subprocess.CalledProcessError:
        return commit[:7]


def line_of(head="HEAD"):
    """The commits of a branch, the oldest first: of a merge, only its own side. Others are not before or after these."""
    return git("rev-list", "--first-parent", "--reverse", head).split()


def last_changes(number, head="HEAD"):
    """The last commits of a branch that change what is measured, the oldest first."""
    newest_first = git("rev-list", "--first-parent", f"--max-count={number}", head, "--", *MEASURED).split()
    return newest_first[::-1]


def changes_between(before, after):
    """The commits after the one, up to the other, that change what is measured, the newest first; none if this
    repository lacks one of them. On a branch, as line_of()."""
    try:
        return git("rev-list", "--first-parent", f"{before}..{after}", "--", *MEASURED).split()
    except subprocess.CalledProcessError:
        return []


def check_out(commit, tree):
    """Makes the folder `tree` a working tree of the commit, with the present workloads instead of its own."""
    if not os.path.isdir(tree):
        git("worktree", "prune")
        git("worktree", "add", "--detach", tree, commit)
    git("checkout", "-q", "--force", "--detach", commit, cwd=tree)
    shutil.rmtree(os.path.join(tree, WORKLOADS), ignore_errors=True)
    shutil.copytree(os.path.join(ROOT, WORKLOADS), os.path.join(tree, WORKLOADS))  # keeps times, so builds stay valid
    lists = os.path.join(tree, "CMakeLists.txt")
    with open(lists) as file:
        known = f"add_subdirectory({WORKLOADS})" in file.read()
    if not known:
        with open(lists, "a") as file:
            file.write(f"add_subdirectory({WORKLOADS})\n")


def program(tree, preset="bench"):
    """The program that runs a workload, in a working tree."""
    return os.path.join(tree, "build", preset, WORKLOADS, "once")


def build(tree, *targets, preset="bench"):
    """Builds targets. Returns the end of the compiler's output if this fails, else nothing."""
    for command in (["cmake", "--preset", preset], ["cmake", "--build", "--preset", preset, "--target", *targets]):
        result = subprocess.run(command, cwd=tree, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if result.returncode != 0:
            return "\n".join(result.stdout.splitlines()[-20:])
    return None
