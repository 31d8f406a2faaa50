"""What bench/gate, bench/track and bench/compare share: runs of the workloads, commits, statistics, the history."""
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "scripts"))  # for safe_files, process_groups
