"""Answers are values: they compare, pickle, convert to the command's JSON, and show themselves."""
import copy
import inspect
import json
import os
import pickle
import subprocess
import xml.etree.ElementTree as xml

import numpy as np
import pytest
import snug

COMMAND = os.environ["SNUG_COMMAND"]
ZOE = snug.find_car("renault-zoe")
SLOT = snug.Slot(4.5, 2.0)
ROUND = snug.Car(wheelbase=2.588, width=1.771, length=4.084, front_overhang=0.839, curb_to_curb=10.56, corner_radius=0.3)
STREET = snug.Street(5.2, 2.0, road=3.5)
YARD = snug.Scene.from_dict({
    "obstacles": [[[0, 0], [5, 0], [5, 2], [0, 2]], [[11, 0], [16, 0], [16, 2], [11, 2]]],
    "parked": {"inside": [[5, 0], [11, 0], [11, 2], [5, 2]], "heading": 0, "heading_tolerance": 0.5}, "start": [12, 4, 0]})
BUS = dict(width=2.55, front=9.3, rear=2.7, wheelbase=6.0, max_steer=np.radians(50))


def command(*arguments):
    run = subprocess.run([COMMAND, *map(str, arguments), "--format", "json"], capture_output=True, text=True)
    assert run.returncode in (0, 1, 3), run.stderr
    return run.stdout


BAY = snug.Street(5.0, 2.5, angle=np.pi / 2, road=5.5)
PARKED = snug.parked_pose(ZOE, snug.Slot(5, 2), front=0.3, curb=0.05)
ASKED = {
    "entry": snug.entry(ZOE, SLOT), "no entry": snug.entry(ZOE, snug.Slot(4.0, 2.0)), "outline": snug.entry(ROUND, SLOT),
    "conditions": snug.entry(ZOE, snug.Slot(5.2, 2.2, side="left", curb="low"), clearance=0.02, curb_clearance=0.05,
                             parked_heading=np.radians(1.0), max_changes=9),
    "trials": snug.entry(ZOE, snug.Slot(5.5, 2.2), strategy=snug.ReversedTrials()),
    "fewest": snug.fewest(ZOE, snug.Slot(5.2, 1.9), resolution=0.004),
    "leave": snug.leave(ZOE, snug.Slot(5, 2), PARKED, resolution=0.004),
    "min-slot": snug.min_slot(ZOE, width=2.0, max_changes=3),
    "kept": snug.min_slot(ZOE, length=5.2, max_changes=4, clearance=0.03, front_setback=0.1, curb="low", parked_curb=0.3),
    "least": snug.min_slot(ZOE, width=2.0, max_changes=1, strategy="fewest", resolution=0.02),
    "road": snug.min_street(ZOE, BAY, max_changes=1, resolution=0.05), "least bay": snug.min_street(ZOE, BAY, sought="width", resolution=0.05),
    "run": snug.max_steer(ZOE, SLOT, 0.486), "park": snug.park(ZOE, STREET), "yard": snug.park(ZOE, YARD),
    "contact": snug.first_contact(ZOE, SLOT, (0, 0.5, 0.2), "backward", 0.3), "free": snug.first_contact(ZOE, SLOT, (0, 50, 0), "forward", 0),
    "shortfall": snug.shortfall(ZOE, snug.Slot(3, 2)), "goals": snug.reversed_trials_by_goal(ZOE, snug.Slot(5.5, 2.2)),
    "bounds": snug.ParkMap(ZOE, STREET, max_changes=2).at((2, 1.75, 0)),
}
ASKED |= {"box": snug.swept(ASKED["entry"].maneuver), "range": ASKED["entry"].ranges[0], "stop": ASKED["park"].stops[0],
          "inside": ASKED["contact"].inside or snug.first_contact(ZOE, snug.Slot(9, 3), (-5, -1.5, 0), "backward", 0).inside}


@pytest.mark.parametrize("name", ASKED)
def test_answers_are_values(name):
    answer = ASKED[name]
    for twin in (copy.deepcopy(answer), pickle.loads(pickle.dumps(answer))):
        assert twin == answer and hash(twin) == hash(answer) and repr(twin) == repr(answer)
        assert twin.to_json() == answer.to_json()
    assert answer.to_dict() == json.loads(answer.to_json())
    assert answer != ASKED["entry" if name != "entry" else "fewest"]
    assert len(repr(answer)) < 250, repr(answer)


@pytest.mark.parametrize("name, arguments", [
    ("entry", "entry --car renault-zoe --length 4.5 --width 2"), ("no entry", "entry --car renault-zoe --length 4 --width 2"),
    ("conditions", "entry --car renault-zoe --length 5.2 --width 2.2 --side left --curb low --clearance 0.02 "
                   "--curb-clearance 0.05 --parked-heading 1 --max-changes 9"),
    ("trials", "entry --car renault-zoe --length 5.5 --width 2.2 --strategy reversed-trials"),
    ("fewest", "entry --car renault-zoe --length 5.2 --width 1.9 --strategy fewest --resolution 0.004"),
    ("leave", "leave --car renault-zoe --length 5 --width 2 --gap-front 0.3 --gap-curb 0.05 --resolution 0.004"),
    ("min-slot", "min-slot --car renault-zoe --width 2 --max-changes 3"),
    ("least", "min-slot --car renault-zoe --width 2 --max-changes 1 --strategy fewest --resolution 0.02"),
    ("road", "min-slot --car renault-zoe --angle 90 --length 5 --width 2.5 --max-changes 1 --resolution 0.05"),
    ("least bay", "min-slot --car renault-zoe --angle 90 --length 5 --road 5.5 --max-changes 0 --resolution 0.05"),
    ("park", "park --car renault-zoe --length 5.2 --width 2 --road 3.5"),
])
def test_json_is_the_commands(name, arguments):
    assert ASKED[name].to_json() == command(*arguments.split())


def test_json_is_the_commands_for_files(tmp_path):
    (tmp_path / "car.json").write_text(ROUND.to_json())
    (tmp_path / "yard.json").write_text(YARD.json)
    assert ASKED["outline"].to_json() == command("entry", "--car", tmp_path / "car.json", "--length", 4.5, "--width", 2)
    assert ASKED["yard"].to_json() == command("park", "--car", "renault-zoe", "--scene", tmp_path / "yard.json")
    assert snug.read_car(tmp_path / "car.json") == ROUND == snug.Car.from_dict(ASKED["outline"].to_dict()["car"])


def test_how_far_off_the_start_may_be():
    off = ASKED["entry"].start_tolerance
    assert off.direction_changes == 18 and off.heading == pytest.approx(ASKED["entry"].maneuver.entry.heading)
    assert 0 < off.both_along < off.along < 0.01 and 0 < off.both_out < off.out < 0.01
    assert ASKED["entry"].to_dict()["start_tolerance"]["both"] == {"along": off.both_along, "out": off.both_out}
    assert all(ASKED[name].start_tolerance is None for name in ("no entry", "trials", "fewest", "leave"))


def test_any_maneuver_where_the_strategy_cannot_park(tmp_path):
    bus = snug.Car(**BUS)
    answer = snug.entry(bus, snug.Slot(15, 3))
    assert not answer.parkable and answer.any_maneuver.direction_changes == 0 and answer.any_maneuver.proved
    (tmp_path / "bus.json").write_text(bus.to_json())
    assert answer.to_json() == command("entry", "--car", tmp_path / "bus.json", "--length", 15, "--width", 3)
    assert answer.to_dict()["any_maneuver"]["direction_changes"] == 0
    other = answer.any_maneuver
    assert other == answer.any_maneuver and other.strategy == "fewest" and other.maneuver.goal
    assert ASKED["entry"].any_maneuver is None and ASKED["fewest"].any_maneuver is None and other.any_maneuver is None
    assert pickle.loads(pickle.dumps(answer)).any_maneuver == other


@pytest.mark.parametrize("name", ["entry", "no entry", "outline", "conditions", "fewest", "leave", "run", "park", "yard", "min-slot", "least",
                                  "road", "least bay", "kept"])
def test_notebooks_show_pictures(name):
    assert xml.fromstring(ASKED[name]._repr_svg_()).tag.endswith("svg")


def test_maneuvers_show_themselves_alone_and_numbers_as_a_table():
    maneuver = ASKED["entry"].maneuver
    picture = maneuver._repr_svg_()
    assert xml.fromstring(picture).tag.endswith("svg") and "18 direction changes" in picture
    assert xml.fromstring(snug.entry(ROUND, SLOT).maneuver._repr_svg_()).tag.endswith("svg")
    assert snug.Maneuver(ZOE, [])._repr_svg_() is None
    for name in ("contact", "free", "shortfall", "goals", "bounds"):
        cells = [(row[0].text, row[1].text) for row in xml.fromstring(ASKED[name]._repr_html_())]
        assert cells == [(field, str(getattr(ASKED[name], field))) for field in ASKED[name].__match_args__]


def test_maps_show_themselves_and_what_is_undecided_does_not():
    for place in (STREET, YARD):
        assert xml.fromstring(snug.ParkMap(ZOE, place, max_changes=2)._repr_svg_()).tag.endswith("svg")
    stopped = snug.entry(ZOE, SLOT, strategy=snug.Stepping(step=1e-4), max_changes=40, progress=lambda part: False)
    assert snug.min_slot(ZOE, width=1.5)._repr_svg_() is None
    assert stopped.cancelled and stopped._repr_svg_() is None and "undecided" in repr(stopped)


def test_poses_are_three_numbers():
    pose = snug.Pose(1, 2, 0.5)
    assert np.asarray(pose).tolist() == [1, 2, 0.5] and np.asarray(pose, dtype=np.float32).dtype == np.float32
    assert np.asarray(snug.Point(1, 2)).tolist() == [1, 2]
    maneuver = ASKED["entry"].maneuver
    ends = [move.end for move in maneuver.moves]
    assert np.array(ends).shape == (len(ends), 3)
    assert (snug.frame(ZOE, ends)[-1] == snug.frame(ZOE, maneuver.goal)).all()
    lower, upper = snug.ParkMap(ZOE, STREET, max_changes=2).counts([pose, snug.Pose(2, 1.75, 0)])
    assert lower.shape == upper.shape == (2,)


def test_short_and_readable():
    assert repr(ASKED["entry"]) == "<Answer: renault-zoe in 4.5 x 2.0 m, 18 direction changes, proved>"
    assert repr(ASKED["no entry"]).startswith("<Answer: renault-zoe in 4.0 x 2.0 m, cannot park")
    assert repr(SLOT) == "Slot(length=4.5, width=2.0)" and repr(snug.Pose(1, 2)) == "Pose(x=1.0, y=2.0)"
    assert repr(snug.Slot(5, 2, corner=(1, 0), curb="low")) == "Slot(length=5.0, width=2.0, corner=Point(x=1.0), curb='low')"


def test_help_shows_types():
    assert snug.entry.__doc__.startswith("entry(car: Car, slot: Slot, *, max_changes: int | None = None")
    assert snug.entry.__doc__.split("\n")[0].endswith("-> Answer")
    assert snug.Slot.side.__doc__ == "Literal['right', 'left']: 'right' or 'left' of the road"
    for name in snug.__all__[1:]:
        thing = getattr(snug, name)
        assert inspect.isclass(thing) or "->" in thing.__doc__.split("\n")[0], name


def test_cars_as_data_sheets_say(tmp_path):
    sheet = dict(width=1.771, length=4.084, front_overhang=0.839, wheelbase=2.588)
    for steering in ({"max_steer_deg": 33}, {"turning_radius": 4.0}, {"curb_to_curb": 10.56}, {"wall_to_wall": 11.2}):
        car = snug.Car(**sheet, **steering)
        assert car == snug.Car.from_dict(sheet | steering) and car.rear == pytest.approx(0.657)
        (key, value), = steering.items()
        assert (np.degrees(car.max_steer) if key == "max_steer_deg" else getattr(car, key)) == pytest.approx(value)
        assert pickle.loads(pickle.dumps(car)) == car == eval(repr(car), vars(snug))
    assert ROUND.outline and snug.Car(**sheet, curb_to_curb=10.56, corner_radius=(0.3, 0.3)) == ROUND
    assert snug.Car.from_dict(ROUND.to_dict()) == ROUND and snug.Car.from_dict(ASKED["entry"].to_dict()["car"]) == ZOE
    (tmp_path / "fleet.csv").write_text("name,width,front,rear,wheelbase,curb_to_curb\na,1.7,3.4,0.6,2.5,10.5\nb,1.8,3.5,0.7,2.6,11\n")
    assert [car.name for car in snug.read_cars(tmp_path / "fleet.csv")] == ["a", "b"]


@pytest.mark.parametrize("keys, says", [
    (dict(width=1771), "width is 1771 m, but must lie between 0.001 and 10 m; 1771 looks like millimetres"),
    (dict(rear_overhang=0.9), "length is 4.084, which does not agree with front and rear"),
    (dict(curb_to_curb=None), "car says nothing about the steering; give one of"),
    (dict(width=None), "width is missing; give it in metres"),
    (dict(turning_radius=7.0), "curb_to_curb is 10.56, which does not agree with turning_radius"),
    (dict(outline=[(3, 1), (-1, 1), (-1, -1), (3, -1)], corner_radius=0.1), "corner_radius rounds a rectangle"),
    (dict(max_steer_deg=2, curb_to_curb=None), "max_steer_deg is 2 degrees, but must lie between"),
])
def test_sheets_that_describe_no_car(keys, says):
    sheet = dict(width=1.771, length=4.084, front_overhang=0.839, wheelbase=2.588, curb_to_curb=10.56) | keys
    with pytest.raises(snug.Error) as raised:
        snug.Car(**sheet)
    assert says in str(raised.value)


@pytest.mark.parametrize("strategy", ["max-steer", "fewest"])
def test_an_atlas_is_open_for_looking_up(tmp_path, strategy):
    run = lambda *arguments: subprocess.run([COMMAND, "atlas", *arguments], check=True, capture_output=True, cwd=tmp_path)
    run("build", "--db", "a.sqlite", "--cars", "renault-zoe,mid-size", "--length", "4.5:5.5:0.5", "--width", "1.9:2.1:0.1",
        "--strategy", strategy, *(["--resolution", "0.01"] if strategy == "fewest" else []))
    run("export", "--db", "a.sqlite", "--output", "a.atlas")
    atlas = snug.Atlas(tmp_path / "a.atlas")
    assert pickle.loads(pickle.dumps(atlas)) == atlas and atlas.strategy == strategy
    assert [car.name for car in atlas.cars] == ["mid-size", "renault-zoe"] and atlas.lengths.tolist() == [4.5, 5.0, 5.5]
    lengths, widths = np.array([4.5, 4.9, 5.2, 7.0])[:, None], np.array([1.9, 2.05, 3.0])
    rows = atlas.look_ups(ZOE, lengths, widths)
    assert rows.shape == (4, 3)
    for i, length in enumerate(lengths[:, 0]):
        for j, width in enumerate(widths):
            answer, row = atlas.look_up("renault-zoe", snug.Slot(length, width)), rows[i, j]
            assert answer == atlas.look_up(ZOE, snug.Slot(length, width)) == pickle.loads(pickle.dumps(answer))
            assert answer.to_json() == command("atlas", "query", "--db", tmp_path / "a.atlas", "--car", "renault-zoe",
                                               "--length", length, "--width", width)
            assert (row["length"], row["width"]) == answer.cell and row["lower_bound"] == answer.lower_bound
            assert row["direction_changes"] == (-1 if answer.direction_changes is None else answer.direction_changes)
            assert row["decided"] != answer.cancelled
    assert (rows["direction_changes"] >= 0).any()
    for call, says in ((lambda: atlas.look_up(ZOE, snug.Slot(4.0, 2.0)), "length is 4.0 m, but the atlas has lengths from 4.5 to 5.5 m"),
                       (lambda: atlas.look_up("beetle", SLOT), "car is 'beetle', but the atlas has mid-size, renault-zoe"),
                       (lambda: snug.Atlas(tmp_path / "none.atlas"), "none.atlas")):
        with pytest.raises(snug.Error) as raised:
            call()
        assert says in str(raised.value)


def test_what_is_undecided_has_ends_as_ranges_have():
    """A single heading, as good as: 8e-13 rad wide (ProvedEntry.ListsWhatIsTooNarrowToClaim)."""
    car = snug.Car(width=1.370913965386644, front=3.594917688255497, rear=1.0983338683615604, wheelbase=3.235742146367956,
                   max_steer=0.8112025073762099)
    answer = snug.entry(car, snug.Slot(5.491881517462855, 1.5548834607640432), max_changes=14)
    (sliver,) = answer.undecided
    low, high = sliver
    assert (low, high) == (sliver.min, sliver.max) == (sliver[0], sliver[-1]) and len(sliver) == 2 and low < high < low + 5e-12
    assert sliver.to_dict() == answer.to_dict()["undecided"][0] == {"heading_min": low, "heading_max": high}
    assert repr(sliver) == f"Headings(min={low!r}, max={high!r})"
    assert pickle.loads(pickle.dumps(sliver)) == sliver and hash(sliver) == hash(copy.deepcopy(sliver))
    assert pickle.loads(pickle.dumps(answer)) == answer
