"""What bench/gate, bench/track and bench/compare share: runs of the workloads, commits, statistics, the history."""
