"""How the Python scripts of fuzz/ end: 0 if all is well; 1 if there are finds, or a canary was not found; 2 if a script
could not do its work."""
import subprocess
import sys
import traceback
from pathlib import Path


class Stop(Exception):
    """The reason why a script cannot do its work."""


def run(main):
    """Calls main() and ends the script with its result, or with 2 and a message."""
    try:
        result = main()
    except (Stop, OSError, subprocess.SubprocessError) as error:
        print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        result = 2
    except Exception:  # pylint: disable=broad-except  # Python's own exit code would be 1
        traceback.print_exc()
        result = 2
    sys.exit(result)
