"""Which body has which colour: chosen once, then dimmed or marked frame by frame."""

from __future__ import annotations

import re
import zlib
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from sandbox.render.camera import Floats
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints
from sandbox.render.materials.looks import MaterialLook, look_of
from sandbox.render.materials.textures import texture_number
from sandbox.render.oklab import oklch_to_srgb
from sandbox.render.theme import DARK, Color, Theme, hex_color
from sandbox.scene.flat import FlatBody
from sandbox.world.records import DYNAMIC, KINEMATIC, STATIC
from sandbox.world.roster import Register
from sandbox.world.state import State


@dataclass(frozen=True)
class FrameColors:
    """Colours of every body in one frame, sRGB (n, 3) each; `hatched` (n,) marks frozen bodies."""

    fill: Floats
    edge: Floats
    mark: Floats
    hatched: Floats


STATIC_MATERIAL = 0.55
"""How far the colour of a static body moves from its material's towards that of all static ones."""


@dataclass(frozen=True)
class BodyColors:
    """The awake colour of each body (n, 3), chosen when it comes into the world; `roster` says who they are.

    `texture` (n,) are numbers of `materials.textures`, `opacity` (n,) 0..1 is less than 1 for what is translucent.
    """

    theme: Theme
    base: Floats = field(repr=False)
    texture: Ints = field(repr=False)
    opacity: Floats = field(repr=False)
    roster: Register[FlatBody] | None = field(default=None, repr=False)

    def for_frame(self, frame: Frame) -> BodyColors:
        """The colours for a frame: itself, or if bodies came or went, others in which those that stayed keep theirs."""
        if self.roster is None or self.roster is frame.roster:
            return self
        fresh = _colors_for(frame.roster, frame.type.tolist(), self.theme)
        rows = {serial: row for row, serial in enumerate(self.roster.serials)}
        for new, (serial, body) in enumerate(zip(frame.roster.serials, frame.roster.items, strict=True)):
            old = rows.get(serial)
            if old is not None and self.roster.items[old] == body:
                fresh.base[new] = self.base[old]
        return fresh


@lru_cache(maxsize=1 << 16)
def family(name: str) -> str:
    """What bodies of one generator share: the id without its counters (`"crate-3-7"` -> `"crate"`)."""
    return re.sub(r"[\W_]*\d+([\W_]+\d+)*$", "", name) or name


def material_of(body: FlatBody) -> str:
    """The name of the first material that any of its shapes has; "" if none has one."""
    return next((shape.material for shape in body.shapes if shape.material), "")


def body_colors_of(state: State, theme: Theme = DARK) -> BodyColors:
    """The colours of a world's bodies; `color` in the scene overrules."""
    return _colors_for(state.roster.bodies, state.bodies.type, theme)


def _colors_for(roster: Register[FlatBody], types: Sequence[int], theme: Theme) -> BodyColors:
    colors = {body.id: body.color for body in roster.items if body.color}
    materials = [material_of(body) for body in roster.items]
    return replace(choose_colors(roster.names, types, theme, colors, materials), roster=roster)


def choose_colors(
    names: Sequence[str],
    types: Sequence[int],
    theme: Theme,
    colors: Mapping[str, str] | None = None,
    materials: Sequence[str] = (),
) -> BodyColors:
    """Choose a colour for every body by its id and type, or by the name of its material where that is known; `colors`
    (id -> CSS colour) overrules.
    """
    chosen, looks = colors or {}, [look_of(name) for name in materials] or [None] * len(names)
    families = [family(name) for name in names]
    size, seen = Counter(families), Counter[str]()
    hues = _family_hues((own for own, kind in zip(families, types, strict=True) if kind == DYNAMIC), theme)
    base = np.zeros((len(names), 3))
    for i, (name, own) in enumerate(zip(names, families, strict=True)):
        look, rank = looks[i], seen[own]
        usual = _base_color(types[i], hues.get(own, (0.0, 0.0)), rank, size[own], theme)
        base[i] = _color(name, chosen) or (usual if look is None else _material_color(look, types[i], rank, theme))
        seen[own] += 1
    texture = np.array([texture_number(look.texture) if look else 0 for look in looks], np.int64)
    return BodyColors(theme, base, texture, np.array([look.opacity if look else 1.0 for look in looks]))


def _material_color(look: MaterialLook, kind: int, rank: int, theme: Theme) -> Color:
    """That of the material; static bodies stay in the background, and neighbours differ a little."""
    if kind != STATIC:
        return look.color(theme, _scatter(rank, 0.7548776662))
    red, green, blue = mix(np.array(look.color(theme)), theme.static, STATIC_MATERIAL).tolist()
    return red, green, blue


def _color(name: str, chosen: Mapping[str, str]) -> Color | None:
    return hex_color(chosen[name]) if name in chosen else None


def _family_hues(families: Iterable[str], theme: Theme) -> dict[str, tuple[float, float]]:
    """A hue, and how much lighter it is, for each family by its name; where an earlier one has it, the next free."""
    slots: dict[str, int] = {}
    count = len(theme.hues)
    for own in dict.fromkeys(families):
        wish = zlib.crc32(own.encode()) % count
        taken = set(slots.values())
        slots[own] = next((k for i in range(count) if (k := (wish + 3 * i) % count) not in taken), wish)
    return {own: (theme.hues[slot], theme.lighter[slot]) for own, slot in slots.items()}


def _base_color(kind: int, hue: tuple[float, float], rank: int, size: int, theme: Theme) -> Color:
    """Hue by family; a large one sweeps across neighbouring hues, and members differ a little."""
    if kind == STATIC:
        return theme.static
    if kind == KINEMATIC:
        return theme.kinematic
    sweep = theme.sweep * min(size / 30.0, 1.0) * (rank / size - 0.5)
    jitter = theme.jitter * _scatter(rank, 0.6180339887)
    lightness = theme.lightness + hue[1] + 0.06 * _scatter(rank, 0.7548776662)
    return oklch_to_srgb(lightness, theme.chroma, hue[0] + sweep + jitter)


def _scatter(rank: int, ratio: float) -> float:
    """A number in -0.5..0.5 that differs most between neighbouring ranks; 0 for the first."""
    return (rank * ratio + 0.5) % 1.0 - 0.5


def frame_colors(frame: Frame, body_colors: BodyColors) -> FrameColors:
    """The colours of a frame: sleeping bodies dimmed, frozen bodies red and hatched."""
    theme = body_colors.theme
    fill = body_colors.base.copy()
    fill[frame.frozen] = theme.frozen
    asleep = ~frame.awake & ~frame.frozen & (frame.type == DYNAMIC)
    fill[asleep] = mix(fill[asleep], theme.background, theme.sleep)
    edge = mix(fill, theme.light, theme.outline)
    edge[frame.type == STATIC] = mix(fill[frame.type == STATIC], theme.light, theme.static_outline)
    mark = mix(fill, theme.ink, 0.55)
    return FrameColors(fill, edge, mark, frame.frozen.astype(np.float64))


def mix(colors: Floats, other: Color, amount: float) -> Floats:
    """Colours (k, 3) moved towards `other` by `amount` 0..1."""
    return np.asarray(colors) * (1.0 - amount) + np.asarray(other) * amount
