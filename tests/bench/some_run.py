"""Runs of schemes for the tests of tables, pictures and the cost model."""


def some_run(**changes):
    """A run that was not counted, for the tables."""
    plain = {"scheme": "a", "refines": True, "input": "square", "size": 1e4, "workers": 4, "triangles": 10,
             "sequential": 10, "work": 90, "wasted": 25, "critical": 40, "before": 10, "parallelism": 2.5, "rounds": 3,
             "barriers": 6, "set_backs": 1, "messages": 8, "bytes": 3e6, "most_held": 5, "smallest_angle": 21,
             "certified": True, "seconds": 2.0}
    return {**plain, **changes}
