"""Files that a script replaces while another one may read them."""
from pathlib import Path


def replace(file, text):
    """Writes a file. Whoever reads it sees the old or the new text; so does a script that goes on after SIGKILL."""
    fresh = Path(f"{file}.new")
    fresh.write_text(text)
    fresh.replace(file)
