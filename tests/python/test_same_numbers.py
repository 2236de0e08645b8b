"""Python and the command, which is C++, give the same numbers, bit by bit: JSON carries all their digits."""
import json
import os
import random
import subprocess

import pytest
import snug

COMMAND = os.environ["SNUG_COMMAND"]
CASES = 5000 if os.environ.get("SNUG_SOAK") == "1" else 100  # each starts the command once


def command(*arguments):
    run = subprocess.run([COMMAND, *map(str, arguments), "--format", "json"], capture_output=True, text=True)
    assert run.returncode in (0, 1, 3), run.stderr
    return json.loads(run.stdout)


def pose(p):
    return {"x": p.x, "y": p.y, "heading": p.heading}


def maneuver(m, slot):
    box = snug.swept(m)
    return {
        "direction_changes": m.direction_changes, "length": m.length, "seconds": m.seconds,
        "standing_steers": m.standing_steers, "swept": {name: getattr(box, name) for name in box.__match_args__},
        "entry": pose(m.entry), "goal": pose(m.goal),
        "moves": [{"direction": move.direction, "steering_angle": move.steering_angle, "length": move.length,
                   "start": pose(move.start), "end": pose(move.end),
                   "contact": move.contact and {"car": move.contact.part, "obstacle": move.contact.obstacle}}
                  for move in m.moves],
    }


def expected(answer):
    for move in (answer.get("maneuver") or {}).get("moves", []):
        move.pop("steering", None)
    return answer


def random_car(rng, folder):
    if rng.random() < 0.5:
        car = rng.choice(snug.cars())
        return car, car.name
    wheelbase = rng.uniform(1.8, 3.5)
    car = snug.Car(name="random", width=rng.uniform(1.4, 2.2), front=wheelbase + rng.uniform(0.4, 1.2),
                   rear=rng.uniform(0.3, 1.3), wheelbase=wheelbase, max_steer=rng.uniform(0.4, 0.9))
    file = folder / "car.json"
    fields = {name: getattr(car, name) for name in car.__match_args__}
    file.write_text(json.dumps({name: value for name, value in fields.items() if value is not None}))
    assert json.loads(file.read_text())["max_steer"] == car.max_steer
    return car, file


def random_slot(rng, car):
    return snug.Slot(car.length + rng.uniform(0.3, 1.8), car.width + rng.uniform(0.02, 0.8),
                     side=rng.choice(["right", "left"]),
                     corner=rng.choice([(0.0, 0.0), (rng.uniform(-9, 9), rng.uniform(-9, 9))]),
                     heading=rng.choice([0.0, rng.uniform(-3, 3)]))


def slot_arguments(slot):
    return ["--length", repr(slot.length), "--width", repr(slot.width), "--side", slot.side,
            f"--corner={slot.corner.x!r},{slot.corner.y!r}", f"--heading={slot.heading!r}"]


def test_entry(tmp_path):
    rng = random.Random(1)
    parked = 0
    for case in range(CASES):
        car, name = random_car(rng, tmp_path)
        slot = random_slot(rng, car)
        options = {"clearance": rng.choice([0.0, rng.uniform(0.0, 0.1)]),
                   "enter": rng.choice(["backward", "backward", "forward"])}
        arguments = ["--car", name, *slot_arguments(slot), "--clearance", repr(options["clearance"]), "--enter",
                     options["enter"]]
        kind = rng.choice(["max-steer"] * 8 + ["reversed-trials", "parallel-trials"])
        if kind == "max-steer":
            if rng.random() < 0.4:
                options["max_changes"] = rng.randrange(12)
                arguments += ["--max-changes", options["max_changes"]]
            if rng.random() < 0.3:
                options["min_range"] = rng.uniform(0.0, 0.01)
                arguments += ["--min-range", repr(options["min_range"])]
        else:
            options["strategy"] = snug.ReversedTrials() if kind == "reversed-trials" else snug.ParallelTrials()
        answer = snug.entry(car, slot, **options)
        want = expected(command("entry", *arguments, "--strategy", kind))
        got = {"parkable": answer.parkable,
               "entry_ranges": [{"heading_min": r.min, "heading_max": r.max, "direction_changes": r.direction_changes,
                                 "subrange": r.subrange} for r in answer.ranges]}
        if answer.parkable:
            parked += 1
            got["direction_changes"] = answer.direction_changes
            got["maneuver"] = maneuver(answer.maneuver, slot)
        shown = {key: want[key] for key in got}
        assert got == shown, (case, car, slot, options)
        assert ("maneuver" in want) == answer.parkable
    assert parked > CASES / 3


def test_min_slot(tmp_path):
    rng = random.Random(2)
    for _ in range(CASES // 25):
        car, name = random_car(rng, tmp_path)
        width = car.width + rng.uniform(0.05, 0.8)
        counts = sorted(rng.sample(range(12), 3))
        rows = command("min-slot", "--car", name, "--width", repr(width), "--max-changes", ",".join(map(str, counts)))["rows"]
        got = snug.min_slots(car, counts, widths=width)
        for row, mine in zip(rows, got, strict=True):
            if row["length"] is None:
                assert mine["length"] != mine["length"]
            else:
                assert (mine["length"], mine["width"]) == (row["length"], row["width"])


@pytest.mark.parametrize("seed", range(6))
def test_fewest_and_leave(seed):
    rng = random.Random(seed)
    car = rng.choice(snug.cars())
    slot = snug.Slot(car.length + rng.uniform(0.7, 1.2), car.width + rng.uniform(0.1, 0.5), side=rng.choice(["right", "left"]))
    answer = snug.fewest(car, slot, resolution=0.004)
    want = expected(command("entry", "--car", car.name, *slot_arguments(slot), "--strategy", "fewest", "--resolution", "0.004"))
    assert (answer.proved, answer.lower_bound) == (want["proved"], want["lower_bound"])
    assert (answer.maneuver and maneuver(answer.maneuver, slot)) == want.get("maneuver")

    gaps = rng.uniform(0.2, 0.4), rng.uniform(0.01, 0.05)
    parked = snug.parked_pose(car, slot, front=gaps[0], curb=gaps[1])
    answer = snug.leave(car, slot, parked, resolution=0.004)
    want = expected(command("leave", "--car", car.name, *slot_arguments(slot), "--gap-front", repr(gaps[0]), "--gap-curb",
                            repr(gaps[1]), "--resolution", "0.004"))
    assert (answer.proved, answer.lower_bound) == (want["proved"], want["lower_bound"])
    assert (answer.maneuver and maneuver(answer.maneuver, slot)) == want.get("maneuver")
