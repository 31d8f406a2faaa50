"""Files that a script replaces."""
import os


def replace(file, text):
    """Writes a file. If this fails or is interrupted, the old file is still there."""
    os.makedirs(os.path.dirname(file), exist_ok=True)
    fresh = f"{file}.new"
    with open(fresh, "w", newline="") as out:
        out.write(text)
    os.replace(fresh, file)
