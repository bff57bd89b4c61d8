"""What can be plotted: of the world as a whole, and of one body."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sandbox.engine.world import World
from sandbox.tables import plain
from sandbox.window.stage_times import STAGES
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


@dataclass(frozen=True)
class Chart:
    """One picture of lines with a unit in common. `lines` are names of quantities and what they are called in it."""

    name: str
    title: str
    unit: str
    lines: tuple[tuple[str, str], ...]
    tip: str
    of_body: bool = False


CHARTS = (
    Chart("energy", "Energy", "J", (("kinetic", "kinetic"), ("potential", "potential"), ("energy", "total")),
          "Of dynamic bodies; potential energy is zero at the world's origin. Springs and zones are left out."),
    Chart("momentum", "Momentum", "kg m/s", (("momentum_x", "x"), ("momentum_y", "y")), "Of all dynamic bodies."),
    Chart("spin", "Angular momentum", "kg m²/s", (("spin", "about the origin"),), "Of all dynamic bodies."),
    Chart("overlap", "Deepest overlap", "mm", (("overlap", "deepest"),), "Of all contacts, when the step began."),
    Chart("contacts", "Contacts", "", (("contacts", "in the table"), ("touching", "touching")), "How many there are."),
    Chart("awake", "Awake bodies", "", (("awake", "awake"),), "Dynamic bodies that are awake."),
    Chart("cost", "Time a step", "ms", (("cost", "step"), *((name, title) for name, (title, _) in STAGES.items())),
          "What a step took this computer, and its stages."),
    Chart("position", "Position", "m", (("x", "x"), ("y", "y")), "Origin of the selected body.", True),
    Chart("angle", "Angle", "°", (("angle", "angle"),), "Of the selected body, turned so far.", True),
    Chart("velocity", "Velocity", "m/s", (("vx", "x"), ("vy", "y"), ("speed", "speed")), "Of the selected body.", True),
    Chart("rotation", "Angular velocity", "°/s", (("w", "spin"),), "Of the selected body.", True),
    Chart("body_energy", "Energy of motion", "J", (("motion", "kinetic"),), "Of the selected body.", True),
)  # fmt: skip
WORLD = tuple(name for chart in CHARTS if not chart.of_body for name, _ in chart.lines)
BODY = tuple(name for chart in CHARTS if chart.of_body for name, _ in chart.lines)


def world_values(world: World, cost: float, stages: dict[str, float]) -> list[float]:
    """The values of `WORLD` now. `cost` is what the step took, in seconds; `stages` are in ms."""
    contacts = world.contacts
    values = mechanics(world.state) | {
        "overlap": 1000.0 * deepest(contacts),
        "contacts": float(len(contacts)),
        "touching": float(np.count_nonzero(contacts.touching)),
        "awake": float(world.awake_count),
        "cost": 1000.0 * cost,
    }
    return [values.get(name, stages.get(name, math.nan)) for name in WORLD]


def mechanics(state: State) -> dict[str, float]:
    """Energies (J), momentum (kg m/s) and angular momentum about the origin (kg m^2/s) of the dynamic bodies."""
    table = plain(state.bodies)
    rows = table[table["type"] == DYNAMIC]
    setting = state.settings[0]
    mass, inertia, spin = rows["mass"], rows["inertia"], rows["angular_velocity"]
    x, y, vx, vy = (rows[name] for name in ("center_x", "center_y", "velocity_x", "velocity_y"))
    kinetic = float(0.5 * (mass * (vx * vx + vy * vy) + inertia * spin * spin).sum())
    lift = float(setting.gravity_x) * x + float(setting.gravity_y) * y
    potential = -float((mass * rows["gravity_scale"] * lift).sum())
    return {
        "kinetic": kinetic, "potential": potential, "energy": kinetic + potential,
        "momentum_x": float((mass * vx).sum()), "momentum_y": float((mass * vy).sum()),
        "spin": float((mass * (x * vy - y * vx) + inertia * spin).sum()),
    }  # fmt: skip


def deepest(contacts: np.recarray) -> float:
    """The deepest overlap of contacts, m; 0 without one."""
    two = np.where(contacts.point_count > 1, contacts.separation2, 0.0)
    return max(0.0, -float(min(contacts.separation1.min(initial=0.0), two.min(initial=0.0))))


def body_values(world: World, row: int) -> list[float]:
    """The values of `BODY` now, of the body in that row."""
    body = plain(world.state.bodies)[row]
    vx, vy, spin = float(body["velocity_x"]), float(body["velocity_y"]), float(body["angular_velocity"])
    square = vx * vx + vy * vy
    values = {
        "x": float(body["position_x"]), "y": float(body["position_y"]), "angle": math.degrees(body["angle"]),
        "vx": vx, "vy": vy, "speed": math.sqrt(square), "w": math.degrees(spin),
        "motion": 0.5 * float(body["mass"] * square + body["inertia"] * spin * spin),
    }  # fmt: skip
    return [values[name] for name in BODY]
