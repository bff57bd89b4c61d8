"""A film as the data of a page."""

from __future__ import annotations

import base64
import json
import math
import zlib
from typing import Any

import numpy as np

from sandbox.report.film import Film
from sandbox.report.pack import pack
from sandbox.report.toggles import toggles
from sandbox.tables import Floats


def packed(data: dict[str, Any]) -> str:
    """The data of a film in few bytes: two lines of base64 of deflated bytes, JSON without the poses, and the poses.

    Nothing in it can be taken for markup.
    """
    facts = {name: value for name, value in data.items() if name != "poses"}
    text = json.dumps(facts, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return f"{base64.b64encode(zlib.compress(text.encode(), 9)).decode('ascii')}\n{data['poses']}"


def film_data(film: Film) -> dict[str, Any]:
    """Everything that the player needs of a film, as plain data."""
    there = ~np.isnan(film.poses[:, :, 0])
    poses = _filled(film.poses, there)
    quanta = np.array([[body.quantum, body.quantum, body.turn] for body in film.bodies]).reshape(-1, 3)
    switches = zip(toggles(there), toggles(film.awake), toggles(film.frozen), strict=True)
    bodies = [
        {**body.data, "from": first, "quantum": [body.quantum, body.turn], "there": known, "awake": awake}
        | ({"frozen": frozen} if frozen else {})
        for body, first, (known, awake, frozen) in zip(film.bodies, poses[:, 0].tolist(), switches, strict=True)
    ]
    return {
        "start": film.start,
        "end": film.end,
        "every": film.every,
        "rate": film.step_rate,
        "view": list(film.view),
        "bodies": bodies,
        "joints": [{**joint, "held": held} for joint, held in zip(film.joints, toggles(film.held), strict=True)],
        "fields": [list(entry) for entry in film.fields],
        "score": [list(entry) for entry in film.score],
        "commands": [list(entry) for entry in film.commands],
        "cut": film.cut,
        "energy": [_finite(row.energy) for row in film.figures],
        "deepest": [_finite(row.deepest) for row in film.figures],
        "contacts": [row.contacts for row in film.figures],
        "awake": [row.awake for row in film.figures],
        "poses": pack(poses, quanta) if len(poses) else "",
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _filled(poses: Floats, there: Any) -> Floats:
    """Poses of bodies that are not there: where they come first, or were last; numbers beyond measure are cut."""
    filled = np.nan_to_num(poses, nan=0.0, posinf=1e15, neginf=-1e15)
    samples = np.arange(poses.shape[1])
    for k in np.flatnonzero(~there.all(axis=1)):
        known = samples[there[k]]
        nearest = known[np.clip(np.searchsorted(known, samples, side="right") - 1, 0, None)]
        filled[k] = filled[k, nearest]
    return filled
