"""`sandbox replay --report`: what the page says, shows and weighs."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sandbox.report import report_page
from tests.cli.conftest import CRATE, GROUND, cli  # noqa: F401
from tests.git_folder import commit, enter, needs_git
from tests.report.browser import Browser

PLAYER = "document.querySelector('.player')"
SLOPE = {"id": "slope", "type": "static", "shapes": [{"box": [40, 1]}], "angle": -15}
BOX = {"id": "box", "shapes": [{"box": [1, 1]}], "position": [-3, 4], "angle": -15}


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    enter(tmp_path, monkeypatch)


def write(name: str, *bodies: Any, friction: float = 0.3, **fields: Any) -> Path:
    data = {"title": name, "materials": {"stuff": {"friction": friction}}, "defaults": {}, "bodies": list(bodies)}
    del data["defaults"]
    data["bodies"] = [{**body, "material": "stuff"} for body in bodies]
    path = Path(f"{name}.scene.json")
    path.write_text(json.dumps({**data, "settings": {"steps": 90}, **fields}, indent=1), encoding="utf-8")
    return path


def films_in(page: str) -> list[dict[str, Any]]:
    """The facts of all films in a page."""
    found = re.findall(r'<script type="text/plain"[^>]*>(\S+)\s', page)
    return [json.loads(zlib.decompress(base64.b64decode(facts))) for facts in found]


def reported(cli: Callable, *paths: object) -> str:  # noqa: F811
    assert cli("replay", *(paths or (".",)), "--report", "r.html").code == 1
    return Path("r.html").read_text(encoding="utf-8")


@pytest.fixture
def slid(cli: Callable) -> str:  # noqa: F811
    """The report of a box that slides otherwise, for its friction was edited; the scene as it was is in git."""
    cli("record", write("slide", SLOPE, BOX), "-o", "slide.replay.json")
    commit()
    write("slide", SLOPE, BOX, friction=0.2)
    return reported(cli)


class TestWords:
    def test_every_word_is_in_the_table_and_only_failures_are_told(self, cli: Callable) -> None:  # noqa: F811
        for name in ("good", "gone", "wrong"):
            cli("record", write(name, GROUND, CRATE), "-o", f"{name}.replay.json")
        write("fresh", GROUND, CRATE, expect=[{"at": 20, "rests": "crate"}])
        Path("gone.scene.json").unlink()
        text = Path("wrong.replay.json").read_text()
        last = re.findall(r'"digest": "(\w{16})"', text)[-1]
        Path("wrong.replay.json").write_text(text.replace(last, "0123456789abcdef"))
        page = reported(cli)
        for word in ("passed", "missing", "orphaned", "diverged"):
            assert f'<span class="verdict {word}">{word}</span>' in page
        assert page.count('<section class="failure"') == 3
        assert 'id="got-' in page
        assert "sandbox replay --update=missing fresh.replay.json" in page
        assert "good.scene.json" not in page

    def test_if_all_passed_there_is_only_the_table(self, cli: Callable) -> None:  # noqa: F811
        cli("record", write("good", GROUND, CRATE), "-o", "good.replay.json")
        assert cli("replay", ".", "--report", "r.html").code == 0
        page = Path("r.html").read_text(encoding="utf-8")
        assert "1 passed" in page
        assert films_in(page) == []

    @pytest.mark.parametrize(("name", "words"), [("r.txt", "must end in .html"), ("no/r.html", "does not exist")])
    def test_bad_names(self, cli: Callable, name: str, words: str) -> None:  # noqa: F811
        done = cli("replay", ".", "--report", name)
        assert done.code == 2
        assert words in done.err

    def test_past_some_failures_there_are_words_only(self, cli: Callable, monkeypatch: Any) -> None:  # noqa: F811
        monkeypatch.setattr(report_page, "SHOWN", 1)
        for name in "abc":
            cli("record", write(name, SLOPE, BOX), "-o", f"{name}.replay.json")
            write(name, SLOPE, BOX, friction=0.2)
        page = reported(cli)
        assert page.count('<section class="failure"') == 3
        assert page.count('class="player"') == 1


@needs_git
class TestFoundAgain:
    def test_an_edited_friction(self, slid: str) -> None:
        assert "slide.scene.json of revision" in slid
        assert "friction expected 0.3, got 0.2" in slid
        assert "separating-axis test of the first pair that differs" in slid
        assert "slope and box after step" in slid

    def test_an_edited_command(self, cli: Callable) -> None:  # noqa: F811
        push = [20, "ApplyImpulse", {"body": "box", "impulse": [0.5, 0.0]}]
        Path("push.json").write_text(json.dumps([push]))
        cli("record", write("slide", SLOPE, BOX), "-o", "slide.replay.json", "--commands", "push.json")
        commit()
        path = Path("slide.replay.json")
        path.write_text(path.read_text().replace("[0.5, 0.0]", "[0.75, 0.0]"))
        page = reported(cli)
        assert "the commands of slide.replay.json of revision" in page
        assert 'data-parted="21"' in page

    def test_a_version_that_gives_other_bits_is_not_believed(self, cli: Callable) -> None:  # noqa: F811
        cli("record", write("slide", SLOPE, BOX), "-o", "slide.replay.json")
        path = Path("slide.replay.json")
        lines = path.read_text().split("\n")
        at = lines.index('  "digests": [') + 10
        lines[at] = '    "0000 0000 0000 0000",'
        path.write_text("\n".join(lines))
        commit()
        write("slide", SLOPE, BOX, friction=0.2)
        page = reported(cli)
        assert "cannot be had again here" in page
        assert "of revision" not in page

    @pytest.mark.slow
    def test_the_ghost_and_the_mark_in_a_browser(self, slid: str, show: Browser) -> None:
        show.open(Path("r.html"))
        show.until(f"{PLAYER}.dataset.ready")
        parted = int(show.value(f"{PLAYER}.dataset.parted"))
        assert show.value(f"{PLAYER}.dataset.step") == str(parted - 1)
        at = "getComputedStyle(document.querySelector('.track .mark'))"
        assert show.value(f"{at}.backgroundColor") == "rgb(217, 72, 79)"
        assert show.value(f"Number({at}.getPropertyValue('--at'))") == pytest.approx(parted / 90)
        apart = f"""(p => {{
          const place = (film, step) => film.pose(film.rows.get('box'), step)[0];
          return [0, 90].map(step => place(p.film, step) - place(p.ghost, step));
        }})({PLAYER}.player)"""
        start, end = show.value(apart)
        assert start == 0.0
        assert end > 0.05

    @pytest.mark.slow
    def test_the_ghost_can_be_switched_off(self, slid: str, show: Browser) -> None:
        show.open(Path("r.html"))
        show.until(f"{PLAYER}.dataset.ready")
        picture = f"{PLAYER}.player.canvas.toDataURL()"
        show.value(f"{PLAYER}.player.seek(90)")
        before = show.value(picture)
        show.value(f"{PLAYER}.player.flipGhost()")
        assert show.value(picture) != before
        show.value(f"{PLAYER}.player.flipGhost()")
        assert show.value(picture) == before


@pytest.mark.slow
def test_without_history_the_ghost_is_the_recorded_end(cli: Callable, show: Browser) -> None:  # noqa: F811
    cli("record", write("slide", SLOPE, BOX), "-o", "slide.replay.json")
    write("slide", SLOPE, BOX, friction=0.2)
    page = reported(cli)
    assert "cannot be had again here" in page
    show.open(Path("r.html"))
    show.until(f"{PLAYER}.dataset.ready")
    recorded = json.loads(Path("slide.replay.json").read_text())["final"]["box"]
    ghost = show.value(f"(g => g.pose(g.rows.get('box'), 90))({PLAYER}.player.ghost)")
    assert ghost == pytest.approx(recorded, abs=1e-9)
    assert show.value(f"{PLAYER}.player.plots[0].plot.dots.length") == 2


@pytest.mark.slow
@needs_git
def test_500_bodies_and_600_steps_weigh_less_than_5_megabytes(cli: Callable) -> None:  # noqa: F811
    prefabs = {"box": {"material": "stuff", "shapes": [{"box": [1, 0.8]}]}}
    rain = {
        "id": "box",
        "grid": "box",
        "columns": 25,
        "rows": 20,
        "at": [-18, 1],
        "stagger": 0.4,
        "spacing": [1.5, 1.6],
    }
    walls = [{**GROUND, "id": f"wall-{x}", "position": [x, 19.5]} | {"shapes": [{"box": [1, 40]}]} for x in (-20, 26)]
    fields = {"prefabs": prefabs, "generate": [rain], "settings": {"steps": 600}}
    floor = {**GROUND, "shapes": [{"box": [80, 1]}]}
    cli("record", write("rain", floor, *walls, **fields), "-o", "rain.replay.json")
    commit()
    write("rain", floor, *walls, friction=0.5, **fields)
    page = reported(cli)
    films = films_in(page)
    assert [sum(body["id"].startswith("box-") for body in film["bodies"]) for film in films] == [500, 500]
    assert [film["every"] for film in films] == [1, 1]
    print(f"{len(page.encode()) / 1e6:.2f} MB")
    assert len(page.encode()) < 5_000_000
