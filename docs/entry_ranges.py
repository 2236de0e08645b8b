#!/usr/bin/python3
"""Draws the number of direction changes over the entry heading, for two slots.

Usage: entry_ranges.py SNUG PICTURE    (SNUG is the command)
"""
import csv
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SLOTS = [("mid-size", 5.1, 2.2), ("renault-zoe", 4.8, 2.0)]


def ranges(snug, car, length, width):
    command = [snug, "entry", "--car", car, "--length", str(length), "--width", str(width), "--max-changes", "30",
               "--format", "csv"]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(printed.splitlines())]


def draw(snug):
    figure, all_axes = plt.subplots(1, len(SLOTS), figsize=(10, 3.2), constrained_layout=True)
    for axes, (car, length, width) in zip(all_axes, SLOTS):
        found = ranges(snug, car, length, width)
        fewest = min(row["direction_changes"] for row in found)
        for row in found:
            best = row["direction_changes"] == fewest
            axes.plot([row["heading_min"], row["heading_max"]], 2 * [row["direction_changes"]],
                      color="#c0392b" if best else "#3572b0", linewidth=3, solid_capstyle="butt")
        axes.set_title(f"{car}, {length} x {width} m", fontsize=10)
        axes.set_xlabel("entry heading [rad]")
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(axis="y", color="#eee")
        axes.yaxis.get_major_locator().set_params(integer=True)
    all_axes[0].set_ylabel("direction changes")
    return figure


if __name__ == "__main__":
    draw(sys.argv[1]).savefig(sys.argv[2], dpi=110)
