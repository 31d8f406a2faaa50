"""How the scripts of fuzz/ end: 0 if nothing was found, 1 if something was, 2 if a script could not do its work."""
import subprocess
import sys
from pathlib import Path


class Stop(Exception):
    """The reason why a script cannot do its work."""


def run(main):
    """Calls main() and ends the script with its result, or with 2 and a message."""
    try:
        result = main()
    except (Stop, OSError, subprocess.CalledProcessError) as error:
        print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        result = 2
    sys.exit(result)
