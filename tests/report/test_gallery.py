"""The gallery: a page that holds every scene and asks for nothing, and a sheet of their pictures."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from sandbox.cli import main
from sandbox.render.contact_sheet import EDGE, GAP, LETTERS, LINE, contact_sheet, title_lines
from sandbox.report.gallery_card import PICTURE, GalleryCard, gallery_card, run_beside
from sandbox.report.gallery_page import gallery_page
from sandbox.scene.catalog import Entry, entry_of
from tests.report.browser import Browser
from tests.shipped import FILES

NAMES = ("three-to-one", "one-impulse", "test-one")
HOSTILE = '</script><b onclick="x">&amp;'


@pytest.fixture(scope="module")
def cards() -> list[GalleryCard]:
    return [gallery_card(entry_of(FILES[name], FILES[name].parent.name)) for name in NAMES]


class Reader(HTMLParser):
    """The tags of a page with their attributes, and what stands in its films."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.films: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        if (self.tags or [("", {})])[-1][1].get("type") == "text/plain" and data.strip():
            self.films.append(data)

    def of(self, kind: str) -> list[dict[str, str | None]]:
        return [given for _, given in self.tags if given.get("class") == kind]


def facts(film: str) -> dict[str, Any]:
    return dict(json.loads(zlib.decompress(base64.b64decode(film.split("\n")[0]))))


def test_a_page_has_a_card_and_a_film_for_each_scene(cards: list[GalleryCard]) -> None:
    page = Reader(gallery_page("My scenes", cards))
    links = page.of("card")
    assert [link["href"] for link in links] == [f"#{name}" for name in NAMES]
    assert [link["data-film"] for link in links] == [f"film-{k}" for k in range(len(NAMES))]
    assert "a small ball rides" in (links[0]["data-words"] or "")
    assert [len(facts(film)["bodies"]) for film in page.films] == [card.bodies for card in cards]
    picture = next(given["src"] or "" for tag, given in page.tags if tag == "img")
    with Image.open(BytesIO(base64.b64decode(picture.partition(",")[2]))) as image:
        assert image.size == PICTURE


def test_a_page_needs_nothing_and_names_are_no_markup(cards: list[GalleryCard]) -> None:
    entry = Entry(Path("x.scene.json"), HOSTILE, HOSTILE, HOSTILE)
    card = GalleryCard(HOSTILE, entry, 1, 0, 1.0, b"", cards[0].film)
    page = gallery_page(HOSTILE, [card])
    assert HOSTILE not in page
    assert not any("onclick" in given for _, given in Reader(page).tags)
    assert re.findall(r"https?:", page) == []


def test_scenes_of_one_name_have_addresses_of_their_own(cards: list[GalleryCard], tmp_path: Path) -> None:
    """Of three files called `x.scene.json` the first was played, whichever was chosen."""
    same = [
        replace(card, name="x", entry=entry_of(FILES[card.name], theme))
        for card, theme in zip(cards, "aba", strict=True)
    ]
    page = Reader(gallery_page("", same))
    assert [link["href"] for link in page.of("card")] == ["#x", "#x-3", "#x-2"]
    assert [link["data-film"] for link in page.of("card")] == ["film-0", "film-2", "film-1"]
    ids = [given["id"] for tag, given in page.tags if tag == "section"]
    assert len(set(ids)) == len(ids) == 2


def test_a_card_says_how_its_scene_is_run(cards: list[GalleryCard]) -> None:
    assert [card.said for card in cards] == list(NAMES)
    strange = replace(cards[0], name="a b", entry=entry_of(Path("my scenes/a b.scene.json"), ""))
    assert strange.said == "'my scenes/a b.scene.json'"


def test_a_scene_is_played_as_its_recording_does() -> None:
    assert run_beside(FILES["breakout"]).commands
    assert not run_beside(FILES["test-one"]).commands


def test_titles_of_a_sheet_are_large_and_in_two_lines_at_most() -> None:
    from PIL import Image, ImageDraw

    pen = ImageDraw.Draw(Image.new("RGB", (1, 1)))
    assert LETTERS >= 20
    assert title_lines(pen, "Pinball", 192) == ["Pinball"]
    assert title_lines(pen, "A Rube Goldberg machine", 192) == ["A Rube Goldberg", "machine"]
    first, second = title_lines(pen, "Only the slanted edge parts the two of them, and it comes last", 192)
    assert first == "Only the slanted"
    assert second.endswith("…")


def test_a_sheet_has_all_pictures_in_rows() -> None:
    pictures = [("A title that is far too long for so small a picture", Image.new("RGB", (60, 40), (k, 0, 0)))
                for k in range(1, 6)]  # fmt: skip
    sheet = contact_sheet(pictures, 3)
    assert sheet.size == (3 * 60 + 2 * GAP + 2 * EDGE, 2 * (40 + LINE) + GAP + 2 * EDGE)
    assert sheet.getpixel((EDGE, EDGE)) == (1, 0, 0)
    assert sheet.getpixel((EDGE + 60 + GAP, EDGE + 40 + LINE + GAP)) == (5, 0, 0)


def test_the_command_shows_what_it_can(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def ended(*arguments: object) -> int:
        with pytest.raises(SystemExit) as stop:
            main([str(argument) for argument in arguments])
        return int(stop.value.code or 0)

    (tmp_path / "good.scene.json").write_bytes(FILES["test-one"].read_bytes())
    (tmp_path / "bad.scene.json").write_text("{")
    out = tmp_path / "out.html"
    assert ended("gallery", tmp_path, "-o", out, "--json") == 2
    said = capsys.readouterr()
    document = json.loads(said.out)
    assert document["scenes"] == 1
    assert [problem["source"] for problem in document["problems"]] == [str(tmp_path / "bad.scene.json")]
    assert "bad.scene.json:1:" in said.err
    assert out.stat().st_size > 20_000
    (tmp_path / "good.scene.json").rename(tmp_path / "good.json")
    assert ended("gallery", tmp_path, "-o", tmp_path / "none.html", "--json") == 2
    document = json.loads(capsys.readouterr().out)
    assert (document["scenes"], document["path"], len(document["problems"])) == (0, None, 1)
    assert not (tmp_path / "none.html").exists()
    (tmp_path / "good.json").rename(tmp_path / "good.scene.json")
    (tmp_path / "bad.scene.json").unlink()
    assert ended("gallery", tmp_path, "-o", tmp_path / "out.png") == 0
    with Image.open(tmp_path / "out.png") as sheet:
        assert sheet.width < 300
    assert ended("gallery", tmp_path, "-o", "out.pdf") == 2
    assert ended("gallery", tmp_path / "nowhere", "-o", out) == 2


def test_a_folder_of_any_name_can_be_searched(show: Browser, cards: list[GalleryCard], tmp_path: Path) -> None:
    """The names of themes were part of addresses, which a browser writes otherwise; the whole script ended there."""
    entries = [replace(card.entry, theme=theme) for card, theme in zip(cards, ("a b", "ü%", "#1"), strict=True)]
    named = [replace(card, entry=entry, name=entry.theme) for card, entry in zip(cards, entries, strict=True)]
    path = tmp_path / "gallery.html"
    path.write_text(gallery_page("Scenes", named), encoding="utf-8")
    show.open(path)
    show.value("search = document.querySelector('.search'); search.value = 'ü%'; "
               "search.dispatchEvent(new Event('input'))")  # fmt: skip
    assert show.value("[...document.querySelectorAll('.themes a:not([hidden])')].length") == 1
    show.value("document.querySelector('.card:not([hidden])').click()")
    show.until("document.querySelector('.stage .player')?.dataset.ready")
    assert show.value("document.querySelector('.stage h2').textContent") == cards[1].entry.title


@pytest.mark.slow
def test_in_a_browser(show: Browser, cards: list[GalleryCard], tmp_path: Path) -> None:
    path = tmp_path / "gallery.html"
    path.write_text(gallery_page("Scenes", cards), encoding="utf-8")
    show.open(path)
    shown: Callable[[], Any] = lambda: show.value("[...document.querySelectorAll('.card:not([hidden])')].length")  # noqa: E731
    assert shown() == 3
    show.value("search = document.querySelector('.search'); search.value = 'BALL mass'; "
               "search.dispatchEvent(new Event('input')); 1")  # fmt: skip
    assert shown() == 1
    show.value("document.querySelector('.card:not([hidden])').click(); 1")
    show.until("document.querySelector('.stage .player')?.dataset.ready && document.querySelector('.stage').open")
    show.until("Number(document.querySelector('.player').dataset.step) > 2")
    assert show.value("document.querySelector('.stage h2').textContent") == "Three to one"
    show.value("search.value = ''; search.dispatchEvent(new Event('input')); document.querySelector('.on').click(); 1")
    show.until("location.hash === '#one-impulse' && document.querySelectorAll('.player[data-ready]').length === 1")
    show.value("document.querySelector('.close').click(); 1")
    show.until("!document.querySelector('.stage').open && !document.querySelector('.player') && !location.hash")
