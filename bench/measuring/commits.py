"""Commits of this repository, and how the present workloads are built in them."""
import os
import re
import shutil
import subprocess
import textwrap

import process_groups
import safe_files

from . import command
from .command import Failed

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WORKLOADS = os.path.join("bench", "workloads")
BUILD = os.path.join("build", "bench")
# A commit that changes none of these has the instructions of the commit before it.
MEASURED = ["core", "parallel", "distributed", "properties/checker", "properties/domains", "cmake", "CMakeLists.txt",
            "CMakePresets.json"]


def git(*arguments, cwd=None):
    return command.output("git", *arguments, cwd=cwd or ROOT).strip()


def resolve(name):
    """The full hash of a commit."""
    try:
        return git("rev-parse", "--verify", "--quiet", name + "^{commit}")
    except Failed:
        git("rev-parse", "--git-dir")  # without git, or outside a repository, this tells why
        raise Failed(f"{name}: there is no such commit") from None


def subject(commit):
    """The commit and the beginning of its message."""
    try:
        message = git("show", "-s", "--format=%s", commit)
    except Failed:
        return commit[:7]
    return f"{commit[:7]} {textwrap.shorten(message, 90, placeholder=' ...')}"


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
    except Failed:
        return []


def workloads_are_committed():
    """Does this working tree have the workloads of HEAD?"""
    return not git("status", "--porcelain", "--", WORKLOADS)


def locked(tree):
    """A context in which no other process may change this working tree."""
    return safe_files.locked(tree + ".lock", Failed(f"another process is using {tree}"))


def require_own_tree(tree):
    """Otherwise git would change the working tree that contains the folder."""
    try:
        top = git("rev-parse", "--show-toplevel", cwd=tree)
    except Failed:
        top = ""
    if os.path.realpath(top) != os.path.realpath(tree):
        raise Failed(f"{tree} is not a working tree that this script has made; remove this folder")


def check_out(commit, tree):
    """Makes the folder `tree` a working tree of the commit, with the present workloads instead of its own. A build by
    another compiler than the present one is removed."""
    if not os.path.isdir(tree):
        git("worktree", "prune")
        git("worktree", "add", "--detach", tree, commit)
    require_own_tree(tree)
    git("checkout", "-q", "--force", "--detach", commit, cwd=tree)
    shutil.rmtree(os.path.join(tree, WORKLOADS), ignore_errors=True)
    shutil.copytree(os.path.join(ROOT, WORKLOADS), os.path.join(tree, WORKLOADS))  # keeps times, so builds stay valid
    lists = os.path.join(tree, "CMakeLists.txt")
    with open(lists) as file:
        known = f"add_subdirectory({WORKLOADS})" in file.read()
    if not known:
        with open(lists, "a") as file:
            file.write(f"add_subdirectory({WORKLOADS})\n")
    build_folder = os.path.join(tree, BUILD)
    if os.path.exists(build_folder) and built_by(build_folder) != compiler(build_folder):
        shutil.rmtree(build_folder)


def compiler(build_folder):
    """The name and the version of the compiler that a build folder uses, for example g++ 12.2.0; empty if CMake has not
    chosen one."""
    try:
        with open(os.path.join(build_folder, "CMakeCache.txt")) as cache:
            path = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$", cache.read(), re.M)
    except OSError:
        return ""
    if not path:
        return ""
    about = command.output(path[1], "--version").splitlines()[0]
    version = re.search(r"(\d+\.\d+\.\d+)\s*$", about)
    return f"{'clang++' if 'clang' in about else 'g++'} {version[1] if version else about}"


def built_by(build_folder):
    """What compiler() said at the last build that succeeded."""
    try:
        with open(os.path.join(build_folder, "compiler")) as file:
            return file.read()
    except OSError:
        return ""


def program(tree, preset="bench"):
    """The program that runs a workload, in a working tree."""
    return os.path.join(tree, "build", preset, WORKLOADS, "once")


class NotBuilt(Failed):
    """Something does not compile. The message has the end of the compiler's output."""


def build(tree, *targets, preset="bench"):
    for words in (["cmake", "--preset", preset], ["cmake", "--build", "--preset", preset, "--target", *targets]):
        try:
            result = process_groups.run(words, cwd=tree, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        except OSError as error:
            raise Failed(f"{words[0]} cannot be started: {error.strerror}") from None
        if result.returncode != 0:
            end = "\n".join(result.stdout.splitlines()[-20:])
            raise NotBuilt(f"{', '.join(targets)} cannot be built in {tree}\n{end}")
    folder = os.path.join(tree, "build", preset)
    safe_files.replace(os.path.join(folder, "compiler"), compiler(folder))
