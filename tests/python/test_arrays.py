"""Many slots and headings at once: the numbers of one at a time, any arrays, any number of threads, and Ctrl-C."""
import math
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest
import snug

CAR = snug.find_car("renault-zoe")
SLOT = snug.Slot(4.5, 2.0)
RNG = np.random.default_rng(5)


def same(a, b):
    a, b = np.asarray(a), np.asarray(b)
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def test_entries_are_those_of_one_slot_at_a_time():
    lengths, widths = RNG.uniform(3.9, 5.5, 200), RNG.uniform(1.7, 2.4, 200)
    rows = snug.entries(CAR, lengths, widths, clearance=0.01)
    for row, length, width in zip(rows, lengths, widths, strict=True):
        one = snug.entry(CAR, snug.Slot(length, width), clearance=0.01)
        if not one.parkable:
            assert row["direction_changes"] == -1 and all(math.isnan(row[name]) for name in row.dtype.names[1:])
            continue
        assert row["direction_changes"] == one.direction_changes
        assert (row["heading_min"], row["heading_max"]) in [(r.min, r.max) for r in one.ranges]
        assert one.maneuver.entry.heading == row["entry_heading"]
    assert 20 < (rows["direction_changes"] >= 0).sum() < 200


def test_sizes_are_broadcast():
    rows = snug.entries(CAR, np.linspace(4.4, 5.2, 5), [[1.9], [2.0], [2.1]])
    assert rows.shape == (3, 5)
    one = snug.entries(CAR, 4.5, 2.0)
    assert one.shape == () and one["direction_changes"] == 18
    assert snug.entries(CAR, [], []).shape == snug.entries(CAR, [], 2.0).shape == (0,)
    assert snug.min_slots(CAR, [2, 5], widths=[1.9, 2.0, 2.1]).shape == (2, 3)
    assert snug.min_slots(CAR, [2, 5], widths=2.0).shape == (2,) and snug.min_slots(CAR, 2, widths=[1.9, 2.0]).shape == (2,)
    assert snug.min_slots(CAR, [2], lengths=[[4.8, 5.0]]).shape == (1, 1, 2)
    assert snug.min_slots(CAR, [1, 2], widths=[]).shape == (2, 0) and snug.min_slots(CAR, [], widths=[2.0]).shape == (0, 1)
    assert snug.min_slots(CAR, [0, 1, 2], widths=[2.2, 2.3], strategy="fewest", precision=0.1, resolution=0.02).shape == (3, 2)


def test_minimum_slots_are_those_of_one_at_a_time():
    rows = snug.min_slots(CAR, [1, 5], widths=[1.78, 2.0])
    for i, changes in enumerate([1, 5]):
        for k, width in enumerate([1.78, 2.0]):
            one = snug.min_slot(CAR, width=width, max_changes=changes)
            assert math.isnan(rows[i, k]["length"]) if one.length is None else abs(one.length - rows[i, k]["length"]) < 1e-6
    options = dict(precision=0.02, resolution=0.01)
    rows = snug.min_slots(CAR, [0, 2], widths=[2.1, 2.3], strategy="fewest", **options)
    for i, changes in enumerate([0, 2]):
        for k, width in enumerate([2.1, 2.3]):
            one = snug.min_slot(CAR, width=width, strategy="fewest", max_changes=changes, **options)
            assert rows[i, k]["length"] == pytest.approx(one.length, abs=0.03)
            assert 0 < rows[i, k]["lower"] <= rows[i, k]["length"]
    steps = snug.Stepping(step=0.01, heading_step=0.01)
    assert snug.min_slots(CAR, [5], widths=[2.2], strategy=steps, step=0.05)["length"] >= snug.min_slot(CAR, width=2.2, max_changes=5).length


def test_counts_from_many_headings():
    headings = np.linspace(0.3, 0.7, 2000).reshape(4, 500)
    counts = snug.direction_changes(CAR, SLOT, headings)
    assert counts.shape == (4, 500) and counts.max() > 18 and counts.min() == -1
    assert same(snug.direction_changes(CAR, (4.5, 2.0), headings), counts)
    assert same(snug.direction_changes(CAR, (np.full((4, 1), 4.5), [2.0]), headings), counts)
    for i in RNG.integers(0, 500, 20):
        run = snug.max_steer(CAR, SLOT, headings[1, i])
        assert counts[1, i] == (run.maneuver.direction_changes if run.outcome == "parked" else -1)


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_answers_are_the_same_for_any_number_of_threads(threads):
    lengths, widths = RNG.uniform(4.2, 5.5, 300), RNG.uniform(1.8, 2.4, 300)
    assert same(snug.entries(CAR, lengths, widths, threads=threads), snug.entries(CAR, lengths, widths))
    headings = np.linspace(0.3, 0.7, 9000)
    assert same(snug.direction_changes(CAR, SLOT, headings, threads=threads), snug.direction_changes(CAR, SLOT, headings))
    assert same(snug.min_slots(CAR, [1, 3], widths=widths[:9], threads=threads), snug.min_slots(CAR, [1, 3], widths=widths[:9]))


def test_arrays_of_any_kind():
    plain = np.linspace(4.4, 5.4, 11)
    want = snug.entries(CAR, plain, 2.0)
    locked = plain.copy()
    locked.flags.writeable = False
    spread = np.repeat(plain, 3)[::3]
    for lengths in (locked, spread, list(plain), tuple(plain), plain.astype(">f8"), plain[::-1][::-1], plain.astype(object).tolist()):
        assert same(snug.entries(CAR, lengths, 2.0), want)
    assert (spread == plain).all() and not locked.flags.writeable
    assert same(snug.entries(CAR, plain.reshape(1, 11).T, 2.0)[:, 0], want)
    assert same(snug.entries(CAR, np.array([5, 6], dtype=np.uint8), 2), snug.entries(CAR, [5.0, 6.0], 2.0))
    assert same(snug.entries(CAR, plain.astype(np.float32), 2.0), snug.entries(CAR, plain.astype(np.float32).astype(float), 2.0))
    want[0]["direction_changes"] = 7  # the answer is the caller's


@pytest.mark.parametrize("call, error, says", [
    (lambda: snug.entries(CAR, [4.5, math.nan], 2.0), snug.Error, "lengths[1] is nan m"),
    (lambda: snug.entries(CAR, [[4.5, 5.0], [4.5, -1]], 2.0), snug.Error, "lengths[1, 1] is -1 m"),
    (lambda: snug.entries(CAR, 4.5, math.inf), snug.Error, "widths is inf m"),
    (lambda: snug.entries(CAR, [4.5, 5], [2, 2, 2]), snug.Error, "lengths (2,), widths (3,)"),
    (lambda: snug.entries(CAR, "long", 2.0), TypeError, "lengths must be an array of numbers"),
    (lambda: snug.entries(CAR, [4.5, None], 2.0), TypeError, "lengths must be an array of numbers"),
    (lambda: snug.entries(CAR, [[4.5], [5, 6]], 2.0), TypeError, "lengths must be an array of numbers"),
    (lambda: snug.entries(CAR, [4.5 + 1j], 2.0), TypeError, "lengths must be an array of numbers"),
    (lambda: snug.entries(CAR, np.array([True]), 2.0), TypeError, "lengths must be an array of numbers"),
    (lambda: snug.entries(CAR, np.array(["2020-01-01"], "M8[D]"), 2.0), TypeError, "lengths must be"),
    (lambda: snug.entries(CAR, [4.5], 2.0, threads=-1), snug.Error, "threads is -1"),
    (lambda: snug.entries(CAR, [4.5], 2.0, clearance=math.nan), snug.Error, "clearance"),
    (lambda: snug.direction_changes(CAR, SLOT, [0.1, 2.0]), snug.Error, "headings[1] is 2 rad"),
    (lambda: snug.direction_changes(CAR, SLOT, [math.nan]), snug.Error, "headings[0] is nan rad"),
    (lambda: snug.direction_changes(CAR, 4.5, [0.1]), TypeError, "slot must be"),
    (lambda: snug.direction_changes(CAR, (4.5, "w"), [0.1]), TypeError, "widths must be"),
    (lambda: snug.direction_changes(CAR, ([4.5, 5], 2), [0.1, 0.2, 0.3]), snug.Error, "headings (3,)"),
    (lambda: snug.min_slots(CAR, [1.5], widths=[2.0]), TypeError, "max_changes must be an array of whole numbers"),
    (lambda: snug.min_slots(CAR, [1, -2], widths=[2.0]), snug.Error, "max_changes[1] is -2"),
    (lambda: snug.min_slots(CAR, [10**12], widths=[2.0]), snug.Error, "max_changes is too large"),
    (lambda: snug.min_slots(CAR, [2**64], widths=[2.0]), TypeError, "max_changes must be"),
    (lambda: snug.min_slots(CAR, [1], widths=[2.0, math.nan]), snug.Error, "widths[1] is nan m"),
    (lambda: snug.min_slots(CAR, [1], lengths=[0.0]), snug.Error, "lengths[0] is 0 m"),
    (lambda: snug.min_slots(CAR, [1], widths=[math.nan], strategy="fewest"), snug.Error, "widths[0] is nan m"),
])
def test_errors_name_the_argument_and_the_element(call, error, says):
    with pytest.raises(error) as raised:
        call()
    assert says in str(raised.value)


def test_the_interpreter_is_free_meanwhile():
    ticks = []
    running = True

    def tick():
        while running:
            ticks.append(time.monotonic())
            time.sleep(0.001)

    other = threading.Thread(target=tick)
    other.start()
    start = time.monotonic()
    snug.fewest(CAR, snug.Slot(4.4, 1.85), resolution=0.001, time_limit=0.3)
    snug.min_slots(CAR, [0, 5, 10], widths=np.linspace(1.8, 2.4, 200))
    end = time.monotonic()
    running = False
    other.join()
    assert any(start < t < end for t in ticks)


def test_progress_of_many():
    told = []
    lengths = np.linspace(4.4, 5.4, 3)
    steps = snug.Stepping(step=1e-4, heading_step=2e-4)
    assert snug.entries(CAR, lengths, 2.0, strategy=steps, progress=told.append) is not None
    assert told and told == sorted(told) and 0.0 <= told[0] <= told[-1] <= 1.0
    assert snug.entries(CAR, lengths, 2.0, strategy=steps, progress=lambda part: False) is None

    def fails(part):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        snug.entries(CAR, lengths, 2.0, strategy=steps, progress=fails)


@pytest.mark.parametrize("question", [
    "snug.entry(car, slot, strategy=snug.Stepping(step=1e-6, heading_step=1e-6))",
    "snug.fewest(car, snug.Slot(4.4, 1.85), resolution=0.0004)",
    "snug.min_slot(car, width=1.8, strategy='fewest', max_changes=40, resolution=0.0004)",
    "snug.entries(car, np.linspace(4.4, 4.6, 9), 2.0, strategy=snug.Stepping(step=1e-6, heading_step=1e-6))",
    "snug.min_slots(car, [0, 5, 10], widths=np.linspace(1.8, 2.4, 10**6))",
    "snug.min_slots(car, [5], widths=[2.0], strategy=snug.Stepping(step=1e-5, heading_step=1e-5))",
    "snug.min_slots(car, [40], widths=[1.8, 1.81], strategy='fewest', resolution=0.0004)",
    "snug.direction_changes(car, slot, np.full(10**7, 0.486))",
], ids=lambda question: question.split("(")[0])
def test_ctrl_c_ends_long_questions(question):
    program = textwrap.dedent(f"""
        import os, time, numpy as np, snug
        car, slot = snug.find_car("renault-zoe"), snug.Slot(4.5, 2.0)
        snug.entries(car, np.full(99, 4.5), 2.0)  # what TBB keeps
        threads = lambda: len(os.listdir("/proc/self/task"))
        before = threads()
        print("asking", flush=True)
        try:
            {question}
            print("answered")
        except KeyboardInterrupt:
            for _ in range(500):  # one that has been joined may take a moment to be gone
                if threads() > before: time.sleep(0.01)
            print("interrupted", threads() <= before)
    """)
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True,
                             preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
    assert child.stdout.readline() == "asking\n"
    time.sleep(0.3)
    child.send_signal(signal.SIGINT)
    out, _ = child.communicate(timeout=60)
    assert child.returncode == 0 and out == "interrupted True\n", out
