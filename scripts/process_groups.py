"""Commands with all processes that they start. For the scripts of bench/ and fuzz/."""
import os
import signal
import subprocess


def run(words, timeout=None, **options):
    """Like subprocess.run(), with the output as text, for a command that may start others, such as a build. If the
    script is interrupted, or the command takes more than `timeout` seconds, all of these processes are killed."""
    with subprocess.Popen(words, text=True, start_new_session=True, **options) as process:
        try:
            output, errors = process.communicate(timeout=timeout)
        except BaseException:
            os.killpg(process.pid, signal.SIGKILL)
            raise
    return subprocess.CompletedProcess(words, process.returncode, output, errors)
