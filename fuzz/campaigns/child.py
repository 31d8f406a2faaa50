"""Processes that a script starts and ends, each with its own children in a process group of its own."""
import os
import signal
import subprocess
import threading
import time


def remove_openmp_file(pid):
    """LLVM's OpenMP library removes this file at the end of a process, but not if the process is killed or ends as
    libFuzzer does. Campaigns start many processes, and the files are in memory."""
    try:
        os.remove(f"/dev/shm/__KMP_REGISTERED_LIB_{pid}_{os.getuid()}")
    except OSError:
        pass


class Child:
    """A process. Signals of a terminal do not reach it: the script decides when it ends. If the script dies, even by
    SIGKILL, Linux sends it SIGTERM."""

    def __init__(self, command, **options):
        # So that no signal is sent to a process that has been waited for. A handler of signals may interrupt send().
        self.lock = threading.RLock()
        self.process = subprocess.Popen(["setpriv", "--pdeathsig", "TERM", *map(str, command)], start_new_session=True,
                                        **options)

    @property
    def returncode(self):
        return self.process.returncode

    def send(self, number):
        """Sends a signal to the process and its children, unless it has ended."""
        with self.lock:
            if self.process.returncode is None:
                os.killpg(self.process.pid, number)

    def wait(self, seconds=None):
        """Waits for the end of the process. Returns its seconds of processor time; or nothing if it takes longer than
        `seconds`; it is then killed."""
        end = time.monotonic() + (float("inf") if seconds is None else seconds)
        pause = 0.001
        while True:
            with self.lock:
                process, status, used = os.wait4(self.process.pid, os.WNOHANG)
                if process:
                    self.process.returncode = os.waitstatus_to_exitcode(status)
                    remove_openmp_file(process)
                    return used.ru_utime + used.ru_stime
            if time.monotonic() > end:
                self.send(signal.SIGKILL)
                self.wait()
                return None
            time.sleep(pause)
            pause = min(2 * pause, 0.1)


class Children:
    """The processes of a script, which several threads may start. After stop() all get SIGTERM, also those that are
    started later."""

    def __init__(self):
        self.stopping = False
        self.lock = threading.RLock()  # a handler of signals may interrupt start()
        self.running = []

    def start(self, command, **options):
        child = Child(command, **options)
        with self.lock:
            self.running = [other for other in self.running if other.returncode is None] + [child]
        if self.stopping:
            child.send(signal.SIGTERM)
        return child

    def stop(self, *_):
        self.stopping = True
        with self.lock:
            running = list(self.running)
        for child in running:
            child.send(signal.SIGTERM)

    def stop_on_signals(self):
        """SIGINT and SIGTERM to this script are calls of stop()."""
        signal.signal(signal.SIGINT, self.stop)
        signal.signal(signal.SIGTERM, self.stop)
