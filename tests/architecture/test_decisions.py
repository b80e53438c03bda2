"""Decisions are short: a problem, a choice and a consequence on one page that a stranger can read."""

from pathlib import Path

import pytest

DECISIONS = Path(__file__).resolve().parents[2] / "docs/decisions"
LINES, WIDTH = 40, 118


def faults(text: str) -> list[str]:
    """Faults of the form of a decision."""
    lines = text.splitlines()
    parts = ("Problem", "Choice", "Consequence")
    found = [f"no paragraph **{part}**" for part in parts if not any(one.startswith(f"**{part}") for one in lines)]
    if len(lines) > LINES:
        found.append(f"{len(lines)} lines, at most {LINES}")
    return found + [f"a line of {len(one)} characters: {one[:40]}" for one in lines if len(one) > WIDTH]


def test_decisions_are_short_and_state_problem_choice_and_consequence():
    pages = sorted(DECISIONS.glob("0*.md"))
    found = [f"{page.name}: {fault}" for page in pages for fault in faults(page.read_text(encoding="utf-8"))]
    assert not found, "\n".join(found)


def test_numbers_of_decisions_are_used_once():
    pages = sorted(page.name for page in DECISIONS.rglob("0*.md"))
    numbers = [name[:4] for name in pages if name not in {"0008-numba.md"}]  # the archived half of 0008
    assert len(numbers) == len(set(numbers)), pages


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("**Problem.** A.\n\n**Choice.** B.\n\n**Consequence** (C).", 0), ("**Problem.** A.\n**Choice.** B.", 1),
        ("**Problem.**\n**Choice.**\n**Consequence.**" + "\n" * 38 + "a", 1),
        ("**Problem.**\n**Choice.**\n**Consequence.** " + "a" * 110, 1),
    ],
)  # fmt: skip
def test_faults_of_a_decision_are_found(text: str, count: int):
    assert len(faults(text)) == count
