"""Files that a script replaces, and what only one process may use at a time. For the scripts of bench/ and fuzz/."""
import contextlib
import fcntl
import os


def replace(file, text):
    """Writes a file, in a folder that is made if necessary. Whoever reads it sees the old or the new text, also if this
    fails or is interrupted."""
    os.makedirs(os.path.dirname(os.path.abspath(file)), exist_ok=True)
    fresh = f"{file}.new"
    with open(fresh, "w", newline="") as out:
        out.write(text)
    os.replace(fresh, file)


@contextlib.contextmanager
def locked(file, otherwise):
    """While the context lasts, no other process gets the lock that this file stands for. If another one has it, raises
    the exception `otherwise`. The lock of a process that dies is free; the file remains."""
    os.makedirs(os.path.dirname(os.path.abspath(file)), exist_ok=True)
    with open(file, "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise otherwise from None
        yield
