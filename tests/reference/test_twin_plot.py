"""The picture of a twin run: well-formed, complete, the same bytes for the same run."""

from __future__ import annotations

import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image

from sandbox.errors import MissingDependencyError
from sandbox.reference.twin import Twin, simulate_twin
from sandbox.reference.twin_plot import save_plot
from tests import flat


@pytest.fixture(scope="module")
def twin() -> Twin:
    return simulate_twin(flat.scene(flat.ground(), flat.body("a", flat.box(1, 1), position=(0, 2))), 60)


@pytest.mark.slow
def test_an_svg_is_well_formed_and_repeats_to_the_byte(twin: Twin, tmp_path: Path) -> None:
    first, second = tmp_path / "a.svg", tmp_path / "b.svg"
    save_plot(twin, "A fall & <more>", first)
    save_plot(twin, "A fall & <more>", second)
    assert ElementTree.parse(first).getroot().tag.endswith("svg")
    assert first.read_bytes() == second.read_bytes()


@pytest.mark.slow
def test_both_curves_are_in_every_panel(twin: Twin, tmp_path: Path) -> None:
    save_plot(twin, "A fall", tmp_path / "a.svg")
    text = (tmp_path / "a.svg").read_text()
    for color in ("#ffb454", "#5fb0ff"):
        assert text.count(f"stroke: {color}") == 5  # four panels and the legend


@pytest.mark.slow
def test_a_png_has_ink_of_both_engines(twin: Twin, tmp_path: Path) -> None:
    save_plot(twin, "A fall", tmp_path / "a.png")
    with Image.open(tmp_path / "a.png") as image:
        assert image.size == (1440, 1260)
        colors = {color for _, color in image.convert("RGB").getcolors(1 << 24)}
    assert {(0xFF, 0xB4, 0x54), (0x5F, 0xB0, 0xFF)} <= colors


def test_a_single_sample_can_be_drawn(tmp_path: Path) -> None:
    save_plot(simulate_twin(flat.scene(flat.ground()), 0), "nothing", tmp_path / "a.svg")
    assert (tmp_path / "a.svg").stat().st_size > 1000


def test_without_matplotlib_the_message_says_what_to_install(
    twin: Twin, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingDependencyError, match=r"python -m pip install matplotlib$"):
        save_plot(twin, "A fall", tmp_path / "a.svg")
