"""Whether all names can be read that a scene declares: where they cannot, no name is said to be unknown.

So a list that should have been an object is told once, and not once more for each name in it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import cache
from itertools import islice
from typing import Any

from sandbox.scene.effort import Effort
from sandbox.scene.finding import COPIES, TAKEN, Finding
from sandbox.scene.other_words import nearest_word
from sandbox.scene.plain import children, is_several
from sandbox.scene.prefab import Prefab
from sandbox.scene.quantities import is_name
from sandbox.scene.scene_fields import SceneFields
from sandbox.scene.union import UNIONS

_BY_NAME = frozenset({"materials", "prefabs", "counters", "vars"})
_NAMES_ALONE = "categories"
_UNNAMED = ("regions", "rules")
"""Those whose entries need no id."""
_REGION_FIELDS = {name: None for kind in UNIONS["region"].values() for name in kind.model_fields}
_MOST = 100
"""So many fields that are none are looked at for one that is misspelt."""
_COPIED = frozenset({"bodies", "joints", "generate"})
"""What prefabs declare too, in the scenes that have copies of them."""


def without_follow_ups(
    findings: Iterable[Finding], data: dict[str, Any], lacking: Collection[str] = ()
) -> list[Finding]:
    """The findings but those about names that a scene's plain data may declare in what cannot be read of it.

    Of the fields `lacking`, more is declared than the data has.
    """

    # Who has spent all effort on near names is still not told what follows from one wrong field.
    own = Effort()

    @cache
    def is_whole(field: str) -> bool:
        return field not in lacking and _is_whole(data, field, own)

    return [finding for finding in findings if all(map(is_whole, finding.lacks))]


def _is_whole(data: dict[str, Any], field: str, left: Effort) -> bool:
    if field == COPIES:
        return _are_copies_named(data)
    if field == TAKEN:
        return _is_each_once(data.get("joints"))
    if not _is_read(data, field, SceneFields.model_fields, left):
        return False
    if field not in _COPIED:
        return True
    prefabs = [prefab for _, prefab in children(data.get("prefabs"), ())]
    several = [prefab for prefab in prefabs if is_several(prefab)]
    return all(_is_read(one, field, Prefab.model_fields, left) for one in several)


def _are_copies_named(data: dict[str, Any]) -> bool:
    """Whether no prefab gives an id twice, which each of its copies would have twice then."""
    prefabs = (prefab for _, prefab in children(data.get("prefabs"), ()) if is_several(prefab))
    return all(_is_each_once(_bodies_of(prefab)) and _is_each_once(prefab.get("joints")) for prefab in prefabs)


def _bodies_of(prefab: dict[str, Any]) -> list[Any]:
    """The entries of a prefab that are bodies under their own ids, those of single copies included."""
    placed = [entry for _, entry in children(prefab.get("generate"), ()) if "place" in entry and "count" not in entry]
    return [*(body for _, body in children(prefab.get("bodies"), ())), *placed]


def _is_read(home: dict[str, Any], field: str, known: Collection[str], left: Effort) -> bool:
    """Whether a field of an object is of its kind, and so are the names in it."""
    if is_misspelt(field, home, known, left):
        return False
    value = home.get(field, {} if field in _BY_NAME else ())
    if field in _BY_NAME:
        return isinstance(value, dict)
    if not isinstance(value, (list, tuple)):
        return False
    if field == _NAMES_ALONE:
        return all(isinstance(entry, str) for entry in value)
    return all(isinstance(entry, dict) and _is_named(entry, field) for entry in value)


def _is_each_once(entries: Any) -> bool:
    """Whether no id in a list is given twice, as far as they can be read."""
    ids = [entry["id"] for _, entry in children(entries, ()) if isinstance(entry.get("id"), str)]
    return len(set(ids)) == len(ids)


def _is_named(entry: dict[str, Any], field: str) -> bool:
    if "id" not in entry and field in _UNNAMED:
        return not is_misspelt("id", entry, _REGION_FIELDS)
    name = entry.get("id")
    return isinstance(name, str) and is_name(name)


def is_misspelt(field: str, home: dict[str, Any], known: Collection[str], left: Effort | None = None) -> bool:
    """Whether an object has a field that is not `known`, and looks like this one."""
    strays = islice((key for key in home if key not in known), _MOST)
    return any(nearest_word(key, known, left) == field for key in strays)
