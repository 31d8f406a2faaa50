"""Domains in Triangle's file format, with vertices that are counted from 1."""
import os
import tempfile

import pardel.compat.triangle as tr

poly = """
5 2 1 1   # vertices with one attribute and a marker
1 0 0  10 0
2 4 0  20 0
3 4 3  30 7
4 0 3  40 0
5 2 1  25 0
4 1
1 1 2 1
2 2 3 2
3 3 4 1
4 4 1 3
0
"""
domain = tr.loads(poly=poly)
with tempfile.TemporaryDirectory() as folder:
    with open(os.path.join(folder, "plate.poly"), "w") as file:
        file.write(poly)
    same = tr.load(folder, "plate")
mesh = tr.triangulate(domain, "pq30")
