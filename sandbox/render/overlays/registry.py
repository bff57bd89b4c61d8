"""All overlays by name, and what draws several of them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from sandbox.errors import ArgumentError
from sandbox.render.label import Box, place_labels
from sandbox.render.marks import Marks
from sandbox.render.overlays import (
    boxes,
    centers,
    colors,
    contacts,
    features,
    grid,
    impulses,
    islands,
    joints,
    levels,
    outlines,
    pairs,
    sensors,
    separations,
    sleep,
    sweeps,
    trails,
    velocities,
)
from sandbox.render.overlays.legend import Corner, legend_card
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.sat import SAT, sat_overlay
from sandbox.scene.near_names import did_you_mean

_MODULES = (
    outlines, boxes, grid, pairs, contacts, impulses, separations, features, centers, velocities, joints, islands,
    colors, levels, sleep, sensors, sweeps, trails,
)  # fmt: skip
OVERLAYS: Mapping[str, Overlay] = {module.OVERLAY.name: module.OVERLAY for module in _MODULES}
"""Every overlay by its name, in the order in which menus list them and pictures lay them on each other."""


def find_overlay(text: str, bodies: Collection[str] = ()) -> Overlay:
    """The overlay of a name, or of `sat:A:B` for two of the `bodies`.

    Raises `ArgumentError` with the nearest name.
    """
    name, _, rest = text.partition(":")
    if name == SAT:
        return sat_overlay(_two_bodies(text, rest, bodies))
    if text not in OVERLAYS:
        names = [*OVERLAYS, f"{SAT}:A:B"]
        hint = did_you_mean(text, names) or f"there are {', '.join(names)}"
        raise ArgumentError(f"no overlay {text!r}; {hint}")
    return OVERLAYS[text]


def _two_bodies(text: str, rest: str, bodies: Collection[str]) -> tuple[str, str]:
    """The ids in `A:B`; they may have colons of their own."""
    parts = rest.split(":")
    pairs = [(":".join(parts[:k]), ":".join(parts[k:])) for k in range(1, len(parts))]
    pair = next((pair for pair in pairs if pair[0] in bodies and pair[1] in bodies), pairs[0] if pairs else None)
    if pair is None or not all(pair):
        raise ArgumentError(f"the overlay {text!r} needs two bodies: {SAT}:A:B")
    for name in pair:
        if name not in bodies:
            hint = did_you_mean(name, bodies) or f"it has {', '.join(list(bodies)[:5])}{' ...' * (len(bodies) > 5)}"
            raise ArgumentError(f"the overlay {text!r}: no body {name!r} in this scene; {hint}")
    if pair[0] == pair[1]:
        raise ArgumentError(f"the overlay {text!r}: a body does not collide with itself; name two")
    return pair


def draw_overlays(
    shown: Sequence[Overlay], look: Look, corner: Corner | None = "lower left", taken: Sequence[Box] = ()
) -> tuple[Marks, ...]:
    """The layers of all overlays `shown`, for a draw list; the last one says in a `corner` what the colours mean.

    Nothing is looked at if none is shown, and there are no marks if bodies have come or gone since the frame. Only
    labels that have room are left; they are all in the last layer.
    """
    if not shown or look.frame.mesh.layout != look.world.layout:
        return ()
    layers = [overlay.draw(look) for overlay in shown]
    entries = [entry for layer in layers for entry in layer.legend] if corner else []
    card, room = legend_card(entries, look, corner or "lower left")
    labels = place_labels([label for layer in layers for label in layer.labels], look.camera.size, [*taken, *room])
    return (*(replace(layer, labels=()) for layer in layers), replace(card, labels=[*card.labels, *labels]))
