"""How busy the machine is with other work, as Linux tells it (pressure stall information)."""
import time

FILE = "/proc/pressure/cpu"
BUSY = 0.1  # above this share, times of the clock say little


def stalled_seconds(file=FILE):
    """For how long, since the machine started, some process was ready to run and had no processor; nothing if the kernel
    does not tell."""
    try:
        with open(file) as lines:
            for line in lines:
                if line.startswith("some"):
                    return 1e-6 * int(line.rsplit("total=", 1)[1])
    except (OSError, IndexError, ValueError):
        pass
    return None


class Watch:
    """The share of the time since its start in which some process waited for a processor. While a program with as many
    threads as there are processors runs alone, it is small."""

    def __init__(self, stalled=stalled_seconds, clock=time.monotonic):
        self._stalled, self._clock = stalled, clock
        self._start = stalled(), clock()

    def share(self):
        """From 0 to 1; nothing if the kernel does not tell."""
        before, after, seconds = self._start[0], self._stalled(), self._clock() - self._start[1]
        if before is None or after is None or seconds <= 0:
            return None
        return min(1.0, max(0.0, (after - before) / seconds))
