"""What is being compiled, in the words of the field, how far it is and how long it will still take: one line."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox._compiling import Work, under_way

_WORDS = {
    "sandbox.engine.step.collide": "collision detection",
    "sandbox.engine.step.begin": "substep levels",
    "sandbox.engine.step.solve": "solver",
    "sandbox.engine.step.finish": "sleep",
    "sandbox.engine.run_steps.": "step",
    "sandbox.engine.continuous_collision.": "continuous collision",
    "sandbox.engine.joints.": "joints",
    "sandbox.engine.restitution.": "impacts",
    "sandbox.engine.fields.": "fields",
    "sandbox.engine.workers.": "workers",
    "sandbox.engine.events.": "sensors",
    "sandbox.engine.queries.": "queries",
    "sandbox.geometry.": "separating-axis test",
    "sandbox.reference.": "comparison",
}
"""By how the names of entry points begin."""


def compile_status() -> str | None:
    """`solver, collision detection: 43 %, about 6 s left`, or None if nothing is being compiled.

    The percentage is a share of the time. It and the seconds are left out until they are known.
    """
    works = under_way()
    if not works:
        return None
    left = seconds_left(works)
    if left is None:
        return parts(works)
    spent = max(work.spent for work in works)
    return f"{parts(works)}: {100 * spent / (spent + left):.0f} %, about {left:.0f} s left"


def parts(works: Sequence[Work]) -> str:
    """What they are, each kind once."""
    return ", ".join(dict.fromkeys(_words(work.name) for work in works))


def seconds_left(works: Sequence[Work]) -> float | None:
    """How long until the last of them is done: they go on side by side. None if it is not known yet of all."""
    left = 0.0
    for work in works:
        seconds = work.seconds
        if seconds is None:
            return None
        left = max(left, seconds - work.spent, 0.5)
    return left


def _words(name: str) -> str:
    found = (words for begin, words in _WORDS.items() if name.startswith(begin))
    return next(found, name.rpartition(".")[2].replace("_", " "))
