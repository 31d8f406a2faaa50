"""The scripts of bench/ as modules."""
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import unittest.mock

from measuring import command, commits


def load(name):
    loader = importlib.machinery.SourceFileLoader(name, os.path.join(commits.ROOT, "bench", name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def call(module, *arguments):
    """Calls a script with arguments. Returns its exit code and what it printed."""
    printed = io.StringIO()
    with unittest.mock.patch("sys.argv", [module.__name__, *arguments]), unittest.mock.patch("signal.signal"), \
            contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        try:
            command.run(module.__name__, module.main)
        except SystemExit as end:
            if isinstance(end.code, str):  # Python prints it, and ends with exit code 1
                return 1, printed.getvalue() + end.code
            return end.code or 0, printed.getvalue()
    return 0, printed.getvalue()
