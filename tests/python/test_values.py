"""Values, their errors, and whether what help() and the type checker say is so."""
import copy
import inspect
import json
import math
import pickle

import pytest
import snug

CAR = snug.find_car("renault-zoe")
SLOT = snug.Slot(length=4.5, width=2.0)
ANSWER = snug.entry(CAR, SLOT)
MANEUVER = ANSWER.maneuver
MOVE = MANEUVER.moves[0]
WEDGE = snug.Car(wheelbase=2.6, max_steer=0.6, outline=[(3.6, 0.5), (-0.8, 0.9), (-0.8, -0.9), (3.6, -0.5)], name="wedge")
VALUES = [CAR, WEDGE, SLOT, snug.Slot(5, 2, front_setback=0.1, rear_setback=0.2, curb="low"), MANEUVER, MOVE, MOVE.contact, MOVE.start, snug.Point(1, 2), snug.MaxSteer(), snug.Stepping(step=0.01),
          snug.ReversedTrials(goal=(1, 2, 0)), snug.ParallelTrials(), snug.Street(5.2, 2.0, road=3.5, parked_curb=0.3)]


@pytest.mark.parametrize("value", VALUES, ids=lambda value: type(value).__name__)
def test_values_are_equal_hashed_copied_and_pickled(value):
    for twin in (copy.deepcopy(value), pickle.loads(pickle.dumps(value))):
        assert twin == value and hash(twin) == hash(value)
    assert value != 3 and (value == object()) is False
    if not isinstance(value, snug.Maneuver):
        assert eval(repr(value), vars(snug)) == value


@pytest.mark.parametrize("value", VALUES, ids=lambda value: type(value).__name__)
def test_values_never_change(value):
    for name in (*value.__match_args__, "anything"):
        with pytest.raises(AttributeError):
            setattr(value, name, 1.0)


def test_differing_values_are_not_equal():
    assert snug.Slot(4.5, 2.0) != snug.Slot(4.5, 2.0, side="left")
    assert CAR != snug.find_car("mid-size")
    assert snug.Stepping() != snug.Stepping(stop="inside")


def test_cars_as_files_describe_them(tmp_path):
    sheet = {"width": 1.8, "length": 4.4, "front_overhang": 1.0, "wheelbase": 2.6, "max_steer": 0.6, "corner_radius": 0.3}
    car = snug.Car.from_dict(sheet)
    assert car.front == 3.6 and len(car.outline) == 24 and car.wall_to_wall < 2 * math.hypot(car.turning_radius + 0.9, 3.6)
    (tmp_path / "car.json").write_text(json.dumps(sheet))
    assert snug.read_car(tmp_path / "car.json") == car
    assert WEDGE.width == 1.8 and CAR.outline is None
    assert snug.Car(wheelbase=2.6, max_steer=0.6, outline=[(3.6, -0.9), (3.6, 0.9), (-0.8, 0.9), (-0.8, -0.9)]) == snug.Car(
        width=1.8, front=3.6, rear=0.8, wheelbase=2.6, max_steer=0.6)
    with pytest.raises(snug.Error, match="looks like millimetres"):
        snug.Car.from_dict(sheet | {"width": 1800})
    with pytest.raises(snug.Error, match="width is missing"):
        snug.Car(wheelbase=2.6, max_steer=0.6)
    with pytest.raises(snug.Error, match="leave it out"):
        snug.Car(wheelbase=2.6, max_steer=0.6, width=1.7, outline=WEDGE.outline)


def test_cars_of_data_sheets_are_found_and_name_their_sheets():
    names = [car.name for car, *_ in snug.sheet_cars()]
    assert names == sorted(set(names)) and not set(names) & {car.name for car in snug.cars()}
    for car, sheet, circle, source in snug.sheet_cars():
        assert snug.find_car(car.name) == car
        assert sheet and ("https://" in source or "github.com/" in source)
        metres = float(circle.removeprefix("radius ").split()[0]) * (2 if circle.startswith("radius") else 1)
        assert math.isclose(car.curb_to_curb, metres * (0.3048 if " ft," in circle else 1), rel_tol=1e-12)
    with pytest.raises(snug.Error, match="'tesla-model-3' or another of mid-size, .*tesla-model-y$"):
        snug.find_car("tesla-model3")


def test_the_first_answer():
    assert ANSWER.parkable and ANSWER.direction_changes == 18 and not ANSWER.cancelled
    assert [round(edge, 5) for r in ANSWER.ranges for edge in (r.min, r.max)] == [0.48503, 0.48695]
    assert repr(MANEUVER).startswith("<Maneuver of renault-zoe: 19 moves, 18 direction changes, 1.93")
    assert not snug.entry(CAR, snug.Slot(3.0, 2.0)).parkable
    assert snug.shortfall(CAR, snug.Slot(3.0, 2.0)) == snug.shortfall(CAR, snug.Slot(3.0, 5.0))


def test_poses_along_a_maneuver():
    poses = MANEUVER.poses(0.01)
    assert poses.shape[1] == 3 and tuple(poses[0]) == tuple(MANEUVER.entry) and tuple(poses[-1]) == tuple(MANEUVER.goal)
    corners = snug.frame(CAR, poses)
    assert corners.shape == (len(poses), 4, 2)
    box = snug.swept(MANEUVER)
    assert corners[..., 0].min() >= box.x_min - 1e-12 and corners[..., 1].max() <= box.y_max + 1e-12
    assert (snug.frame(CAR, MANEUVER.goal) == corners[-1]).all()
    end = snug.drive(CAR, MOVE.start, MOVE.direction, MOVE.steering_angle, MOVE.length)
    assert tuple(end) == pytest.approx(tuple(MOVE.end), abs=1e-12)


def test_waypoints_of_a_maneuver():
    points = snug.waypoints(MANEUVER, 0.05)
    assert (points["x"][0], points["y"][0], points["heading"][0]) == tuple(MANEUVER.entry)
    assert abs(points["distance"][-1] - MANEUVER.length) < 1e-12
    assert (points["direction"][1:] != points["direction"][:-1]).sum() == MANEUVER.direction_changes
    assert abs(points["curvature"]).max() == pytest.approx(1 / CAR.turning_radius)


def test_trajectory_of_a_maneuver():
    points = snug.trajectory(MANEUVER, period=0.1, speed=0.8, steering_rate=0.4)
    assert (points["x"][0], points["y"][0], points["heading"][0]) == tuple(MANEUVER.entry)
    assert (points["x"][-1], points["y"][-1], points["heading"][-1]) == tuple(MANEUVER.goal)
    assert points["time"][1] - points["time"][0] == pytest.approx(0.1)
    assert abs(points["speed"]).max() <= 0.8 and abs(points["steering_rate"]).max() <= 0.4
    assert (points["speed"][points["steering_rate"] != 0] == 0).all()
    assert points["distance"][-1] == pytest.approx(MANEUVER.length)
    with pytest.raises(snug.Error, match="greatest speed is 0"):
        snug.trajectory(MANEUVER, speed=0)


def test_slot_frames_and_poses_as_tuples():
    slot = snug.Slot(4.5, 2.0, side="left", corner=(3, 1), heading=0.4)
    assert slot.corner == snug.Point(3, 1)
    assert tuple(slot.to_slot(slot.to_world((1, 2, 0.3)))) == pytest.approx((1, 2, 0.3))
    assert tuple(slot.to_world(snug.Point())) == pytest.approx((3, 1))
    assert slot.mirrored(0.2) == -0.2


def test_baselines_and_first_contact():
    run = snug.max_steer(CAR, SLOT, 0.486)
    assert run.outcome == "parked" and run.maneuver.direction_changes == 18
    assert snug.max_steer(CAR, SLOT, 1.5).outcome == "no_entry"
    assert snug.stepping(CAR, SLOT, 0.486, snug.Stepping(step=1e-4)).outcome == "parked"
    wide = snug.Slot(5.5, 2.2)
    assert snug.reversed_trials(CAR, wide).direction_changes == snug.reversed_trials_by_goal(CAR, wide).deduced
    assert snug.parallel_trials(CAR, wide) is not None
    contact = snug.first_contact(CAR, SLOT, MOVE.start, MOVE.direction, MOVE.steering_angle)
    assert contact.contact == MOVE.contact and contact.distance == pytest.approx(MOVE.length)
    assert snug.first_contact(CAR, SLOT, (0, 50, 0), "forward", 0.0).distance == math.inf
    assert snug.min_slot(CAR, width=2.0, max_changes=18).length < 4.5 < snug.min_slot(CAR, width=2.0, max_changes=17).length
    assert snug.min_slot(CAR, length=3.0).width is None
    assert 1.0 < snug.blackburn_extra_length(CAR, 1.8) < 2.0


@pytest.mark.parametrize("call, error, says", [
    (lambda: snug.Slot("long", 2), TypeError, "length must be a number, not str"),
    (lambda: snug.Slot(4.5), TypeError, "'width'"),
    (lambda: snug.Slot(4.5, math.nan), snug.Error, "slot width is nan m"),
    (lambda: snug.Slot(4.5, -1), snug.Error, "slot width is -1 m, but must lie between"),
    (lambda: snug.Slot(10**400, 2), snug.Error, "length is too large"),
    (lambda: snug.Slot(4.5, 2, side="middle"), snug.Error, "side is 'middle', but must be one of 'right', 'left'"),
    (lambda: snug.Slot(4.5, 2, side=None), TypeError, "side must be a str"),
    (lambda: snug.Slot(4.5, 2, corner=(1, 2, 3)), TypeError, "corner must be"),
    (lambda: snug.Slot(4.5, 2, corner=(1, "y")), TypeError, "corner[1] must be a number"),
    (lambda: snug.Slot(4.5, 2, corner=5), TypeError, "corner must be"),
    (lambda: snug.Car(width=0, front=3, rear=1, wheelbase=2, max_steer=0.5), snug.Error, "car width is 0 m"),
    (lambda: snug.Car(1, 2, 3), TypeError, "Car() takes 0 positional arguments"),
    (lambda: snug.find_car("renault-zo"), snug.Error, "'renault-zoe'"),
    (lambda: snug.find_car(3), TypeError, "name must be a str"),
    (lambda: snug.entry(3, SLOT), TypeError, "car must be a snug.Car, not int"),
    (lambda: snug.entry(CAR, CAR), TypeError, "slot must be a snug.Slot"),
    (lambda: snug.entry(CAR), TypeError, "'slot'"),
    (lambda: snug.entry(CAR, SLOT, 3), TypeError, "takes 2 positional"),
    (lambda: snug.entry(CAR, SLOT, slot=SLOT), TypeError, "'slot' twice"),
    (lambda: snug.entry(CAR, SLOT, clearence=1), TypeError, "no argument 'clearence'"),
    (lambda: snug.entry(CAR, SLOT, clearance=-1), snug.Error, "clearance"),
    (lambda: snug.entry(CAR, SLOT, max_changes=2.5), TypeError, "max_changes must be a whole number, not float"),
    (lambda: snug.entry(CAR, SLOT, max_changes=10**30), snug.Error, "max_changes is too large"),
    (lambda: snug.entry(CAR, SLOT, max_changes=-1), snug.Error, "-1"),
    (lambda: snug.entry(CAR, SLOT, strategy="fast"), TypeError, "strategy must be"),
    (lambda: snug.entry(CAR, SLOT, progress=3), TypeError, "progress must be a callable"),
    (lambda: snug.entry(CAR, SLOT, strategy=snug.Stepping(step=0)), snug.Error, "step"),
    (lambda: snug.fewest(CAR, SLOT, roomiest=1), TypeError, "roomiest must be True or False"),
    (lambda: snug.fewest(CAR, SLOT, time_limit=math.nan), snug.Error, "time limit"),
    (lambda: snug.leave(CAR, SLOT, (0, 0, 0)), snug.Error, "car"),
    (lambda: snug.leave(CAR, SLOT, (0, math.nan, 0)), snug.Error, "nan"),
    (lambda: snug.first_contact(CAR, SLOT, (0, math.nan, 0), "forward", 0.1), snug.Error, "nan"),
    (lambda: snug.first_contact(CAR, SLOT, (0, 0, 0), "sideways", 0.1), snug.Error, "direction is 'sideways'"),
    (lambda: snug.Maneuver(CAR, [1]), TypeError, "moves[0] must be a snug.Move"),
    (lambda: snug.Maneuver(CAR, 1), TypeError, "moves must be a sequence"),
    (lambda: MANEUVER.poses(0), snug.Error, "spacing"),
    (lambda: snug.waypoints(MANEUVER, -1), snug.Error, "spacing"),
    (lambda: MANEUVER.poses("1"), TypeError, "spacing must be a number"),
    (lambda: snug.Contact("roof", "curb"), snug.Error, "part is 'roof'"),
    (lambda: snug.drive(CAR, (0, 0, 0), "forward", 0.1, -1), snug.Error, "distance"),
    (lambda: snug.frame(CAR, [1.0, 2.0]), snug.Error, "poses"),
])
def test_errors_name_the_argument(call, error, says):
    with pytest.raises(error) as raised:
        call()
    assert says in str(raised.value)


def public():
    return [(name, getattr(snug, name)) for name in snug.__all__]


def test_everything_public_is_documented_and_found_in_snug():
    for name, thing in public():
        assert thing.__doc__, name
        if inspect.isclass(thing) and thing is not snug.Error:
            for member in vars(thing):
                if not member.startswith("_"):
                    assert inspect.getattr_static(thing, member).__doc__ or getattr(thing, member).__doc__, f"{name}.{member}"
        assert inspect.ismodule(thing) or thing.__module__ == "snug"


def said(answer):
    """All that it says, but for a limit that was given or not."""
    if not hasattr(answer, "to_dict"):
        return str(answer)
    return [getattr(answer, name) for name in answer.__match_args__ if name != "max_changes"]


def test_defaults_are_the_ones_that_help_shows():
    asked = {
        "entry": (CAR, SLOT), "entries": (CAR, [4.5, 4.8], 2.0), "direction_changes": (CAR, SLOT, [0.4, 0.486]),
        "max_steer": (CAR, SLOT, 0.486), "stepping": (CAR, SLOT, 0.486), "reversed_trials": (CAR, SLOT),
        "parallel_trials": (CAR, SLOT), "reversed_trials_by_goal": (CAR, SLOT), "shortfall": (CAR, snug.Slot(3, 1)),
        "min_slot": (CAR,), "min_slots": (CAR, [1]),
        "fewest": (CAR, snug.Slot(5.2, 2.0)), "parked_pose": (CAR, SLOT), "swept": (MANEUVER,), "trajectory": (MANEUVER,),
        "leave": (CAR, snug.Slot(5.2, 2.0), snug.parked_pose(CAR, snug.Slot(5.2, 2.0), front=0.3, curb=0.05)),
        "first_contact": (CAR, SLOT, MOVE.start, "backward", 0.3), "park": (CAR, snug.Street(5.2, 2.0, road=3.5)),
        "drive_runs": (CAR, snug.Street(5.0, 2.5, angle=math.pi / 2, road=6.0)),
        "min_street": (CAR, snug.Street(5.0, 2.5, angle=math.pi / 2)),
    }
    for name, thing in public():
        if inspect.ismodule(thing) or inspect.isclass(thing):
            continue
        defaults = {p.name: p.default for p in inspect.signature(thing).parameters.values() if p.default is not p.empty}
        assert bool(defaults) == (name in asked), name
        if defaults:
            needed = {"min_slot": {"width": 2.0}, "min_slots": {"lengths": [6.0]},
                      "drive_runs": {"margin": 0.05, "runs": 3}}.get(name, {})
            got, plain = thing(*asked[name], **{**defaults, **needed}), thing(*asked[name], **needed)
            assert said(got) == said(plain), name


def test_conditions_are_those_of_the_command():
    conditions = dict(clearance=0.02, curb_clearance=0.05, parked_heading=0.02, parked_curb=0.3)
    slot = snug.Slot(5.2, 2.2, front_setback=0.2, rear_setback=0.1, curb="low")
    answer = snug.entry(CAR, slot, **conditions)
    run = snug.max_steer(CAR, slot, answer.maneuver.entry.heading, **conditions)
    assert run.outcome == "parked" and run.maneuver.direction_changes == answer.direction_changes
    assert abs(answer.maneuver.goal.heading) <= 0.02
    assert snug.entry(CAR, slot).direction_changes <= answer.direction_changes
    assert snug.fewest(CAR, slot, resolution=0.005, **conditions).lower_bound <= answer.direction_changes
    beside = dict(front_setback=0.2, rear_setback=0.1, curb="low", **conditions)
    least = snug.min_slot(CAR, width=2.2, max_changes=answer.direction_changes, **beside)
    assert least.length <= 5.2
    assert snug.min_slot(CAR, width=2.2, max_changes=answer.direction_changes - 1, **beside).length > 5.2
    rows = snug.entries(CAR, [5.2], [2.2], **beside)
    assert rows["direction_changes"][0] == answer.direction_changes
    assert snug.shortfall(CAR, snug.Slot(5, 1), curb_clearance=0.1).width == pytest.approx(CAR.width + 0.1 - 1)
    for strategy in (snug.Stepping(), snug.ReversedTrials(), snug.ParallelTrials()):
        with pytest.raises(snug.Error, match="cannot"):
            snug.entry(CAR, slot, strategy=strategy)


def test_progress_is_told_and_can_give_up():
    told = []
    steps = snug.Stepping(step=1e-4)
    question = dict(strategy=steps, max_changes=40)
    answer = snug.entry(CAR, SLOT, progress=told.append, **question)
    assert answer == snug.entry(CAR, SLOT, **question) and not answer.cancelled
    assert told == sorted(told) and 0.0 <= told[0] and told[-1] <= 1.0
    assert snug.entry(CAR, SLOT, progress=lambda part: False, **question).cancelled

    def fails(part):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        snug.entry(CAR, SLOT, progress=fails, **question)
    states = []
    snug.fewest(CAR, SLOT, progress=states.append, resolution=0.002)
    assert all(isinstance(state, snug.FewestProgress) for state in states)
