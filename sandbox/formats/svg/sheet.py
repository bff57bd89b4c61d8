"""Style sheets of drawings.

Selectors are an element, `.class`, `#id`, `*`, several of these joined, and such within others (`g .a`, `g > .a`);
others, and rules that hold under conditions (`@media`), are counted by `Sheet.passed_over`. A text takes no longer to
read than it is long.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from sandbox.formats.xml_tree import Element

_COMPOUND = re.compile(r"([A-Za-z][\w-]*|\*)?((?:[.#][\w-]+)*)")
_MOST_PARTS = 8
_HARMLESS = ("@charset", "@font-face", "@namespace")

Style = dict[str, str]


class _Part(NamedTuple):
    """What one element must be; `child`: right within what the part before says."""

    tag: str
    classes: frozenset[str]
    ids: frozenset[str]
    child: bool

    @property
    def key(self) -> str:
        """What an element surely has that it fits."""
        return next((f"#{name}" for name in self.ids), next((f".{name}" for name in self.classes), self.tag or "*"))

    def fits(self, element: Element) -> bool:
        """Whether an element is so."""
        is_kind = self.tag in ("", "*", element.tag)
        return is_kind and self.classes <= set(element.get("class").split()) and self.ids <= {element.get("id")}


class _Rule(NamedTuple):
    weight: tuple[int, int, int, int]
    """Ids, classes and elements that it names, and its place."""
    parts: tuple[_Part, ...]
    style: Style


class Sheet:
    """All `<style>` of a file."""

    def __init__(self, text: str) -> None:
        self.passed_over = 0
        self._count = 0
        self._rules: dict[str, list[_Rule]] = defaultdict(list)
        for selectors, body in self._split(_without_comments(text)):
            style = declarations(body)
            for selector in selectors.split(","):
                self._add(selector, style)

    def of(self, element: Element, around: Sequence[Element]) -> Style:
        """What the rules say of an element within others, the outermost first; the strongest last."""
        if not self._count:
            return {}
        keys = ["*", element.tag, f"#{element.get('id')}", *(f".{name}" for name in set(element.get("class").split()))]
        near = (rule for key in keys for rule in self._rules.get(key, ()))
        fitting = [rule for rule in near if rule.parts[-1].fits(element) and _fits(rule.parts, around)]
        found: Style = {}
        for rule in sorted(fitting, key=lambda rule: rule.weight):
            found |= rule.style
        return found

    def _split(self, text: str) -> Iterator[tuple[str, str]]:
        """Selectors and what stands in braces behind them."""
        at = 0
        while (opened := text.find("{", at)) >= 0 and (closed := text.find("}", opened)) >= 0:
            *statements, selectors = text[at:opened].split(";")
            self._pass_over(*statements)
            if selectors.lstrip().startswith("@"):
                self._pass_over(selectors)
                closed = _closing(text, opened)
            else:
                yield selectors, text[opened + 1 : closed]
            at = closed + 1

    def _pass_over(self, *statements: str) -> None:
        told = (each for each in statements if each.strip().startswith("@"))
        self.passed_over += sum(not each.strip().startswith(_HARMLESS) for each in told)

    def _add(self, selector: str, style: Style) -> None:
        words = selector[:1000].replace(">", " > ").split()
        parts = [_part(word, before == ">") for before, word in pairwise(["", *words]) if word != ">"]
        if not parts or len(parts) > _MOST_PARTS or None in parts or ">" in (words[0], words[-1]):
            self.passed_over += 1
            return
        known = tuple(part for part in parts if part is not None)
        names = (sum(len(part.ids) for part in known), sum(len(part.classes) for part in known))
        self._count += 1
        weight = (*names, sum(part.tag not in ("", "*") for part in known), self._count)
        self._rules[known[-1].key].append(_Rule(weight, known, style))


def _without_comments(text: str) -> str:
    first, *rest = text.replace("<!--", " ").replace("-->", " ").split("/*")
    return first + "".join(part.partition("*/")[2] for part in rest)


def _closing(text: str, opened: int) -> int:
    """Where the brace closes that opens here; the end, if it does not."""
    depth = 0
    for match in re.finditer(r"[{}]", text[opened:]):
        depth += 1 if match.group() == "{" else -1
        if depth == 0:
            return opened + match.start()
    return len(text)


def _part(word: str, child: bool) -> _Part | None:
    match = _COMPOUND.fullmatch(word)
    if match is None:
        return None
    names = re.findall(r"([.#])([\w-]+)", match[2])
    classes, ids = (frozenset(name for mark, name in names if mark == kind) for kind in ".#")
    return _Part(match[1] or "", classes, ids, child)


def _fits(parts: tuple[_Part, ...], around: Sequence[Element]) -> bool:
    """Whether the elements around one are as all parts but the last say."""
    places = {len(around)}
    for part, inner in zip(parts[-2::-1], parts[:0:-1], strict=True):
        last = max(places, default=-1)
        fitting = (k for k in range(last) if part.fits(around[k]))
        places = {k for k in fitting if not inner.child or k + 1 in places}
    return bool(places)


def declarations(text: str) -> Style:
    """`fill: red; stroke: none` as a dictionary."""
    pairs = (part.partition(":") for part in text.split(";"))
    return {key.strip().lower(): value.replace("!important", "").strip() for key, _, value in pairs if value.strip()}
