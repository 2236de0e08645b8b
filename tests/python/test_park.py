"""Parking from any pose: the command's numbers, scenes, and the map."""
import copy
import json
import os
import pickle
import subprocess

import numpy as np
import pytest
import snug

COMMAND = os.environ["SNUG_COMMAND"]
CAR = snug.find_car("renault-zoe")
STREET = snug.Street(5.2, 2.0, road=3.5)
NONE = 2**31 - 1
SCENE = {"obstacles": [[[0, 0], [5, 0], [5, 2], [0, 2]], [[11, 0], [16, 0], [16, 2], [11, 2]]],
         "parked": {"inside": [[5, 0], [11, 0], [11, 2], [5, 2]], "heading": 0, "heading_tolerance": 0.5},
         "start": [12, 4, 0]}


def command(*arguments):
    run = subprocess.run([COMMAND, "park", "--car", CAR.name, *map(str, arguments), "--format", "json"], capture_output=True, text=True)
    assert run.returncode in (0, 1), run.stderr
    return json.loads(run.stdout)


@pytest.mark.parametrize("start", [None, (2.0, 1.75, 0.0), (1.0, 1.5, 0.2)])
def test_streets_are_answered_as_by_the_command(start):
    said = command("--length", 5.2, "--width", 2, "--road", 3.5, *(["--from", ",".join(map(str, start))] if start else []))
    answer = snug.park(CAR, STREET, start)
    assert (answer.direction_changes, answer.lower_bound, answer.proved) == tuple(
        said[key] for key in ("direction_changes", "lower_bound", "proved"))
    assert [move.length for move in answer.maneuver.moves] == [move["length"] for move in said["maneuver"]["moves"]]
    assert answer.parkable and not answer.impossible and not answer.cancelled
    first = answer.maneuver.entry
    assert (first.x, first.y, first.heading) == tuple(start or snug.standard_start(STREET, CAR))


def test_scenes_are_files_and_dictionaries(tmp_path):
    (tmp_path / "yard.json").write_text(json.dumps(SCENE))
    scene = snug.Scene.from_dict(SCENE)
    assert snug.read_scene(tmp_path / "yard.json") == scene == snug.Scene(json.dumps(SCENE)) == pickle.loads(pickle.dumps(scene))
    assert scene.start == snug.Pose(12, 4, 0)
    said = command("--scene", tmp_path / "yard.json")
    assert snug.park(CAR, scene).direction_changes == said["direction_changes"]
    assert snug.park(CAR, snug.Street(5, 2.1, angle=np.pi / 2, road=3, enter="forward")).impossible
    with pytest.raises(snug.Error, match="parked"):
        snug.Scene.from_dict({"obstacles": []})
    with pytest.raises(TypeError, match="place must be a snug.Street or a snug.Scene, not .*Slot"):
        snug.park(CAR, snug.Slot(5, 2))


def test_the_map_of_one_pose_and_of_many():
    of = snug.ParkMap(CAR, STREET)
    assert of.place == STREET and of.spacing == 0.08 and of.nbytes > 1e6
    assert snug.ParkMap(CAR, snug.Scene.from_dict(SCENE)).at((12, 4, 0)).where == "free"
    x, y = np.meshgrid(np.linspace(-6, 6, 60), np.linspace(-1, 3, 20))
    poses = np.stack([x, y, np.full_like(x, 0.1)], axis=-1)
    lower, upper = of.counts(poses)
    assert lower.shape == upper.shape == (20, 60) and ((lower <= upper) | (lower < 0)).all()
    assert {-2, 1} <= set(lower.ravel()) and of.counts(poses[0, 0])[0].shape == ()
    assert (of.counts(poses + [0, 0, 2])[0] == -1).all()
    rng, known = np.random.default_rng(7), np.argwhere((upper != NONE) & (lower >= 0))
    for i, j in rng.choice(known, 25):
        pose = tuple(poses[i, j])
        bounds = of.at(pose)
        assert (bounds.where, bounds.lower_bound, bounds.direction_changes) == ("free", lower[i, j], upper[i, j])
        assert bounds.proved == (lower[i, j] == upper[i, j]) and not bounds.impossible
        maneuver = of.maneuver(pose)
        if bounds.first is None:
            assert maneuver is None and bounds.direction_changes == 0
            continue
        assert maneuver.direction_changes <= bounds.direction_changes and maneuver.moves[0].direction == bounds.first
        assert (maneuver.entry.x, maneuver.entry.y) == pose[:2]
    answer = snug.park(CAR, STREET, (2, 1.75, 0))
    assert of.at((2, 1.75, 0)).lower_bound <= answer.direction_changes <= of.at((2, 1.75, 0)).direction_changes


def test_maps_are_values():
    of = snug.ParkMap(CAR, STREET, max_changes=2)
    for twin in (copy.deepcopy(of), pickle.loads(pickle.dumps(of))):
        assert twin == of and twin.fingerprint == of.fingerprint and twin.at((2, 1.75, 0)) == of.at((2, 1.75, 0))
    assert snug.ParkMap(CAR, snug.Street(5.3, 2.0, road=3.5), max_changes=2).fingerprint != of.fingerprint
    with pytest.raises(snug.Error, match="spacing"):
        snug.ParkMap(CAR, STREET, spacing=1.0)
    with pytest.raises(snug.Error, match="last axis must hold"):
        of.counts([1.0, 2.0])
