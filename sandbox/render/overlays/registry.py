"""All overlays by name, and what draws several of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from sandbox.errors import ArgumentError
from sandbox.render.label import place_labels
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
    velocities,
)
from sandbox.render.overlays.legend import legend_card
from sandbox.render.overlays.look import Look, Overlay
from sandbox.scene.near_names import did_you_mean

_MODULES = (
    outlines, boxes, grid, pairs, contacts, impulses, separations, features, centers, velocities, joints, islands,
    colors, levels, sleep, sensors, sweeps,
)  # fmt: skip
OVERLAYS: Mapping[str, Overlay] = {module.OVERLAY.name: module.OVERLAY for module in _MODULES}
"""Every overlay by its name, in the order in which menus list them and pictures lay them on each other."""


def find_overlay(name: str) -> Overlay:
    """The overlay of that name. Raises `ArgumentError` with the nearest name."""
    if name not in OVERLAYS:
        hint = did_you_mean(name, OVERLAYS) or f"there are {', '.join(OVERLAYS)}"
        raise ArgumentError(f"no overlay {name!r}; {hint}")
    return OVERLAYS[name]


def draw_overlays(shown: Sequence[Overlay], look: Look, legend: bool = True) -> tuple[Marks, ...]:
    """The layers of all overlays `shown`, for a draw list; the last one says what the colours mean, if `legend`.

    Nothing is looked at if none is shown, and there are no marks if bodies have come or gone since the frame. Only
    labels that have room are left; they are all in the last layer.
    """
    if not shown or look.frame.mesh.layout != look.world.layout:
        return ()
    layers = [overlay.draw(look) for overlay in shown]
    card, taken = legend_card([entry for layer in layers for entry in layer.legend], look) if legend else (Marks(), ())
    labels = place_labels([label for layer in layers for label in layer.labels], look.camera.size, taken)
    return (*(replace(layer, labels=()) for layer in layers), replace(card, labels=[*card.labels, *labels]))
