"""A page of scenes by theme, with pictures and a search, on which each of them can be played offline."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from itertools import count

from sandbox.report.gallery_card import PICTURE, GalleryCard
from sandbox.report.markup import PLAYER, Node, film_script, node, text_of, whole_page

_HIDDEN = {"hidden": ""}


def gallery_page(title: str, cards: Sequence[GalleryCard]) -> str:
    """The HTML of the page: cards by theme, each under an address of its own."""
    groups: dict[str, list[Node]] = {}
    for number, (card, anchor) in enumerate(zip(cards, _anchors(cards), strict=True)):
        groups.setdefault(card.entry.theme, []).append(_card(card, number, anchor))
    sections = [_section(theme, group, number) for number, (theme, group) in enumerate(groups.items())]
    main = node("main", "", *sections, node("p", "none", "No scene has all of these words.", **_HIDDEN))
    films = [film_script(f"film-{number}", card.film) for number, card in enumerate(cards)]
    body = [text_of(part) for part in (_head(title, len(cards), groups), main, _stage(), *films)]
    return whole_page(title, body, "gallery", (*PLAYER, "gallery.js"), ("page.css", "gallery.css"))


def _anchors(cards: Sequence[GalleryCard]) -> list[str]:
    """What stands behind the # in the address of each: its name, and where an earlier one has that, a number more."""
    found: dict[str, None] = {}
    for card in cards:
        names = (card.name if k == 1 else f"{card.name}-{k}" for k in count(1))
        found[next(name for name in names if name not in found)] = None
    return list(found)


def _head(title: str, shown: int, groups: Mapping[str, Sequence[Node]]) -> Node:
    words = f"{shown} scene{'' if shown == 1 else 's'}: choose one to watch it. This page plays them all by itself."
    search = node("input", "search", type="search", placeholder="Search", **{"aria-label": "Search scenes"})
    headline = node("div", "headline", node("h1", "", title), node("p", "soft", words), search)
    chips = [
        node("a", "", f"{theme or 'others'} ", node("b", "", str(len(group))), href=f"#{_section_id(number)}")
        for number, (theme, group) in enumerate(groups.items())
    ]
    inner = node("div", "inner", headline, node("nav", "themes", *chips, **{"aria-label": "Themes"}))
    return node("header", "top", inner)


def _section(theme: str, cards: Sequence[Node], number: int) -> Node:
    return node("section", "", node("h2", "", theme or "others"), node("div", "cards", *cards), id=_section_id(number))


def _section_id(number: int) -> str:
    """No file can be called so, and no browser writes it otherwise in an address."""
    return f"/{number}"


def _card(card: GalleryCard, number: int, anchor: str) -> Node:
    entry = card.entry
    source = "data:image/webp;base64," + base64.b64encode(card.picture).decode("ascii")
    width, height = map(str, PICTURE)
    picture = node("img", "", src=source, alt="", width=width, height=height, loading="lazy", decoding="async")
    joints = f" · {card.joints:,} joint{'' if card.joints == 1 else 's'}" if card.joints else ""
    facts = f"{card.bodies:,} bod{'y' if card.bodies == 1 else 'ies'}{joints} · {card.seconds:.3g} s"
    data = {
        "data-words": f"{entry.title} {entry.about} {entry.theme} {card.name}".lower(),
        "data-film": f"film-{number}",
        "data-command": f"sandbox run {card.said}",
    }
    words = [node("h3", "", entry.title), node("p", "about", entry.about), node("p", "facts", facts)]
    return node("a", "card", node("span", "still", picture), *words, href=f"#{anchor}", **data)


def _stage() -> Node:
    """The dialog in which a scene is played."""
    ways = [
        node("button", kind, sign, type="button", title=title, **{"aria-label": title})
        for kind, sign, title in (
            ("back", "‹", "The scene before (Page Up)"),
            ("on", "›", "The next scene (Page Down)"),
            ("close", "✕", "Close (Esc)"),
        )
    ]
    words = node("div", "", node("h2", ""), node("p", "about"))
    head = node("div", "head", words, node("div", "ways", *ways))
    foot = node("p", "foot", "In the window, with tools to throw, join and rewind: ", node("code", ""))
    return node("dialog", "stage", head, node("div", "slot"), foot)
