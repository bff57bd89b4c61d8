"""Counters, rules, controls and the camera of a scene as they go on from now.

Times count from now, and what names somebody who is gone is left out: in a world that does nothing any more, and in a
scene it would be a mistake. Who is missed is asked of the check that scenes are loaded with.
"""

from __future__ import annotations

from typing import Any

from sandbox.scene.finding import Path
from sandbox.scene.names import body_ids
from sandbox.scene.play.control import InputControl
from sandbox.scene.play.references import PAIRS, play_references
from sandbox.scene.play.rule import Rule
from sandbox.scene.references import followed
from sandbox.scene.scene_fields import SceneFields
from sandbox.scene.settings import View
from sandbox.tables import plain
from sandbox.world.build_fields import step_at
from sandbox.world.export.numbers import fitted
from sandbox.world.export.present import Present
from sandbox.world.rule_records import OPEN

Words = dict[str, Any]

_PAIRS = (*PAIRS, "touches")
_GONE = "what rules, controls and the camera have to do with what is gone is left out"


def play_words(present: Present, joints: list[int]) -> dict[str, Any]:
    """The fields of a scene that say how it is played and looked at; `joints` are the rows of those that last."""
    scene, census = present.scene, present.state.census
    if not (scene.rules or scene.controls or scene.counters or scene.view):
        return {}
    _note_present(present)
    rules = [(rule, words) for n, rule in enumerate(scene.rules) if (words := _later(present, n, rule)) is not None]
    data: Words = {
        "bodies": [{"id": name} for name in census.bodies.names],
        "joints": [{"id": census.joints.names[row]} for row in joints],
        "regions": [{"id": name} for name in census.regions.names],
        "counters": _counters(present),
        "rules": [words for _, words in rules],
        "controls": [control.to_data() for control in scene.controls],
        "view": {} if scene.view is None else scene.view.to_data(),
    }
    _leave_out(present, data)
    left = [(rule, words) for (rule, _), words in zip(rules, data["rules"], strict=True) if words.get("do")]
    return {
        "counters": data["counters"],
        "rules": tuple(rule if rule.to_data() == words else Rule(**words) for rule, words in left),
        "controls": tuple(
            control if control.to_data() == words else InputControl(**words)
            for control, words in zip(scene.controls, data["controls"], strict=True)
        ),
        "view": _view(scene.view, data["view"]),
    }


def _counters(present: Present) -> dict[str, float]:
    found: dict[str, float] = {}
    for name, value in zip(present.scene.counters, plain(present.state.tallies)["value"].tolist(), strict=True):
        found[name] = fitted(SceneFields, "counters", value)
        if found[name] != value:
            present.remarks.note("counters past the limit of scene files are cut to it", name)
    return found


def _later(present: Present, number: int, rule: Rule) -> Words | None:
    """The entry of a rule from now on; None if it is over."""
    words, when, now, rate = rule.to_data(), rule.when.flat(), present.now, present.step_rate
    count = int(plain(present.state.rules)["count"][number])
    if rule.limit is not None and count:
        words["limit"] = rule.limit - count
    first = max(step_at(when.start if when.kind == "every" else when.time, rate), 1)
    if when.kind == "time" and now:
        words["when"]["time"] = (first - now) / rate
    elif when.kind == "every" and now:
        period = max(step_at(when.time, rate), 1)
        words["when"]["start"] = (first - now if first > now else period - (now - first) % period) / rate
    over = words.get("limit") == 0 or (when.kind == "time" and first <= now)
    return None if over else words


def _leave_out(present: Present, data: Words) -> None:
    """Take out what names somebody who is gone, until nothing does; rules may end up with nothing to do."""
    while found := _missing(data):
        present.remarks.note(_GONE)
        for holder, paths in sorted(found.items(), reverse=True):
            _take_out(data, holder, paths)


def _missing(data: Words) -> dict[Path, list[Path]]:
    """The paths of the names of those who are gone, by what cannot be without them: an action, a rule, the view."""
    ids, found = body_ids(data), dict[Path, list[Path]]()
    for finding in (*play_references(data, ids), *followed(data, ids)):
        path = finding.path
        of_rule = path[0] == "rules" and path[2] in ("when", "if")
        found.setdefault(path[:2] if of_rule else path[:4], []).append(path)
    return found


def _take_out(data: Words, holder: Path, paths: list[Path]) -> None:
    """Take names out of the list that they are in, or else all that cannot be without them."""
    *way, last = holder
    parent: Any = data
    for part in way:
        parent = parent[part]
    names: Any = parent[last]
    for part in paths[0][len(holder) : -1]:
        names = names[part]
    of_one_list = len({path[:-1] for path in paths}) == 1 and isinstance(paths[0][-1], int)
    if of_one_list and paths[0][-2] not in _PAIRS and len(paths) < len(names):
        for path in sorted(paths, reverse=True):
            del names[path[-1]]
    elif len(holder) == 2 and holder[0] == "rules":
        parent[last] = {}  # others keep their numbers
    else:
        del parent[last]


def _view(author: View | None, words: Words) -> View | None:
    if author is None or author.to_data() == words:
        return author
    return View(**words) if words else None


def _note_present(present: Present) -> None:
    """What has no words of how it is played now."""
    state, rate = present.state, present.step_rate
    for rule, row in zip(present.scene.rules, plain(state.rules), strict=True):
        if row["last_step"] >= 0 and present.now - row["last_step"] < step_at(rule.cooldown, rate):
            present.remarks.note("cooldowns are over", rule.id or "")
    waits = {kind for rule in present.scene.rules for kind in rule.when.given()}
    touching = plain(state.contacts)["touching"][: int(state.counters[0].contact_count)]
    if ("begin" in waits and touching.any()) or ("enter" in waits and len(state.sensings)):
        present.remarks.note("rules hear once more of what touches, or is in a sensor")
    if any(plain(state.outcome)["result"] != OPEN):
        present.remarks.note("how the game ended is left out")
    for control, value in zip(present.scene.controls, plain(state.controls)["value"].tolist(), strict=True):
        if value:
            present.remarks.note("controls are let go", control.id)
