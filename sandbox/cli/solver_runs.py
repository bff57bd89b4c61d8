"""The ways in which `sandbox solver` solves a scene: as the scene has it, and one for each `--vary`."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sandbox.errors import SandboxError
from sandbox.reference.simple.techniques import SWITCHES, Techniques
from sandbox.scene.flat import FlatScene
from sandbox.scene.near_names import did_you_mean

_COUNTS = {"substeps": 64, "iterations": 1000}
"""Techniques that are numbers, and the most that each may be."""
_ON = {"on": True, "off": False}


def runs_of(scene: FlatScene, vary: list[str], iterations: int) -> list[tuple[str, Techniques]]:
    """(label, techniques) of the scene as it is, then of each variation. Raises `SandboxError`."""
    usual = replace(Techniques.of(scene), iterations=iterations)
    return [("as the scene has it", usual), *((label_of(text), _varied(usual, text)) for text in vary)]


def label_of(text: str) -> str:
    """`soft=off,substeps=1` for people."""
    parts = (part.strip().partition("=") for part in text.split(","))
    return ", ".join(f"{name} {value}" for name, _, value in parts).replace("_", " ")


def _varied(usual: Techniques, text: str) -> Techniques:
    changes: dict[str, Any] = {}
    for part in text.split(","):
        name, _, value = (each.strip() for each in part.partition("="))
        changes[name] = _value(text, name, value)
    return replace(usual, **changes)


def _value(text: str, name: str, value: str) -> bool | int:
    if name in SWITCHES:
        if value not in _ON:
            raise SandboxError(f"--vary {text}: {name} is on or off, such as {name}=off")
        return _ON[value]
    if name not in _COUNTS:
        known = (*SWITCHES, *_COUNTS)
        hint = did_you_mean(name, known) or f"there are {', '.join(known)}"
        raise SandboxError(f'--vary {text}: no technique is called "{name}"; {hint}')
    if not value.isascii() or not value.isdigit() or not 1 <= int(value[:9]) <= _COUNTS[name] or len(value) > 9:
        raise SandboxError(f"--vary {text}: {name} is a whole number from 1 to {_COUNTS[name]}")
    return int(value)
