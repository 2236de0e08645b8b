"""What a call for 10,000 slots gains from the second core, and what Python adds to a slot.

Usage: PYTHONPATH=build/release/bindings/python /usr/bin/python3 bench/python_speed.py

Slots smaller than the car cost C++ next to nothing: their time is what Python adds, an upper bound.
"""
import statistics
import time

import numpy as np
import snug

CAR = snug.find_car("renault-zoe")
SLOTS = 10_000


def seconds(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


lengths = np.linspace(4.9, 5.6, SLOTS)
alone, together = [], []
for _ in range(15):  # in turn, because the machine's pace varies
    alone.append(seconds(lambda: snug.entries(CAR, lengths, 2.0, threads=1)))
    together.append(seconds(lambda: snug.entries(CAR, lengths, 2.0)))
ratios = [one / all_cores for one, all_cores in zip(alone, together)]
print(f"{SLOTS} slots: {statistics.median(together) * 1e3:.0f} ms on all cores (best {min(together) * 1e3:.0f}), "
      f"{statistics.median(ratios):.2f} times as fast as one thread (best against best {min(alone) / min(together):.2f})")

small = np.linspace(3.0, 3.5, SLOTS)
added = [seconds(lambda: snug.entries(CAR, small, 2.0, threads=1)) / SLOTS for _ in range(25)]
print(f"Python adds less than {statistics.median(added) * 1e6:.2f} us to a slot, on one thread")
