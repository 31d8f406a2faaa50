"""Files that a script replaces while another one may read them, and folders that only one script may use."""
import contextlib
import fcntl
import sys
from pathlib import Path


def replace(file, text):
    """Writes a file. Whoever reads it sees the old or the new text; so does a script that goes on after SIGKILL."""
    fresh = Path(f"{file}.new")
    fresh.write_text(text)
    fresh.replace(file)


@contextlib.contextmanager
def locked(folder, script):
    """While the context lasts, no other script changes the campaign in this folder. `script` is its name, for the error
    if another one does."""
    with open(Path(folder) / "lock", "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            sys.exit(f"{script}: {folder}: another process is working on this campaign")
        yield
