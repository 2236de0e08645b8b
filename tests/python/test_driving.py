"""From a plan to a drive: the same as the command, as values."""
import os
import pickle
import subprocess

import numpy as np
import pytest
import snug

COMMAND = os.environ["SNUG_COMMAND"]
CAR = snug.find_car("renault-zoe")
BAY = snug.Street(5.0, 2.5, angle=np.pi / 2, road=6.0)
BAY_ARGUMENTS = "--car renault-zoe --length 5 --width 2.5 --angle 90 --road 6".split()


def command(*arguments):
    return subprocess.run([COMMAND, *arguments, "--format", "json"], capture_output=True, text=True).stdout


def test_runs_are_those_of_the_command():
    answer = snug.drive_runs(CAR, BAY, margin=0.05, runs=5, slot_error=(0.02, 0.01))
    said = command("drive", *BAY_ARGUMENTS, "--margin", "0.05", "--runs", "5", "--slot-error", "0.02,0.01")
    assert answer.to_json() == said and answer.to_dict()["runs"] == 5
    assert pickle.loads(pickle.dumps(answer)) == answer and "<svg" in answer._repr_svg_()
    assert answer.parked == sum(run.parked for run in answer.runs) and len(answer.runs[0].track) > 10
    assert not snug.drive_runs(CAR, snug.Street(4.2, 1.8), runs=2).plannable
    with pytest.raises(snug.Error, match="rate"):
        snug.drive_runs(CAR, BAY, rate=2)


def test_the_assistant_leads_into_the_bay():
    assistant = snug.Assistant(CAR, BAY, margin=0.05)
    pose, driven = snug.standard_start(BAY, CAR), None
    for _ in range(10):
        told = assistant.next(pose, driven)
        if told.what == "parked":
            break
        assert told.what in ("move", "escape") and told.moves[0].start == pose
        pose, driven = told.moves[-1].end, told.moves[-1].direction
    assert told.what == "parked"
    assert pickle.loads(pickle.dumps(assistant)).next(pose) == told and assistant.plan(pose) is None
    assert assistant.next((100, 0, 0)).what == "stuck"


def test_steering_only_while_rolling():
    answer = snug.park(CAR, BAY, steer="moving")
    assert answer.to_json() == command("park", *BAY_ARGUMENTS, "--steer", "moving")
    assert pickle.loads(pickle.dumps(answer)) == answer and answer.parkable
    way = answer.maneuver
    for before, after in zip(way.pieces, way.pieces[1:]):
        assert tuple(before.at(before.length)) == pytest.approx(tuple(after.start), abs=1e-9)
        assert before.curvature + before.sharpness * before.length == pytest.approx(after.curvature, abs=1e-9)
    points = snug.trajectory(way, period=0.01)
    assert abs(points["steering_rate"]).max() <= 0.5 + 1e-9
    assert points["x"][-1] == way.pieces[-1].end.x
    assert way.in_arcs().direction_changes == way.direction_changes
