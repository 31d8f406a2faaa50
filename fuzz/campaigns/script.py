"""How the Python scripts of fuzz/ end: 0 if all is well; 1 if there are finds, or a canary was not found; 2 if a script
could not do its work; 130 and 143 after SIGINT and SIGTERM, unless the script ends its work in an orderly way then."""
import json
import signal
import subprocess
import sys
import traceback
from pathlib import Path


class Stop(Exception):
    """The reason why a script cannot do its work."""


def read_json(file, keys):
    """The object in a file. Raises Stop if there is none, or if it lacks one of these keys."""
    try:
        value = json.loads(file.read_text())
    except ValueError as error:
        raise Stop(f"{file}: this file is damaged: {error}") from None
    if not isinstance(value, dict):
        raise Stop(f"{file}: this file is damaged: it is no JSON object")
    for key in keys:
        if key not in value:
            raise Stop(f"{file}: this file is damaged: it has no '{key}'")
    return value


def check_numbers(parser, options, **least):
    """Ends the script with a message if an option that has a value is not a number from `least` on."""
    for name, bound in least.items():
        number = getattr(options, name)
        if number is not None and not bound <= number < float("inf"):
            parser.error(f"--{name} has to be a number from {bound} on")


def run(main):
    """Calls main() and ends the script with its result, or with 2 and a message."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        result = main()
    except (Stop, OSError, subprocess.SubprocessError) as error:
        print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        result = 2
    except KeyboardInterrupt:
        result = 130
    except Exception:  # pylint: disable=broad-except  # Python's own exit code would be 1
        traceback.print_exc()
        result = 2
    sys.exit(result)
