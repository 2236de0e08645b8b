"""Pictures of parking on matplotlib's axes: `maneuver`, `entries`, `ranges` and `min_slots`.

Each draws on the Axes passed as `ax`, or on one of its own, and returns it. Maneuvers and entry positions are drawn to
scale in the slot's own frame, the road at the top; one on the left is seen by cars that drive to the left. Colours are
those of the command's pictures. matplotlib is imported when the first picture is asked for.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

from . import _snug

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

__all__ = ["entries", "maneuver", "min_slots", "ranges"]

# Okabe and Ito's colours, apart for colour-blind readers too.
_INK, _FAINT, _RULE = "#22272e", "#6b7480", "#d7dbe0"
_SLOT, _FLOOR, _ENTRY, _GOAL, _FORWARD, _CONTACT = "#0072b2", "#f5f9fc", "#e08a00", "#009e73", "#b0307c", "#f0e442"
_ENTRY_TEXT, _GOAL_TEXT = "#a86500", "#00734f"
_ROAD, _BLOCKED, _CURB, _SIDEWALK, _SWEPT = "#e6e8eb", "#d5d9de", "#b9b6ae", "#f3f1ec", "#dde5ea"
_NEIGHBOUR, _NEIGHBOUR_GLASS, _NEIGHBOUR_LINE = "#c3c9d1", "#aab3be", "#98a2ae"

# A car from above: u from 0 at the rear to 1 at the front, v from -1 on the right to 1 on the left.
_BODY = """M .08 -1 L .84 -1 C .945 -1 .982 -.9 .988 -.58 C 1.004 -.2 1.004 .2 .988 .58 C .982 .9 .945 1 .84 1 L .08 1
    C .03 1 .008 .93 .005 .66 C -.002 .25 -.002 -.25 .005 -.66 C .008 -.93 .03 -1 .08 -1 Z"""
_GLASS = """M .69 -.8 C .735 -.4 .735 .4 .69 .8 C .64 .87 .58 .88 .5 .88 L .26 .88 C .18 .88 .14 .84 .09 .72
    C .07 .3 .07 -.3 .09 -.72 C .14 -.84 .18 -.88 .26 -.88 L .5 -.88 C .58 -.88 .64 -.87 .69 -.8 Z
    M .595 -.7 L .19 -.68 C .165 -.35 .165 .35 .19 .68 L .595 .7 C .625 .35 .625 -.35 .595 -.7 Z"""


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("snug.plot needs matplotlib (in Debian: apt-get install python3-matplotlib)") from error
    return pyplot


def _axes(ax: Axes | None, width: float, height: float) -> Axes:
    pyplot = _pyplot()
    if ax is None:
        _, ax = pyplot.subplots(figsize=(width, height), constrained_layout=True)
    return ax


def _is(value: Any, kind: type, name: str) -> None:
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a snug.{kind.__name__}, not {type(value).__name__}")


class _View:
    """From the world to the picture: the slot's frame, turned by half a turn for a slot on the left."""

    def __init__(self, slot: _snug.Slot):
        _is(slot, _snug.Slot, "slot")
        self.slot = slot
        self.left = slot.side == "left"
        self.turn = -slot.heading + (np.pi if self.left else 0.0)
        self.x_min, self.x_max = (0.0, slot.length) if self.left else (-slot.length, 0.0)

    def __call__(self, points: Any) -> Any:
        dx, dy = np.moveaxis(np.asarray(points, float) - tuple(self.slot.corner), -1, 0)
        c, s = np.cos(self.turn), np.sin(self.turn)
        return np.stack([c * dx - s * dy, s * dx + c * dy], axis=-1)

    def pose(self, pose: _snug.Pose) -> tuple[float, float, float]:
        x, y = self((pose.x, pose.y))
        return x, y, pose.heading + self.turn

    def frames(self, car: _snug.Car, poses: Any) -> Any:
        """The corners of its outline at each pose."""
        if car.outline is None:
            return self(_snug.frame(car, poses))
        return self(_placed_points(car.outline, np.asarray(poses, float)[..., None, :]))


def _placed_points(points: Any, poses: Any) -> Any:
    """Points of the car in the world, each with the car at its pose."""
    ahead, left = np.moveaxis(np.asarray(points, float), -1, 0)
    x, y, heading = np.moveaxis(np.asarray(poses, float), -1, 0)
    c, s = np.cos(heading), np.sin(heading)
    return np.stack([x + c * ahead - s * left, y + s * ahead + c * left], axis=-1)


def _outline(text: str) -> Any:
    from matplotlib.path import Path

    codes: list[Any] = []
    points: list[float] = []
    kinds = {"M": Path.MOVETO, "L": Path.LINETO, "C": Path.CURVE4, "Z": Path.CLOSEPOLY}
    for word in text.replace("Z", "Z 0 0").split():
        if word in kinds:
            kind = kinds[word]
        else:
            points.append(float(word))
            codes.append(kind)
    return Path(np.reshape(points, (-1, 2)), codes[::2])


def _placed(path: Any, x: float, y: float, heading: float) -> Any:
    from matplotlib.transforms import Affine2D

    return path.transformed(Affine2D().rotate(heading).translate(x, y))


def _car(ax: Axes, car: _snug.Car, place: tuple[float, float, float], body: Any, outline: Any, glass: Any,
         zorder: float) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.transforms import Affine2D

    size = Affine2D().scale(car.length, car.width / 2).translate(-car.rear, 0.0)
    for text, colour, edge in ((_BODY, body, outline), (_GLASS, glass, "none")):
        path = _placed(_outline(text).transformed(size), *place)
        ax.add_patch(PathPatch(path, facecolor=colour, edgecolor=edge, linewidth=0.6, zorder=zorder))


def _wheels(ax: Axes, car: _snug.Car, place: tuple[float, float, float], steering_angle: float, colour: Any,
            zorder: float) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path
    from matplotlib.transforms import Affine2D

    along, across = 0.065 * car.length, 0.05 * car.width
    tyre = Path([(along, across), (-along, across), (-along, -across), (along, -across), (along, across)], closed=True)
    for axle, turn in ((0.0, 0.0), (min(car.wheelbase, car.front), steering_angle)):
        for side in (-1, 1):
            at = Affine2D().rotate(turn).translate(axle, side * (car.width / 2 - 1.5 * across))
            ax.add_patch(PathPatch(_placed(tyre.transformed(at), *place), facecolor=colour, edgecolor="none",
                                   zorder=zorder))


def _measure(ax: Axes, start: tuple[float, float], end: tuple[float, float], text: str) -> None:
    ax.annotate("", start, end, zorder=6, annotation_clip=False,
                arrowprops={"arrowstyle": "|-|,widthA=.25,widthB=.25", "color": _SLOT, "linewidth": 0.9,
                            "shrinkA": 0, "shrinkB": 0})
    upright = start[0] == end[0]
    ax.annotate(text, ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2), (7, 0) if upright else (0, -4),
                textcoords="offset points", ha="left" if upright else "center", va="center" if upright else "top",
                color=_SLOT, weight="bold", fontsize=9, annotation_clip=False)


def _street(ax: Axes, view: _View, car: _snug.Car, top: float, left: float, right: float) -> None:
    """Road, curb, neighbours and the slot. `top`, `left`, `right` is what must be seen."""
    from matplotlib.patches import FancyBboxPatch, Rectangle

    slot = view.slot
    margin = 0.45 * car.length
    x_min, x_max = min(view.x_min, left) - margin, max(view.x_max, right) + margin
    y_min, y_max = -slot.width - 0.38 * car.width, top + 0.12 * car.width
    ax.set_aspect("equal")
    ax.set(xlim=(x_min, x_max + 0.16 * car.length), ylim=(y_min, y_max))
    ax.set_axis_off()
    street = FancyBboxPatch((x_min, y_min), x_max - x_min, y_max - y_min, facecolor=_ROAD, edgecolor="none", zorder=0,
                            boxstyle=f"round,pad=0,rounding_size={0.04 * car.width}")
    ax.add_patch(street)

    def box(x0: float, x1: float, y0: float, y1: float, colour: str) -> None:
        patch = ax.add_patch(Rectangle((x0, y0), x1 - x0, y1 - y0, facecolor=colour, edgecolor="none", zorder=0.1))
        patch.set_clip_path(street)

    box(x_min, x_max, y_min, -slot.width, _SIDEWALK)
    box(x_min, x_max, -slot.width - 0.03 * car.width, -slot.width, _CURB)
    box(x_min, view.x_min, -slot.width, 0.0, _BLOCKED)
    box(view.x_max, x_max, -slot.width, 0.0, _BLOCKED)
    box(view.x_min, view.x_max, -slot.width, 0.0, _FLOOR)
    before = len(ax.patches)
    for x in (view.x_max + car.rear, view.x_min - car.front):
        _car(ax, car, (x, -car.width / 2, 0.0), _NEIGHBOUR, _NEIGHBOUR_LINE, _NEIGHBOUR_GLASS, 0.2)
    for patch in ax.patches[before:]:
        patch.set_clip_path(street)
    ax.plot([view.x_min, view.x_min, view.x_max, view.x_max], [0, -slot.width, -slot.width, 0], color=_SLOT,
            linewidth=1.8, solid_capstyle="butt", zorder=4)
    ax.plot([view.x_min, view.x_max], [0, 0], color=_SLOT, linewidth=0.9, dashes=(5, 4), zorder=4)
    below = -slot.width - 0.16 * car.width
    _measure(ax, (view.x_min, below), (view.x_max, below), f"{slot.length:.2f} m")
    beside = x_max + 0.03 * car.length
    _measure(ax, (beside, 0.0), (beside, -slot.width), f"{slot.width:.2f} m")


def _frames(ax: Axes, frames: Any, zorder: float, **style: Any) -> None:
    from matplotlib.collections import PolyCollection

    if len(frames):
        ax.add_collection(PolyCollection(frames, closed=True, zorder=zorder, **style), autolim=False)


def _halo() -> list[Any]:
    from matplotlib import patheffects

    return [patheffects.withStroke(linewidth=2.5, foreground="#ffffffd9")]


def _paths(ax: Axes, view: _View, maneuver: _snug.Maneuver, zorder: float) -> None:
    """The rear axle centre's path: driven backward a line of ink, forward an open one."""
    for move in maneuver.moves:
        if move.length == 0.0:
            continue
        whole = _snug.Maneuver(maneuver.car, [move]).poses(max(move.length / 40, 1e-9))
        at = view(whole[:, :2])
        backward = move.direction == "backward"
        ax.plot(*at.T, color=_INK if backward else _FORWARD, linewidth=2.0 if backward else 2.6, zorder=zorder,
                solid_capstyle="round")
        if not backward:
            ax.plot(*at.T, color="white", linewidth=1.0, zorder=zorder + 0.01, solid_capstyle="round")
        middle = len(at) // 2
        ax.annotate("", at[middle], at[middle - 1], zorder=zorder + 0.02,
                    arrowprops={"arrowstyle": "-|>,head_width=.22,head_length=.45", "linewidth": 0.9, "shrinkA": 0,
                                "shrinkB": 0, "edgecolor": _INK if backward else _FORWARD,
                                "facecolor": _INK if backward else "white"})


def _contact_points(view: _View, maneuver: _snug.Maneuver) -> Any:
    corners = ("front-left corner", "rear-left corner", "rear-right corner", "front-right corner")
    car, slot = maneuver.car, view.slot
    points: list[Any] = []
    for move in maneuver.moves:
        if move.contact is None:
            continue
        part, obstacle = move.contact.part, move.contact.obstacle
        if obstacle == "front corner":  # which an edge meets
            points.append(tuple(slot.to_world(_snug.Point(0.0, -slot.front_setback))))
        elif obstacle == "rear corner":
            points.append(tuple(slot.to_world(_snug.Point(-slot.length, -slot.rear_setback))))
        elif part.endswith("wheel"):
            points.append(_placed_points(car.wheels[move.contact.index], move.end))
        elif car.outline is not None:
            points.append(_placed_points(car.outline[move.contact.index], move.end))
        else:
            points.append(_snug.frame(car, move.end)[corners.index(part)])
    return view(np.reshape(points, (-1, 2)))


def _changes(count: int) -> str:
    return "no direction change" if count == 0 else "1 direction change" if count == 1 else f"{count} direction changes"


def _enlarged(ax: Axes, view: _View, maneuver: _snug.Maneuver, y_max: float) -> None:
    """The path once more, in the free road over the neighbour the car does not stand above."""
    x_min, x_max = ax.get_xlim()
    frames = view.frames(maneuver.car, np.array([tuple(move.start) for move in maneuver.moves]))
    part = np.linspace(0.0, 1.0, 50)[:, None, None, None]
    sides = frames + part * (np.roll(frames, 1, axis=1) - frames)
    above = sides[sides[..., 1] > 0.0]
    if not len(above):
        return
    free_left, free_right = above[:, 0].min() - x_min, x_max - 0.16 * maneuver.car.length - above[:, 0].max()
    gap = 0.03 * maneuver.car.length
    free = max(free_left, free_right) - 2 * gap
    height = min(y_max - 2 * gap, 0.8 * free)
    if free < 0.25 * maneuver.car.length or height < 0.15 * maneuver.car.length:
        return
    left = x_min + gap if free_left >= free_right else x_max - 0.16 * maneuver.car.length - gap - free
    inset = ax.inset_axes([left, y_max - gap - height, free, height], transform=ax.transData, zorder=7)
    inset.set(xticks=[], yticks=[], facecolor=_FLOOR)
    inset.set_title("rear axle centre, enlarged", fontsize=7, color=_FAINT, loc="left", pad=-9, x=0.03, y=0.98)
    for spine in inset.spines.values():
        spine.set(color=_RULE, linewidth=0.8)
    _paths(inset, view, maneuver, 3)
    points = view(maneuver.poses(max(maneuver.length / 200, 1e-9))[:, :2])
    middle, size = (points.max(0) + points.min(0)) / 2, np.ptp(points, axis=0)
    scale = 1.2 * max(size[0], size[1] * free / height, 1e-9)
    inset.set(xlim=middle[0] + scale * np.array([-0.5, 0.5]),
              ylim=middle[1] + scale * height / free * np.array([-0.5, 0.5]))


def maneuver(maneuver: _snug.Maneuver, slot: _snug.Slot, ax: Axes | None = None, *, swept: bool = True,
             legend: bool = True) -> Axes:
    """Draws a maneuver in its slot, to scale.

    The entry position is orange, the goal green, the frames at the direction changes are thin lines, later ones darker,
    and what the car sweeps is shaded (`swept`); contacts are yellow, the paths of the rear axle centre are dark driven
    backward and open driven forward.
    """
    _is(maneuver, _snug.Maneuver, "maneuver")
    view = _View(slot)
    car, moves = maneuver.car, maneuver.moves
    if not moves:
        raise _snug.Error("maneuver has no moves: there is nothing to draw")
    ax = _axes(ax, 9.0, 5.0)
    covered = view.frames(car, maneuver.poses(max(maneuver.length / 150, 1e-6)))
    top = max(covered[..., 1].max(), 0.5 * car.width)
    _street(ax, view, car, top, covered[..., 0].min(), covered[..., 0].max())
    if swept:
        _frames(ax, covered, 1, facecolor=_SWEPT, edgecolor=_SWEPT, linewidth=0.3)
    entry, goal = view.pose(moves[0].start), view.pose(moves[-1].end)
    _car(ax, car, goal, _GOAL + "24", _GOAL + "73", _GOAL + "33", 2)
    _car(ax, car, entry, _ENTRY + "21", _ENTRY + "66", _ENTRY + "2e", 2.1)
    _wheels(ax, car, entry, moves[0].steering_angle, _ENTRY + "80", 2.2)
    _frames(ax, view.frames(car, moves[-1].end)[None], 2.3, facecolor="none", edgecolor=_GOAL, linewidth=2.0)
    _frames(ax, view.frames(car, moves[0].start)[None], 2.4, facecolor="none", edgecolor=_ENTRY, linewidth=2.0)
    turns = [a.end for a, b in zip(moves, moves[1:]) if a.direction != b.direction]
    if turns:
        shades = [(0.133, 0.153, 0.18, 0.16 + 0.34 * i / len(turns)) for i in range(1, len(turns) + 1)]
        _frames(ax, view.frames(car, np.array([tuple(pose) for pose in turns])), 2.5, facecolor="none",
                edgecolor=shades, linewidth=0.6)
    contacts = _contact_points(view, maneuver)
    ax.plot(*contacts.T, "D", color=_CONTACT, markeredgecolor=_INK, markeredgewidth=0.8, markersize=4.5, zorder=5)
    _paths(ax, view, maneuver, 4.5)
    for place, colour in ((entry, _ENTRY_TEXT), (goal, _GOAL_TEXT)):
        ax.plot(*place[:2], "+", color=colour, markersize=9, markeredgewidth=1.3, zorder=5.5)
    if len(moves) >= 4:
        _enlarged(ax, view, maneuver, ax.get_ylim()[1])

    off_parallel = abs(np.degrees(slot.to_slot(moves[0].start).heading))
    along, across = np.array([np.cos(entry[2]), np.sin(entry[2])]), np.array([-np.sin(entry[2]), np.cos(entry[2])])
    side = -1.0 if np.cos(entry[2]) < 0.0 else 1.0
    beside = entry[:2] + along * (car.front - car.rear) / 2 + side * across * (car.width / 2 + 0.03 * car.length)
    turn = np.degrees(entry[2]) + (0.0 if side > 0 else 180.0)
    ax.text(*beside, f"entry position, heading {off_parallel:.2f}°", rotation=turn, rotation_mode="anchor",
            ha="center", va="bottom", color=_ENTRY_TEXT, weight="bold", fontsize=9, path_effects=_halo(), zorder=6)
    at = np.array(goal[:2]) + 0.82 * car.front * np.array([np.cos(goal[2]), np.sin(goal[2])])
    ax.text(*at, "goal", ha="center", va="center", color=_GOAL_TEXT, weight="bold", fontsize=9, path_effects=_halo(),
            zorder=6)
    name = (car.name or "car") + " in " + f"{slot.length:.2f} × {slot.width:.2f} m"
    ax.set_title(f"{name}: {_changes(maneuver.direction_changes)}, {maneuver.length:.3f} m driven", loc="left",
                 fontsize=11, weight="bold", color=_INK)
    if legend:
        from matplotlib import patheffects
        from matplotlib.lines import Line2D

        hollow = [patheffects.Stroke(linewidth=width, foreground=colour)
                  for width, colour in ((2.6, _FORWARD), (1.0, "white"))]
        signs = [Line2D([], [], color=_INK, linewidth=2.0, label="driven backward"),
                 Line2D([], [], color=_FORWARD, path_effects=hollow, label="driven forward"),
                 Line2D([], [], color=_INK, alpha=0.5, linewidth=0.6, label="frame at a direction change"),
                 Line2D([], [], marker="D", linestyle="", color=_CONTACT, markeredgecolor=_INK, markersize=4.5,
                        label="contact")]
        ax.legend(handles=signs, loc="upper left", bbox_to_anchor=(0.0, 0.0), ncol=len(signs), frameon=False,
                  fontsize=8, labelcolor=_FAINT, borderaxespad=0.2)
    return ax


def entries(car: _snug.Car, slot: _snug.Slot, answer: _snug.Answer, ax: Axes | None = None, *, frames: int = 14,
            clearance: float = 0.0, enter: str = "backward") -> Axes:
    """Draws the fan of entry positions found and their goals, to scale.

    Entry positions are orange, spread over all ranges of `answer` (at least the middle of each), the goals they lead to
    green. `clearance` and `enter` are what entry() was asked with.
    """
    _is(car, _snug.Car, "car")
    _is(answer, _snug.Answer, "answer")
    view = _View(slot)
    ax = _axes(ax, 9.0, 5.0)
    total = sum(r.max - r.min for r in answer.ranges)
    starts, goals = [], []
    for r in answer.ranges:
        count = max(1, round(frames * (r.max - r.min) / total) if total > 0.0 else 1)
        headings = np.linspace(r.min, r.max, count) if count > 1 else np.array([(r.min + r.max) / 2])
        for heading in headings:
            run = _snug.max_steer(car, slot, heading, max_changes=r.direction_changes, clearance=clearance,
                                  enter=enter)  # type: ignore[arg-type]
            if run.outcome == "parked":
                starts.append(tuple(run.maneuver.moves[0].start))
                goals.append(tuple(run.maneuver.moves[-1].end))
    covered = view.frames(car, np.reshape(starts + goals, (-1, 3)))
    if len(covered):
        _street(ax, view, car, max(covered[..., 1].max(), 0.5 * car.width), covered[..., 0].min(), covered[..., 0].max())
    else:
        _street(ax, view, car, car.width, view.x_min, view.x_max)
    alpha = 0.75 if len(starts) > 6 else 1.0
    for poses, colour, cross, zorder in ((goals, _GOAL, _GOAL_TEXT, 2), (starts, _ENTRY, _ENTRY_TEXT, 3)):
        if poses:
            _frames(ax, view.frames(car, np.array(poses)), zorder, facecolor="none", edgecolor=colour, linewidth=1.1,
                    alpha=alpha)
            ax.plot(*view(np.array(poses)[:, :2]).T, "+", color=cross, markersize=6, markeredgewidth=1.0, zorder=5)
    name = (car.name or "car") + " in " + f"{slot.length:.2f} × {slot.width:.2f} m"
    if answer.ranges:
        counts = sorted({r.direction_changes for r in answer.ranges})
        first, last = np.degrees([answer.ranges[0].min, answer.ranges[-1].max])
        said = (f"{counts[0]} to " if len(counts) > 1 else "") + _changes(counts[-1])
        ranges_said = "" if len(answer.ranges) == 1 else f" in {len(answer.ranges)} ranges"
        title = f"{name}: {said}, headings from {first:.2f}° to {last:.2f}°{ranges_said}"
    else:
        title = f"{name}: " + ("no ranges" if answer.parkable else "cannot park")
    ax.set_title(title, loc="left", fontsize=11, weight="bold", color=_INK)
    return ax


def _plain(ax: Axes) -> None:
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        ax.spines[side].set_color(_FAINT)
    ax.tick_params(colors=_FAINT, labelsize=8)
    ax.grid(True, color="#eceef1", linewidth=0.7)
    ax.set_axisbelow(True)


def _shade(position: float) -> Any:
    """Of viridis, which the figures of the paper have too, without its lightest end."""
    return _pyplot().get_cmap("viridis")(0.88 * position)


def ranges(answer: _snug.Answer, ax: Axes | None = None) -> Axes:
    """Draws the ranges of entry headings over their direction changes."""
    _is(answer, _snug.Answer, "answer")
    ax = _axes(ax, 8.0, 3.0)
    _plain(ax)
    counts = sorted({r.direction_changes for r in answer.ranges})
    for r in answer.ranges:
        colour = _shade(counts.index(r.direction_changes) / max(1, len(counts) - 1))
        start, end = np.degrees([r.min, r.max])
        ax.broken_barh([(start, end - start)], (r.direction_changes - 0.36, 0.72), facecolor=colour, edgecolor=colour,
                       linewidth=0.8)
    if counts:
        from matplotlib.ticker import MaxNLocator

        ax.yaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
        ax.set_ylim(counts[0] - 0.6, counts[-1] + 0.6)
        first, last = np.degrees([answer.ranges[0].min, answer.ranges[-1].max])
        room = max(0.05 * (last - first), 1e-3)
        ax.set_xlim(first - room, last + room)
        ax.ticklabel_format(axis="x", useOffset=False)
    ax.set_xlabel("entry heading [°]", color=_INK, fontsize=9)
    ax.set_ylabel("direction changes", color=_INK, fontsize=9)
    return ax


def min_slots(sizes: ArrayLike, max_changes: ArrayLike, slots: Any, ax: Axes | None = None, *,
              name: str | None = None) -> Axes:
    """Draws curves of minimum slots, one for each maximum of direction changes.

    `slots` is what min_slots(car, max_changes, widths=sizes) or min_slots(car, max_changes, lengths=sizes) answered; those
    over all maneuvers are drawn as thick as what is not decided. `name` is the title, as the car's name.
    """
    given, counts = np.atleast_1d(np.asarray(sizes, float)), np.atleast_1d(np.asarray(max_changes))
    rows = np.asarray(slots)
    fields = rows.dtype.names or ()
    if "lower" not in fields:
        raise TypeError("slots must be what min_slots() answered")
    if rows.shape not in (counts.shape + given.shape, given.shape, counts.shape, ()) or rows.size != counts.size * given.size:
        raise _snug.Error(f"slots has the shape {rows.shape}, but must have {counts.shape + given.shape}: that of "
                          "max_changes followed by that of sizes")
    if given.ndim != 1 or counts.ndim != 1:
        raise _snug.Error("sizes and max_changes must each be a list of numbers")
    rows = rows.reshape(counts.size, given.size)
    bounded = bool(np.any(rows["lower"] > 0))
    lengths_given = not np.all(rows["width"] == given)
    sought, other = ("width", "length") if lengths_given else ("length", "width")
    ax = _axes(ax, 7.0, 4.5)
    _plain(ax)
    order = np.argsort(given)
    ends: list[tuple[float, float, str, Any]] = []
    for i, k in enumerate(np.argsort(counts)):
        colour = _shade(i / max(1, counts.size - 1))
        found = rows[sought][k][order]
        if bounded:
            ax.fill_between(given[order], rows["lower"][k][order], found, color=colour, linewidth=1.4)
        else:
            ax.plot(given[order], found, color=colour, linewidth=1.6, solid_joinstyle="round",
                    marker="o" if given.size < 2 else None, markersize=4)
        known = np.flatnonzero(~np.isnan(found))
        if known.size:
            ends.append((float(found[known[-1]]), float(given[order][known[-1]]), str(counts[k]), colour))
    _label_ends(ax, ends)
    ax.set_xlabel(f"slot {other} [m]", color=_INK, fontsize=9)
    ax.set_ylabel("shortest slot [m]" if sought == "length" else "narrowest slot [m]", color=_INK, fontsize=9)
    ax.text(1.0, 1.0, "direction changes allowed", transform=ax.transAxes, ha="right", va="bottom", fontsize=8,
            color=_FAINT)
    if name is not None:
        ax.set_title(name, loc="left", fontsize=11, weight="bold", color=_INK)
    return ax


def _label_ends(ax: Axes, ends: Sequence[tuple[float, float, str, Any]]) -> None:
    """Writes each curve's count to the right of its end, apart from each other."""
    if not ends:
        return
    low, high = ax.get_ylim()
    room = 0.045 * (high - low)
    ends = sorted(ends, key=lambda end: end[0])
    at = np.array([end[0] for end in ends])
    for _ in range(200):  # push neighbours apart, evenly up and down
        lacks = np.maximum(0.0, room - np.diff(at))
        at[:-1] -= lacks / 2
        at[1:] += lacks / 2
    for (y, x, text, colour), shown in zip(ends, at):
        ax.text(x + 0.015 * float(np.ptp(ax.get_xlim())), shown, text, color=colour, weight="bold", fontsize=8,
                va="center")
