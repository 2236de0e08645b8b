"""Are the tables of README.md and docs/results.md what the solver says?"""

import json
import os
import pathlib
import re
import subprocess

import pytest

import snug

root = pathlib.Path(__file__).parents[2]
readme = (root / "README.md").read_text()
results = (root / "docs/results.md").read_text()


def table(text, heading):
    """The rows of the table whose first line begins with the heading, cells without emphasis."""
    lines = text[text.index(heading) :].split("\n\n")[0].splitlines()
    return [[cell.strip().replace("**", "") for cell in line.strip("|").split("|")] for line in lines[2:]]


counts = table(results, "| car and slot |")
names = {"mid-sized vehicle": "mid-size", "Renault ZOE": "renault-zoe"}


def test_readme_and_results_show_the_same_counts():
    assert table(readme, "| car and slot |") == counts


@pytest.mark.parametrize("row", counts, ids=[row[0] for row in counts])
def test_counts(row):
    name, length, width = re.fullmatch(r"(.*), ([\d.]+) x ([\d.]+) m", row[0]).groups()
    car, slot = snug.find_car(names[name]), snug.Slot(length=float(length), width=float(width))
    for cell, answer in [(row[2], snug.entry(car, slot, strategy=snug.Stepping())), (row[3], snug.entry(car, slot))]:
        assert cell == ("cannot park" if answer.direction_changes is None else str(answer.direction_changes))
    if row[4]:
        low, high = (float(end) for end in row[4].split(" to "))
        ranges = answer.ranges
        assert abs(ranges[0].min - low) < 1e-5 and abs(ranges[-1].max - high) < 1e-5
    fewest = snug.fewest(car, slot)
    assert row[5] == f"{fewest.direction_changes}, proved" and fewest.proved


def test_claims_of_the_paper(tmp_path):
    subprocess.run([os.environ["SNUG_COMMAND"], "paper", "--out", tmp_path], check=True, capture_output=True)
    claims = json.loads((tmp_path / "claims.json").read_text())["claims"]
    holding = sum(claim["agrees"] for claim in claims)
    for text in (readme, results, (root / "docs/paper.md").read_text()):
        assert f"f {len(claims)} claims" in text.replace("\nclaims", " claims")
        assert re.search(rf"claims(\s+of\s+the\s+paper)?\s+{holding}\s+hold exactly", text)
