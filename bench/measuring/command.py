"""Commands that the scripts of bench/ run, and how these scripts end."""
import os
import signal
import subprocess
import sys

import process_groups

LONGEST = 3600  # seconds that a command may take


class Failed(Exception):
    """What was asked for cannot be done. The message says why; it has the output of a command that failed."""


def output(*command, cwd=None, threads=1, **environment):
    """The standard output of a command. environment: more variables."""
    words = [str(word) for word in command]
    variables = {**os.environ, "OMP_NUM_THREADS": str(threads), **environment}  # waiting threads would be counted, too
    try:
        result = process_groups.run(words, LONGEST, cwd=cwd, env=variables, stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE)
    except OSError as error:
        raise Failed(f"{words[0]} cannot be started: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        raise Failed(f"{' '.join(words)} took more than {LONGEST} s") from None
    if result.returncode != 0:
        raise Failed(f"{' '.join(words)} failed\n{result.stdout}{result.stderr}")
    return result.stdout


def run(name, main):
    """Calls the main function of a script, and ends the process with its result. Exit code 1: something failed; 130 and
    143: SIGINT and SIGTERM. The command that runs then is killed, with the processes that it has started."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        sys.exit(main())
    except (Failed, OSError) as error:
        sys.exit(f"{name}: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
