#!/usr/bin/python3
"""Draws what `snug paper` computed: every figure of the paper as PDF and PNG, and report.html with figures and claims.

Usage: figures.py FOLDER    (the folder of `snug paper --out FOLDER`; pictures go there too)
"""
import csv
import html
import json
import math
import os
import sys
from collections import defaultdict
from pathlib import Path

os.environ.setdefault("SOURCE_DATE_EPOCH", "0")  # the same data give the same files
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection
from matplotlib.colors import BoundaryNorm, ListedColormap

# Okabe and Ito's colours, apart for colour-blind readers too; the same roles as in the pictures of `snug entry --draw`.
INK, FAINT, RULE = "#22272e", "#6b7480", "#d7dbe0"
SLOT, ENTRY, GOAL = "#0072b2", "#e08a00", "#009e73"
CARS = {
    "mid-size": ("Mid-sized vehicle", "#b0307c"),
    "renault-zoe": ("Renault ZOE", "#0072b2"),
    "opel-corsa": ("Opel Corsa", "#009e73"),
    "vw-transporter": ("VW transporter", "#c4560a"),
    "mercedes-amg-gt": ("Mercedes-AMG GT", INK),
}
COUNTS = plt.get_cmap("viridis")

plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 9, "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": FAINT,
    "axes.linewidth": 0.7, "axes.spines.top": False, "axes.spines.right": False, "axes.titlesize": 10,
    "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.grid": True, "grid.color": "#eceef1",
    "grid.linewidth": 0.7, "axes.axisbelow": True, "xtick.color": FAINT, "ytick.color": FAINT, "lines.linewidth": 1.5,
    "lines.solid_joinstyle": "round", "pdf.fonttype": 42, "savefig.dpi": 160, "figure.constrained_layout.use": True,
})


def number(text):
    """A field of a CSV file: a number, a word, or None where there is no answer."""
    try:
        return float(text) if text else None
    except ValueError:
        return text


def rows(folder, name):
    with open(folder / f"{name}.csv", newline="", encoding="utf-8") as file:
        return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def curves(points, x="extra_width", y="extra_length"):
    """{(car, changes): (xs, ys)}, without the points that have no answer."""
    found = defaultdict(lambda: ([], []))
    for point in points:
        if point[y] is not None:
            xs, ys = found[point["car"], int(point["max_changes"])]
            xs.append(point[x])
            ys.append(point[y])
    return found


def label_ends(axes, labels, x, room):
    """Writes (y, text, colour) to the right of x, at least `room` (in units of y) apart, joined to their line's end."""
    labels = sorted(labels, key=lambda label: label[0])
    at = [label[0] for label in labels]
    for _ in range(200):  # push neighbours apart, evenly up and down
        for i in range(len(at) - 1):
            lacks = room - (at[i + 1] - at[i])
            if lacks > 1e-9:
                at[i] -= lacks / 2
                at[i + 1] += lacks / 2
    left, right = axes.get_xlim()
    step = (right - left) * 0.045
    for (y, text, colour), shown in zip(labels, at):
        axes.plot([x, x + step], [y, shown], color=colour, linewidth=0.7, clip_on=False, solid_capstyle="butt")
        axes.text(x + 1.15 * step, shown, text, color=colour, va="center", fontsize=8, clip_on=False)


def colour_of_count(changes):
    order = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 30, 40, 50, 100]
    return COUNTS(0.82 - 0.8 * order.index(changes) / (len(order) - 1))


def changes_text(changes):
    return "no change" if changes == 0 else "1 change" if changes == 1 else f"{changes} changes"


# The pictures: each takes the folder of the CSV files and returns a matplotlib figure.


def car_paths(folder):
    figure, all_axes = plt.subplots(1, 5, figsize=(12, 3.3), sharex=True, sharey=True)
    points = rows(folder, "car_paths")
    for axes, (car, (name, colour)) in zip(all_axes, CARS.items()):
        # The nose points up, and the car turns to the left: ahead (x) goes up, left (y) goes left.
        lines = defaultdict(lambda: ([], []))
        for point in points:
            if point["car"] == car:
                lines[point["line"]][0].append(-point["y"])
                lines[point["line"]][1].append(point["x"])
        axes.fill(*lines["frame"], facecolor=matplotlib.colors.to_rgba(colour, 0.13), edgecolor=colour, linewidth=1.2)
        axes.plot(*lines["front-right corner"], color=FAINT, linestyle=(0, (4, 2)), linewidth=1)
        axes.plot(*lines["rear axle"], color=colour)
        axes.plot(0, 0, marker="+", color=colour, markersize=8)
        xs, ys = lines["front-right corner"]
        axes.text(xs[-1], ys[-1] - 0.25, "front-right\ncorner", fontsize=7.5, color=FAINT, ha="center", va="top")
        xs, ys = lines["rear axle"]
        axes.text(xs[-1], ys[-1] - 0.25, "rear axle", fontsize=7.5, color=colour, ha="center", va="top")
        axes.set_aspect("equal")
        axes.set_xlim(-10.2, 1.5)
        axes.set_ylim(-1.7, 7.5)
        axes.set_title(name, color=colour)
        axes.set_xlabel("across [m]")
    all_axes[0].set_ylabel("ahead [m]")
    return figure


def positions(axes, points):
    style = {"possible entry": (ENTRY, 0.7), "entry": (ENTRY, 0.8), "goal": (GOAL, 0.8)}
    corners = ["front_left", "rear_left", "rear_right", "front_right"]
    for point in points:
        frame = [(point[f"{c}_x"], point[f"{c}_y"]) for c in corners]
        if point["position"] == "slot":
            (right, _), (left, _), (_, bottom), _ = frame
            axes.plot([left - 1.2, left, left, right, right, right + 1.2], [0, 0, bottom, bottom, 0, 0], color=SLOT,
                      linewidth=2.4, zorder=3)
            axes.annotate("p", (right, 0), (5, 5), textcoords="offset points", color=SLOT, style="italic", zorder=4)
            axes.text((left + right) / 2, bottom - 0.12, f"slot {right - left:.3f} m by {-bottom:.1f} m", color=SLOT,
                      ha="center", va="top")
            continue
        colour, width = style[point["position"]]
        xs, ys = zip(*frame, frame[0])
        axes.plot(xs, ys, color=colour, linewidth=width, alpha=0.9)
        axes.plot(point["x"], point["y"], marker="+", color=colour, markersize=5, markeredgewidth=0.8)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("along the road [m]")
    axes.set_ylabel("across [m]")
    axes.margins(0.03, 0.08)


def possible_entries(folder):
    figure, axes = plt.subplots(figsize=(7.5, 4.6))
    points = rows(folder, "possible_entries")
    headings = [p["heading"] for p in points if p["position"] != "slot"]
    shown = [p for i, p in enumerate(points) if p["position"] == "slot" or i % 3 == 1]
    positions(axes, shown)
    axes.set_title("Renault ZOE: possible entry positions")
    axes.text(0.02, 0.97, f"headings from 0 to {math.degrees(max(headings)):.0f}°, in steps of 3°", color="#a86500",
              transform=axes.transAxes, va="top", fontsize=8)
    return figure


def entries_and_goals(folder):
    figure, axes = plt.subplots(figsize=(7.5, 4.6))
    points = rows(folder, "entries_and_goals")
    positions(axes, points)
    axes.set_title("Renault ZOE, at most 2 direction changes: entry and goal positions")
    entries = sorted((p for p in points if p["position"] == "entry"), key=lambda p: p["heading"])
    gap = max(range(1, len(entries)), key=lambda i: entries[i]["heading"] - entries[i - 1]["heading"])
    axes.text(-0.6, 1.5, "entry positions", color="#a86500", fontsize=8.5)
    axes.text(-2.1, -1.55, "goal positions", color="#00734f", ha="center", fontsize=8.5)
    # The two subranges differ by less than the lines are wide: the rear-left corners again, enlarged.
    zoom = axes.inset_axes([0.03, 0.62, 0.30, 0.34])
    for entry in entries:
        corners = [(entry[f"{c}_x"], entry[f"{c}_y"]) for c in ("front_left", "rear_left", "rear_right")]
        zoom.plot(*zip(*corners), color=ENTRY, linewidth=1)
    xs, ys = zip(*[(entry["rear_left_x"], entry["rear_left_y"]) for entry in entries])
    zoom.set_xlim(min(xs) - 0.14, max(xs) + 0.08)
    zoom.set_ylim(min(ys) - 0.03, max(ys) + 0.03)
    zoom.set_xticks([])
    zoom.set_yticks([])
    zoom.grid(False)
    for first, last in ((0, gap - 1), (gap, len(entries) - 1)):
        zoom.text(min(xs) - 0.012, (ys[first] + ys[last]) / 2,
                  f"{entries[first]['heading']:.4f} to\n{entries[last]['heading']:.4f} rad", color="#a86500", fontsize=7.5,
                  ha="right", va="center")
    axes.indicate_inset_zoom(zoom, edgecolor=FAINT)
    return figure


def reversed_trials(folder):
    figure, axes = plt.subplots(figsize=(7.5, 4.2))
    points = rows(folder, "reversed_trials")
    lines = [("reversed_trials_their_goal", "reversed trials from the goal\nof Vorobieva et al.", "#c4560a", "-", 5.5, (-40, 45)),
             ("reversed_trials_our_goal", "reversed trials from\nthe goal found here", SLOT, "-", 4.55, (60, 78)),
             ("max_steer", "full steering from the best entry", INK, (0, (1.2, 1.5)), 4.86, (50, 62))]
    for column, text, colour, style, pointed_at, offset in lines:
        shown = [(p["length"], p[column]) for p in points if p[column] is not None and p[column] <= 40]
        axes.step(*zip(*shown), where="mid", color=colour, linestyle=style, linewidth=2.2 if style == "-" else 1.4)
        tip = min(shown, key=lambda point: abs(point[0] - pointed_at))
        axes.annotate(text, tip, offset, textcoords="offset points", color=colour, fontsize=8.5, va="center",
                      arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.7})
    axes.set_xlim(4.4, 5.85)
    axes.set_ylim(-0.6, 30)
    axes.set_xlabel("slot length [m]")
    axes.set_ylabel("direction changes")
    axes.set_title("Renault ZOE, slot 2.0 m wide")
    return figure


def entry_headings(folder):
    figure, axes = plt.subplots(figsize=(7.5, 4.4))
    points = rows(folder, "entry_headings")
    widths = sorted({p["extra_width"] for p in points})
    half = min(b - a for a, b in zip(widths, widths[1:])) / 2
    tints = {10: "#bcd7ea", 5: "#6fa8d2", 2: "#1f6fab", 1: "#0b3a63"}
    ends = []
    for changes, colour in tints.items():  # the headings of a lower limit lie within those of a higher one
        chosen = [p for p in points if p["max_changes"] == changes]
        bars = [[(p["extra_width"] - half, p["heading_min"]), (p["extra_width"] + half, p["heading_min"]),
                 (p["extra_width"] + half, p["heading_max"]), (p["extra_width"] - half, p["heading_max"])] for p in chosen]
        axes.add_collection(PolyCollection(bars, facecolor=colour, edgecolor=colour, linewidth=0.15))
        last = max(p["heading_max"] for p in chosen if p["extra_width"] == widths[-1])
        ends.append((last, f"at most {changes_text(changes)}", {10: "#5a8fb5", 5: "#4485b8"}.get(changes, colour)))
    axes.set_xlim(0, widths[-1])
    axes.set_ylim(0.435, 0.60)
    axes.set_xlabel("extra slot width [m]")
    axes.set_ylabel("entry heading [rad]")
    axes.set_title("Renault ZOE, slot 1.1 m longer than the car")
    label_ends(axes, ends, widths[-1], 0.008)
    return figure


def subranges(folder):
    figure, axes = plt.subplots(figsize=(7.5, 4.6))
    points = rows(folder, "subranges")
    widths = sorted({p["extra_width"] for p in points})
    lengths = sorted({p["extra_length"] for p in points})
    numbers = {(p["extra_length"], p["extra_width"]): int(p["subranges"]) for p in points}
    grid = [[numbers[length, width] for width in widths] for length in lengths]
    most = max(max(row) for row in grid)
    colours = ListedColormap(["#ffffff", "#d9e6ef"] + [plt.get_cmap("inferno")(0.92 - 0.8 * i / max(1, most - 2)) for i in range(most - 1)])
    mesh = axes.pcolormesh(widths, lengths, grid, cmap=colours, norm=BoundaryNorm([i - 0.5 for i in range(most + 2)], most + 1), shading="nearest")
    for y in lengths[1:]:
        axes.axhline(y - 0.05, color="white", linewidth=1.2)
    bar = figure.colorbar(mesh, ax=axes, ticks=range(most + 1), pad=0.02, aspect=25)
    bar.set_label("subranges of entry headings (0: the car cannot park)")
    bar.outline.set_visible(False)
    axes.grid(False)
    axes.set_yticks(lengths)
    axes.set_xlabel("extra slot width [m]")
    axes.set_ylabel("extra slot length [m]")
    axes.set_title("Renault ZOE, at most 10 direction changes")
    return figure


def minimum_panel(axes, folder, points, car, room):
    ends = []
    for (of, changes), (xs, ys) in curves(points).items():
        if of != car:
            continue
        colour = colour_of_count(changes)
        axes.plot(xs, ys, color=colour, linewidth=1.4)
        ends.append((ys[-1], str(changes), colour))
    axes.set_xlim(0, 0.6)
    axes.set_ylim(0.1, 1.9)
    axes.set_xlabel("extra slot width [m]")
    label_ends(axes, ends, 0.6, room)
    axes.set_title(CARS[car][0], color=CARS[car][1])


def minimum_zoe(folder):
    figure, axes = plt.subplots(figsize=(7.5, 6.4))
    minimum_panel(axes, folder, rows(folder, "minimum_zoe"), "renault-zoe", 0.042)
    stepped = [p for p in rows(folder, "minimum_paper_steps") if p["car"] == "renault-zoe" and p["extra_length"] is not None]
    axes.plot([p["extra_width"] for p in stepped], [p["extra_length"] for p in stepped], "o", markersize=3.6,
              markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.8, clip_on=False, zorder=5)
    axes.text(0.335, 1.72, "lines: exact;  ○ the paper's own loop", color=INK, fontsize=8)
    axes.text(1.10, 1.0, "changes\nallowed", color=FAINT, fontsize=8, transform=axes.transAxes, ha="center", va="top")
    axes.set_ylabel("extra slot length [m]")
    return figure


def minimum_others(folder):
    figure, all_axes = plt.subplots(1, 3, figsize=(12, 5.6), sharey=True)
    points = rows(folder, "minimum_others")
    for axes, car in zip(all_axes, ["opel-corsa", "vw-transporter", "mercedes-amg-gt"]):
        minimum_panel(axes, folder, points, car, 0.047)
    all_axes[0].set_ylabel("extra slot length [m]")
    return figure


def car_panels(folder, name, counts, columns):
    points = curves(rows(folder, name))
    figure, all_axes = plt.subplots(1, columns, figsize=(12, 4.6), sharey=True)
    for axes, changes in zip(all_axes, counts):
        for car, (text, colour) in CARS.items():
            if (car, changes) not in points:
                continue
            xs, ys = points[car, changes]
            axes.plot(xs, ys, color=colour)
        axes.set_xlim(0, 0.6)
        axes.set_ylim(0.1, 1.9)
        axes.set_xlabel("extra slot width [m]")
        axes.set_title(changes_text(changes))
        short = {"renault-zoe": "ZOE", "opel-corsa": "Corsa", "vw-transporter": "transporter", "mercedes-amg-gt": "AMG GT"}
        label_ends(axes, [(points[car, changes][1][-1], short[car], CARS[car][1]) for car in short if (car, changes) in points], 0.6, 0.065)
    all_axes[0].set_ylabel("extra slot length [m]")
    return figure


def minimum_all(folder):
    return car_panels(folder, "minimum_all", [1, 2, 5, 10], 4)


def minimum_few_changes(folder):
    return car_panels(folder, "minimum_few_changes", [0, 1, 2, 3, 4], 5)


def minimum_few_changes_absolute(folder):
    figure, axes = plt.subplots(figsize=(8.5, 6))
    points = curves(rows(folder, "minimum_few_changes"), "width", "length")
    for (car, changes), (xs, ys) in points.items():
        axes.plot(xs, ys, color=CARS[car][1], linewidth=1.3)
        axes.annotate(str(changes), (xs[-1], ys[-1]), (4, 0), textcoords="offset points", color=CARS[car][1], fontsize=8,
                      va="center")
        if changes == 0:
            axes.annotate(CARS[car][0], (xs[0], ys[0]), (0, 5), textcoords="offset points", color=CARS[car][1],
                          fontweight="bold")
    axes.set_xlabel("slot width [m]")
    axes.set_ylabel("slot length [m]")
    axes.set_title("The shortest slot for 0 to 4 direction changes")
    return figure


def extra_lengths(folder):
    points = rows(folder, "extra_lengths")
    figure, axes = plt.subplots(figsize=(9, 4.8))
    widths = sorted({p["extra_width"] for p in points}, reverse=True)
    counts = sorted({int(p["max_changes"]) for p in points})
    ticks, names = [], []
    for i, (car, (name, colour)) in enumerate(CARS.items()):
        for j, width in enumerate(widths):
            y = -(i * 2.6 + j)
            chosen = [(p["extra_length"], int(p["max_changes"])) for p in points
                      if p["car"] == car and p["extra_width"] == width and p["extra_length"] is not None]
            axes.plot([min(chosen)[0], max(chosen)[0]], [y, y], color=colour, alpha=0.35, linewidth=1.2)
            groups = []  # what is closer than its marks would be shares one
            for length, changes in sorted(chosen, key=lambda one: one[1]):
                if groups and groups[-1][-1][0] - length < 0.036:
                    groups[-1].append((length, changes))
                else:
                    groups.append([(length, changes)])
            for group in groups:
                axes.text(sum(length for length, _ in group) / len(group), y, ",".join(str(changes) for _, changes in group),
                          color="white" if j == 0 else colour, fontsize=8, ha="center", va="center", fontweight="bold",
                          bbox={"boxstyle": "round,pad=0.28,rounding_size=0.6", "facecolor": colour if j == 0 else "white",
                                "edgecolor": colour, "linewidth": 1})
            ticks.append(y)
            names.append(f"{name}, {width:.1f} m wider" if j == 0 else f"{width:.1f} m wider")
    axes.set_yticks(ticks, names, color=INK)
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.grid(axis="y", visible=False)
    axes.set_xlim(0.3, 1.9)
    axes.set_xlabel("how much longer than the car the slot must be [m]")
    axes.set_title("Numbers in the marks: direction changes allowed")
    return figure


FIGURES = [
    (car_paths, "Car frames, and the paths forward at full steering of the rear axle centre and of the front-right corner."),
    (possible_entries, "A subset of the possible entry positions: the front-right corner at the slot's corner, nothing overlapped. The crosses mark the middle of the rear axle."),
    (entries_and_goals, "Entry positions (orange) and where they lead (green) with at most 2 direction changes; the entry headings fall into two subranges."),
    (reversed_trials, "Direction changes over slot length: several reversed trials from the goal position the paper deduces for Vorobieva et al., from the goal positions found here, and the fewest with full steering (ZOE, slot 2.0 m wide, steps of 0.01 m)."),
    (entry_headings, "Entry headings over extra slot width for at most 1, 2, 5 and 10 direction changes (ZOE, extra slot length 1.1 m). Steps of 0.002 m, exact edges."),
    (subranges, "Number of subranges of entry headings over extra slot width, for extra slot lengths from 0.5 m to 1.9 m and at most 10 direction changes (ZOE)."),
    (minimum_zoe, "Shortest slot for the ZOE over its width. The top line allows no direction change; below it follow at most 1 to 10, 20, 30, 40, 50 and 100. Circles: the paper's own loop with Algorithm 1 at three widths; in narrow slots its steps cost centimetres."),
    (minimum_others, "The same for the other three cars, 0 to 10, 20, 30, 40, 50 and 100 direction changes."),
    (minimum_all, "All four cars with at most 1, 2, 5 and 10 direction changes."),
    (minimum_few_changes, "Appendix: all four cars with 0 to 4 direction changes, extra dimensions."),
    (minimum_few_changes_absolute, "Appendix: the same in absolute dimensions; the numbers at the lines' ends are the direction changes."),
    (extra_lengths, "At a glance: the extra slot length each car needs for 0, 1, 2, 3, 5 and 10 direction changes, in a wide slot (filled) and in a usual one (hollow). Counts that differ by less than 4 cm share a mark."),
]


# The report.

STYLE = """
body { font: 16px/1.5 system-ui, 'DejaVu Sans', sans-serif; color: #22272e; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { line-height: 1.2 } figure { margin: 2.5rem 0 } img { max-width: 100%; display: block; margin: auto }
figcaption { color: #4b535d; font-size: .92rem; margin-top: .5rem } a { color: #0072b2 }
table { border-collapse: collapse; width: 100%; font-size: .92rem } td, th { padding: .45rem .6rem; border-bottom: 1px solid #d7dbe0; text-align: left; vertical-align: top }
td.n, th.n { text-align: right; white-space: nowrap } .yes { color: #00734f; font-weight: 600 } .no { color: #b0307c; font-weight: 600 }
.finding { color: #4b535d; font-size: .88rem } @media print { figure { break-inside: avoid } }
"""


def shown(value, unit):
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.3f} m" if unit == "m" else f"{value:g}"


def claims_table(claims):
    lines = ["<table><tr><th>Claim</th><th class=n>Paper</th><th class=n>Its steps</th><th class=n>Exact</th><th>Agrees</th></tr>"]
    for claim in claims:
        values = "".join(f"<td class=n>{shown(claim[key], claim['unit'])}</td>" for key in ("published", "paper_steps", "exact"))
        verdict = "<td class=yes>yes</td>" if claim["agrees"] else "<td class=no>no</td>"
        where = claim["section"] if claim["section"] == "appendix" else f"section {claim['section']}"
        lines.append(f"<tr id={claim['id']}><td>{html.escape(claim['claim'])} <small>({where})</small>"
                     f"<div class=finding>{html.escape(claim['finding'])}</div></td>{values}{verdict}</tr>")
    return "\n".join(lines + ["</table>"])


def cars_table(folder):
    head = ["car", "width w [m]", "front d<sub>f</sub> [m]", "rear d<sub>r</sub> [m]", "wheelbase b [m]", "φ<sub>max</sub> [°]",
            "turning radius [m]", "curb to curb [m]"]
    lines = ["<table><tr>" + "".join(f"<th class=n>{h}</th>" if i else f"<th>{h}</th>" for i, h in enumerate(head)) + "</tr>"]
    for row in rows(folder, "cars"):
        name, *values = row.values()
        lines.append(f"<tr><td>{CARS[name][0]}</td>" + "".join(f"<td class=n>{v:.0f}</td>" if i == 4 else f"<td class=n>{v:.3f}</td>" for i, v in enumerate(values)) + "</tr>")
    return "\n".join(lines + ["</table>"])


def report(folder):
    claims = json.loads((folder / "claims.json").read_text(encoding="utf-8"))["claims"]
    agreeing = sum(claim["agrees"] for claim in claims)
    figures = "\n".join(
        f"<figure id={draw.__name__}><img src={draw.__name__}.png alt=\"{html.escape(caption)}\"><figcaption>{html.escape(caption)} "
        f"<a href={draw.__name__}.pdf>PDF</a></figcaption></figure>" for draw, caption in FIGURES)
    return f"""<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content="width=device-width">
<title>Optimal entry and minimum slot dimensions, exactly</title><style>{STYLE}</style>
<h1>Parallel parking: optimal entry and minimum slot dimensions, exactly</h1>
<p>Every figure, table and claim of the paper by Vlasak, Sojka and Hanzálek, computed again. <b>Its steps</b> is
Algorithm 1 on the paper's own grids (steps of 1 mm, headings 10<sup>-4</sup> rad and slots 0.01 m apart); <b>exact</b> is
full steering until contact in closed form, with all entry headings. Of {len(claims)} claims {agreeing} agree.</p>
<h2>Claims</h2>
{claims_table(claims)}
<h2>Cars</h2>
{cars_table(folder)}
<h2>Figures</h2>
{figures}
</html>
"""


def save(path, write):
    """Files appear whole or not at all."""
    temporary = path.with_name(f".{path.name}.part")
    try:
        write(temporary)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def main():
    if len(sys.argv) != 2:
        sys.exit("figures.py: give the folder of `snug paper --out FOLDER`")
    folder = Path(sys.argv[1])
    try:
        for draw, _ in FIGURES:
            figure = draw(folder)
            for ending in ("pdf", "png"):
                save(folder / f"{draw.__name__}.{ending}", lambda path: figure.savefig(path, format=ending))
            plt.close(figure)
        save(folder / "report.html", lambda path: path.write_text(report(folder), encoding="utf-8"))
    except OSError as error:
        sys.exit(f"figures.py: {error.filename}: {error.strerror}; run `snug paper --out {folder}` first")
    print(f"The report is {folder / 'report.html'}")


if __name__ == "__main__":
    main()
