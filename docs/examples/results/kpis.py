"""Replications of two runs as a data frame: what a setter more changes, replication by replication."""
import pathlib
import sqlite3
import sys

import pandas

with sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True) as db:
    db.executescript(pathlib.Path("docs/reference/views.sql").read_text())
    frame = pandas.read_sql("SELECT run, replication, kpi, value FROM replications", db)

wide = frame[frame.kpi.isin(["cost_per_part", "throughput_per_h"])].pivot(
    index=["kpi", "replication"], columns="run", values="value")
print(wide.groupby("kpi").mean().round(3).to_string())
change = (wide[2] - wide[1]).groupby("kpi").agg(["mean", "std"]).round(3)
print(change.to_string())
