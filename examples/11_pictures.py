# A maneuver, all entry positions, their headings and minimum slots on one page.
import numpy as np
import snug
from matplotlib import pyplot

car = snug.find_car("renault-zoe")
slot = snug.Slot(length=5.0, width=2.0)
answer = snug.entry(car, slot, max_changes=6)
widths, changes = np.linspace(1.85, 2.3, 40), [0, 1, 2, 5, 10]

page, axes = pyplot.subplots(2, 2, figsize=(16, 9), width_ratios=[3, 2], constrained_layout=True)
snug.plot.maneuver(answer.maneuver, slot, ax=axes[0, 0])
snug.plot.entries(car, slot, answer, ax=axes[1, 0])
snug.plot.ranges(answer, ax=axes[0, 1])
snug.plot.min_slots(widths, changes, snug.min_slots(car, changes, widths=widths), ax=axes[1, 1], name="Renault ZOE")
page.savefig("parking.png")
print("parking.png")

# Prints:
# parking.png
