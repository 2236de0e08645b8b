"""The exact solver for parallel parking.

Given a car and a slot between two parked cars: from which positions can the car enter, with how few direction changes,
along which maneuver, and how small may the slot be?

    >>> import snug
    >>> car = snug.find_car("renault-zoe")
    >>> answer = snug.entry(car, snug.Slot(length=4.5, width=2.0))
    >>> answer.direction_changes
    18

Lengths are metres, angles radians, poses the middle of the rear axle. Values are immutable. Arguments that cannot be
raise `Error`, a `ValueError`, or `TypeError`, and name the argument. `snug.plot` draws with matplotlib.
"""
from . import _snug, plot as plot
from ._snug import (
    Box as Box,
    Car as Car,
    Contact as Contact,
    Answer as Answer,
    Error as Error,
    FewestProgress as FewestProgress,
    FirstContact as FirstContact,
    HeadingRange as HeadingRange,
    Maneuver as Maneuver,
    MapBounds as MapBounds,
    MaxSteer as MaxSteer,
    MaxSteerRun as MaxSteerRun,
    MinSlot as MinSlot,
    Move as Move,
    ParallelTrials as ParallelTrials,
    ParkAnswer as ParkAnswer,
    ParkMap as ParkMap,
    Point as Point,
    Pose as Pose,
    ReversedTrials as ReversedTrials,
    ReversedTrialsByGoal as ReversedTrialsByGoal,
    Scene as Scene,
    Shortfall as Shortfall,
    Slot as Slot,
    Stepping as Stepping,
    Street as Street,
    Stretch as Stretch,
    blackburn_extra_length as blackburn_extra_length,
    cars as cars,
    direction_changes as direction_changes,
    drive as drive,
    entries as entries,
    entry as entry,
    fewest as fewest,
    find_car as find_car,
    first_contact as first_contact,
    frame as frame,
    leave as leave,
    max_steer as max_steer,
    min_slot as min_slot,
    min_slots as min_slots,
    parallel_trials as parallel_trials,
    park as park,
    parked_pose as parked_pose,
    read_car as read_car,
    read_scene as read_scene,
    reversed_trials as reversed_trials,
    reversed_trials_by_goal as reversed_trials_by_goal,
    sheet_cars as sheet_cars,
    shortfall as shortfall,
    standard_start as standard_start,
    steer_for_curb_to_curb as steer_for_curb_to_curb,
    steer_for_turning_radius as steer_for_turning_radius,
    stepping as stepping,
    swept as swept,
    trajectory as trajectory,
    waypoints as waypoints,
)

__version__ = _snug.__version__
__all__ = ["plot", *(name for name in vars(_snug) if not name.startswith("_"))]

for _name in __all__[1:]:
    getattr(_snug, _name).__module__ = "snug"  # where people find it
del _name
