#!/usr/bin/python3
"""Draws the shortest slots of the paper's strategy against those over all maneuvers, for the five cars.

Usage: all_maneuvers.py FOLDER PICTURE    (FOLDER holds CAR-max-steer.csv and CAR-fewest.csv of `snug min-slot`)
"""
import sys
from pathlib import Path

from figures import CARS, FAINT, label_ends, plt, rows


def draw(folder):
    figure, all_axes = plt.subplots(1, 5, figsize=(14, 4.6), sharey=True)
    for axes, (car, (name, colour)) in zip(all_axes, CARS.items()):
        paper, best = rows(folder, f"{car}-max-steer"), rows(folder, f"{car}-fewest")
        axes.set_title(name, color=colour)
        labels = []
        for changes in sorted({row["max_changes"] for row in paper}):
            of_paper = [(r["width"], r["length"]) for r in paper if r["max_changes"] == changes and r["length"]]
            of_best = [r for r in best if r["max_changes"] == changes and r["length"]]
            widths = [row["width"] for row in of_best]
            axes.fill_between(widths, [row["length_lower"] for row in of_best], [row["length"] for row in of_best],
                              color=colour, linewidth=1.2)
            if of_paper:
                axes.plot(*zip(*of_paper), color=FAINT, linewidth=1, linestyle=(0, (3, 1.5)))
            labels.append((of_best[-1]["length"], f"{changes:.0f}", colour))
        axes.set_xlabel("slot width [m]")
        label_ends(axes, labels, max(row["width"] for row in best), 0.12)
    all_axes[0].set_ylabel("shortest slot [m]")
    all_axes[0].text(0.03, 0.03, "solid: over all maneuvers, as thick as\nwhat is not decided\n"
                     "dashed: the paper's strategy\nnumbers: direction changes allowed", transform=all_axes[0].transAxes,
                     fontsize=8, color=FAINT)
    return figure


if __name__ == "__main__":
    draw(Path(sys.argv[1])).savefig(sys.argv[2])
