# Does a Renault ZOE fit into a slot of 4.5 x 2.0 m, and how? The same from Python.
import snug

car = snug.find_car("renault-zoe")
slot = snug.Slot(length=4.5, width=2.0)
answer = snug.entry(car, slot)
for found in answer.ranges:
    print(f"{found.direction_changes} direction changes from {found.min:.5f} to {found.max:.5f} rad")

# The last three moves.
for move in answer.maneuver.moves[-3:]:
    print(f"{move.direction:8} {move.length:.3f} m until", move.contact.part if move.contact else "parked")

# Where the car is along the way, for a simulator or a controller: an array of x, y, heading.
print(answer.maneuver.poses(spacing=0.05).shape)

# Fewer changes over all maneuvers are possible in a slot this narrow, where full steering fails.
narrow = snug.Slot(length=4.8, width=1.84)
best = snug.fewest(car, narrow)
print(snug.entry(car, narrow).parkable, best.direction_changes, "proved" if best.proved else "")

# Prints:
# 18 direction changes from 0.48503 to 0.48695 rad
# backward 0.192 m until rear-left corner
# forward  0.233 m until front-right corner
# backward 0.344 m until parked
# (48, 3)
# False 8 proved
