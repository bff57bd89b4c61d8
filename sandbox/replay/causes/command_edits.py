"""In what the commands of a recording differ from those that it was made with, in words."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sandbox.replay.causes.scene_edits import Edit, edits
from sandbox.replay.recording.command_words import TimedCommand, encode
from sandbox.scene.excerpt import line_column
from sandbox.scene.finding import Path
from sandbox.scene.locate import locate


def command_edits(old: Sequence[TimedCommand], new: Sequence[TimedCommand]) -> list[tuple[int, str]]:
    """(place in the list of now, words) for each command that differs; one more or less ends the comparison."""
    found: list[tuple[int, str]] = []
    for place in range(max(len(old), len(new))):
        before, after = (rows[place] if place < len(rows) else None for rows in (old, new))
        if before == after:
            continue
        if len(old) != len(new) or before is None or after is None:
            return [*found, (place, _one_more_or_less(old, new, place))]
        found.append((place, _changed(place, before, after)))
    return found


def located(found: Sequence[tuple[int, str]], text: str, file: str) -> tuple[str, ...]:
    """The same with `FILE:LINE:COLUMN: ` before each, for a recording whose text is `text`."""
    paths: list[Path] = [("commands", place) for place, _ in found]
    places = locate(text, paths)
    spots = [line_column(text, places[path].value_span[0]) for path in paths]
    return tuple(f"{file}:{line}:{column}: {words}" for (line, column), (_, words) in zip(spots, found, strict=True))


def _one_more_or_less(old: Sequence[TimedCommand], new: Sequence[TimedCommand], place: int) -> str:
    if len(new) < len(old):
        return f"{_title(place, old[place])} is gone"
    return f"{_title(place, new[place])} is new"


def _changed(place: int, old: TimedCommand, new: TimedCommand) -> str:
    parts = [] if old[0] == new[0] else [f"its step was {old[0]} and is {new[0]}"]
    before, after = encode(old[1]), encode(new[1])
    if before[0] != after[0]:
        parts.append(f"it was {before[0]}")
    else:
        parts += [str(edit) for edit in _in_fields(before[1], after[1])]
    return f"{_title(place, new)}: {', '.join(parts)}"


def _in_fields(old: dict[str, Any], new: dict[str, Any]) -> list[Edit]:
    return list(edits(_as_json(old), _as_json(new)))


def _as_json(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _as_json(entry) for key, entry in value.items()}
    return [_as_json(entry) for entry in value] if isinstance(value, (list, tuple)) else value


def _title(place: int, command: TimedCommand) -> str:
    """`command 2 (step 20, ApplyImpulse on box)`; numbers from 1, as people count."""
    name, fields = encode(command[1])
    target = next((str(fields[key]) for key in ("body", "joint", "region", "thruster") if key in fields), "")
    return f"command {place + 1} (step {command[0]}, {name}{f' on {target}' if target else ''})"
