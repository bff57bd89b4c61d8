"""One player as a page of its own, and as a frame inside another page."""

from __future__ import annotations

import html

from sandbox.report.film import Film
from sandbox.report.film_data import film_data, packed
from sandbox.report.markup import film_script, node, text_of, whole_page


def player_page(title: str, film: Film, small: bool = False, about: str = "") -> str:
    """The HTML of a page that plays a film, in its theme; `small` leaves out the headline and `about`."""
    words = [node("h1", "", title), *([node("p", "soft", about)] if about else [])]
    head = [] if small else [text_of(part) for part in words]
    parts = node("div", "player", **{"data-got": "film"}), film_script("film", packed(film_data(film)))
    body = [*head, *(text_of(part) for part in parts)]
    return whole_page(title, body, "alone small" if small else "alone", theme=film.theme)


def player_frame(title: str, film: Film, height: int = 470) -> str:
    """An `iframe` that holds such a page: for notebooks, whose own page it cannot touch."""
    page = html.escape(player_page(title, film, small=True), quote=True)
    style = f"width:100%;max-width:860px;height:{height}px;border:0;border-radius:10px"
    name = html.escape(title, quote=True)
    return f'<iframe srcdoc="{page}" sandbox="allow-scripts" title="{name}" style="{style}"></iframe>'
