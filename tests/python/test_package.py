"""The package as people get it: stubs, the wheel, without matplotlib, pictures, examples."""
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import snug

INSTALL = """\
/usr/bin/python3 -m venv --system-site-packages venv
venv/bin/python -m pip install --no-index --no-deps build/python/snug-*.whl
"""
ROOT = Path(__file__).resolve().parents[2]
CAR = snug.find_car("renault-zoe")
SLOT = snug.Slot(5.2, 2.0)


def run(*arguments, **options):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_types_are_those_of_the_module(tmp_path):
    home = str(Path(snug.__file__).parents[1])
    for check in (["mypy.stubtest", "snug._snug", "--mypy-config-file"], ["mypy", "-p", "snug", "--config-file"]):
        run(sys.executable, "-m", *check, ROOT / "bindings/python/pyproject.toml", cwd=tmp_path,
            env={**os.environ, "MYPYPATH": home, "MYPY_CACHE_DIR": str(tmp_path)})


def test_the_wheel_installs_without_network_and_runs(tmp_path):
    run("/usr/bin/python3", "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation", "-w",
        tmp_path / "build/python", ROOT / "bindings/python")
    (wheel,) = tmp_path.glob("build/python/snug-*.whl")
    assert snug.__version__ in wheel.name
    run("sh", "-ec", INSTALL, cwd=tmp_path)
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    out = run(tmp_path / "venv/bin/python", "-c", "import snug; print(snug.__file__); "
              "print(snug.entry(snug.find_car('renault-zoe'), snug.Slot(4.5, 2.0)).direction_changes)", env=clean, cwd=tmp_path)
    where, changes = out.split()
    assert str(tmp_path / "venv") in where and changes == "18"


def test_without_matplotlib_all_works_but_pictures(tmp_path):
    (tmp_path / "matplotlib.py").write_text("raise ImportError('not installed')\n")
    out = run(sys.executable, "-c", "import snug; car, slot = snug.cars()[1], snug.Slot(5.2, 2.0)\n"
              "answer = snug.entry(car, slot)\n"
              "try: snug.plot.maneuver(answer.maneuver, slot)\n"
              "except ImportError as error: print(error)",
              env={**os.environ, "PYTHONPATH": f"{tmp_path}:{Path(snug.__file__).parents[1]}"})
    assert "snug.plot needs matplotlib" in out


def test_importing_does_not_import_matplotlib():
    assert run(sys.executable, "-c", "import sys, snug; print('matplotlib' in sys.modules)") == "False\n"


@pytest.fixture
def pyplot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield pyplot
    pyplot.close("all")


@pytest.mark.parametrize("side", ["right", "left"])
def test_pictures_are_to_scale_on_the_axes_given(pyplot, side):
    slot = snug.Slot(4.6, 2.0, side=side, corner=(3, 1), heading=0.4)
    answer = snug.entry(CAR, slot, max_changes=12)
    figure, axes = pyplot.subplots(2, 2)
    assert snug.plot.maneuver(answer.maneuver, slot, axes[0, 0]) is axes[0, 0]
    assert snug.plot.entries(CAR, slot, answer, axes[0, 1]) is axes[0, 1]
    assert snug.plot.ranges(answer, axes[1, 0]) is axes[1, 0]
    widths, counts = np.linspace(1.9, 2.2, 5), [1, 2]
    assert snug.plot.min_slots(widths, counts, snug.min_slots(CAR, counts, widths=widths), axes[1, 1]) is axes[1, 1]
    assert axes[0, 0].get_aspect() == axes[0, 1].get_aspect() == 1.0
    figure.canvas.draw()


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize("curb", ["high", "low"])
def test_pictures_of_rounded_cars_show_outlines_and_where_they_touch(pyplot, side, curb):
    car = snug.Car(width=1.771, length=4.084, front_overhang=0.839, wheelbase=2.588, curb_to_curb=10.56, corner_radius=0.3)
    slot = snug.Slot(4.9, 2.0, side=side, corner=(3, 1), heading=0.4, front_setback=0.1, rear_setback=0.2, curb=curb)
    maneuver = snug.entry(car, slot).maneuver
    ax = snug.plot.maneuver(maneuver, slot, swept=False)
    ax.figure.canvas.draw()
    edges = [path.vertices for collection in ax.collections for path in collection.get_paths()]
    assert edges and all(len(edge) == len(car.outline) + 1 for edge in edges)
    along_slot = np.array([-1, 1]) if side == "left" else np.array([1, 1])  # seen from the road
    for pose in (maneuver.entry, maneuver.goal):
        along, across = np.transpose(car.outline)
        world = np.transpose([pose.x + np.cos(pose.heading) * along - np.sin(pose.heading) * across,
                              pose.y + np.sin(pose.heading) * along + np.cos(pose.heading) * across])
        at = along_slot * [tuple(slot.to_slot(snug.Point(*point))) for point in world]
        assert min(np.abs(edge[:-1] - at).max() for edge in edges) < 1e-9
    contacts = [move.contact for move in maneuver.moves if move.contact]
    (shown,) = [line.get_xydata() for line in ax.lines if line.get_marker() == "D"]
    assert len(shown) == len(contacts) > 0
    for contact, (x, y) in zip(contacts, shown * along_slot):
        met = {"curb": (y, -2.0), "front side": (x, 0.0), "rear side": (x, -4.9)}
        if contact.obstacle in met:
            assert met[contact.obstacle][0] == pytest.approx(met[contact.obstacle][1], abs=1e-6), contact


def test_pictures_of_little(pyplot):
    nothing = snug.entry(CAR, snug.Slot(4.0, 2.0))
    snug.plot.entries(CAR, snug.Slot(4.0, 2.0), nothing)
    snug.plot.ranges(nothing)
    snug.plot.min_slots([1.0, 1.5], 2, snug.min_slots(CAR, 2, widths=[1.0, 1.5]))
    snug.plot.min_slots(2.0, 2, snug.min_slots(CAR, 2, widths=2.0))
    snug.plot.min_slots([5.0, 5.5], [2], snug.min_slots(CAR, [2], lengths=[5.0, 5.5])).figure.canvas.draw()
    bounds = snug.min_slots(CAR, [1], widths=[2.1, 2.3], strategy="fewest", precision=0.05, resolution=0.02)
    snug.plot.min_slots([2.1, 2.3], [1], bounds).figure.canvas.draw()
    maneuver = snug.fewest(CAR, snug.Slot(5.2, 1.9), resolution=0.004).maneuver
    snug.plot.maneuver(maneuver, snug.Slot(5.2, 1.9), swept=False, legend=False).figure.canvas.draw()


@pytest.mark.parametrize("call, error, says", [
    (lambda: snug.plot.maneuver(None, SLOT), TypeError, "maneuver must be a snug.Maneuver"),
    (lambda: snug.plot.maneuver(snug.Maneuver(CAR, []), SLOT), snug.Error, "no moves"),
    (lambda: snug.plot.maneuver(snug.entry(CAR, SLOT).maneuver, CAR), TypeError, "slot must be a snug.Slot"),
    (lambda: snug.plot.ranges(SLOT), TypeError, "answer must be a snug.Answer"),
    (lambda: snug.plot.min_slots([2.0], [1], [3.0]), TypeError, "slots must be"),
    (lambda: snug.plot.min_slots([2.0, 2.1], [1], snug.min_slots(CAR, [1], widths=[2.0])), snug.Error, "slots has the shape"),
])
def test_pictures_name_the_argument(pyplot, call, error, says):
    with pytest.raises(error) as raised:
        call()
    assert says in str(raised.value)


def test_what_has_no_constructor_and_classes_of_ones_own():
    with pytest.raises(TypeError):
        snug.Box()
    with pytest.raises(TypeError):
        type("MyCar", (snug.Car,), {})


@pytest.mark.parametrize("example", sorted((ROOT / "examples").glob("*.py")), ids=lambda path: path.stem)
def test_examples_print_what_the_comment_at_their_end_says(example, tmp_path):
    out = run(sys.executable, example, cwd=tmp_path, env={**os.environ, "MPLBACKEND": "Agg"})
    shown = example.read_text().split("# Prints:\n")[1]
    assert out == "".join(line[2:] for line in shown.splitlines(keepends=True))


@pytest.mark.parametrize("page", [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))], ids=lambda path: path.name)
def test_python_in_the_docs_runs(page, pyplot):
    blocks = [block.split("\n```")[0] for block in page.read_text().split("```python\n")[1:]]
    exec(compile("\n".join(blocks), page.name, "exec"), {})
