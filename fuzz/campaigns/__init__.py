"""What fuzz/campaign and the other scripts of fuzz/ share: targets, processes, slices, finds, summaries."""
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "scripts"))  # for safe_files, process_groups
