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
from ._snug import *

__version__ = _snug.__version__
__all__ = ["plot", *(name for name in vars(_snug) if not name.startswith("_"))]

for _name in __all__[1:]:
    getattr(_snug, _name).__module__ = "snug"  # where people find it
del _name
