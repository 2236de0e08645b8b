# In which of many slots does a car park, and how much shorter may slots be where they are wider? On all cores.
import numpy as np
import snug

car = snug.find_car("renault-zoe")

# 40 lengths times 20 widths, as NumPy broadcasts them: one row of the answer for each slot.
lengths = np.linspace(4.2, 5.2, 40)
widths = np.linspace(1.8, 2.3, 20)[:, np.newaxis]
found = snug.entries(car, lengths, widths)
changes = found["direction_changes"]
print(found.shape, f"{np.mean(changes >= 0):.0%} of them can be entered, {np.mean((0 <= changes) & (changes <= 5)):.0%} "
      "with 5 direction changes at most")

# How precisely must the driver enter? The width of the range of headings, where there is one.
tolerance = np.degrees(found["heading_max"] - found["heading_min"])
print(f"in half of these the range is wider than {np.nanmedian(tolerance):.2f} degrees")

# Shortest slots: a row for each number of direction changes, a column for each width.
shortest = snug.min_slots(car, [1, 5, 10], widths=[1.9, 2.0, 2.1])
print(np.round(shortest["length"], 3))

# Prints:
# (20, 40) 64% of them can be entered, 42% with 5 direction changes at most
# in half of these the range is wider than 1.12 degrees
# [[5.334 5.152 5.152]
#  [4.9   4.666 4.666]
#  [4.771 4.552 4.552]]
