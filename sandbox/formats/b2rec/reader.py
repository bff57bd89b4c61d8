"""Recordings of Box2D v3: what was made, and changed, before the first step is the scene; what follows is listed."""

from __future__ import annotations

from collections import Counter
from typing import Any

from sandbox.formats.b2rec.bodies import body_of
from sandbox.formats.b2rec.calls import Call, calls
from sandbox.formats.b2rec.header import MAGIC, read_head
from sandbox.formats.b2rec.joints import joint_of
from sandbox.formats.b2rec.session import Session
from sandbox.formats.box2d.scene import write_world
from sandbox.formats.box2d.world import World
from sandbox.formats.draft import Draft
from sandbox.formats.numbers import tidy
from sandbox.formats.reading import MisreadError
from sandbox.formats.remarks import Remarks
from sandbox.scene.limits import MAX_BODIES, MAX_SUBSTEPS


def is_b2rec(data: Any) -> bool:
    """Whether this is a recording of Box2D."""
    return isinstance(data, bytes) and data.startswith(MAGIC)


def read_b2rec(data: bytes, draft: Draft) -> None:
    """Bring all that the first step begins with into the draft. Raises `MisreadError`."""
    head = read_head(data)
    session, first, later = Session(dict(head.settings)), None, Counter[str]()
    for call in calls(data, head):
        if first is None and call.name == "Step":
            first = call
        elif first is None and call.changes:
            session.apply(call)
            if len(session.bodies) > MAX_BODIES:
                raise MisreadError((), f"more than {MAX_BODIES} bodies are made, the limit of a scene")
        elif call.changes:
            later[call.name] += 1
    session.finish(first.arguments["dt"] if first else 0.0)
    _count("calls before the first step that are left out", session.unused, draft.remarks)
    _count("calls after the first step that are left out", later, draft.remarks)
    write_world(_world(session, first, head.length_scale, draft.remarks), draft)


def _count(what: str, found: Counter[str], remarks: Remarks) -> None:
    if found:
        remarks.note("", f"{what}: {', '.join(f'{count} {name}' for name, count in sorted(found.items()))}")


def _world(session: Session, first: Call | None, units: float, remarks: Remarks) -> World:
    settings = session.settings
    for values, name in (
        (settings, "restitutionThreshold"),
        (settings, "contactSpeed"),
        *((made.values, "sleepThreshold") for made in session.bodies.values()),
    ):
        values[name] /= units  # there in units of length a second, here in m/s
    on: dict[int, list[Any]] = {body: [] for body in session.bodies}
    for shape in (*session.shapes.values(), *session.chains.values()):
        on[shape.body].append(shape)
    numbers = {body: number for number, body in enumerate(session.bodies)}
    bodies = [body_of(made, on[key], numbers[key], remarks) for key, made in session.bodies.items()]
    world = World(
        gravity=settings["gravity"],
        sleeping=settings["sleeping"],
        warm_starting=settings["warmStarting"],
        restitution_threshold=settings["restitutionThreshold"],
        bodies=bodies,
        joints=[joint_of(each, n, numbers, bodies, remarks) for n, each in enumerate(session.joints.values())],
    )
    if not settings["speculative"]:
        world.settings["speculative"] = False
    tuning = {
        "contact_hertz": ("contactHertz", 30.0), "contact_damping_ratio": ("contactDampingRatio", 10.0),
        "push_out_speed": ("contactSpeed", 3.0),
    }  # fmt: skip
    if units != 1.0:
        world.settings["units_per_meter"] = tidy(units)
    changed = {here: settings[there] for here, (there, usual) in tuning.items() if settings[there] != usual}
    world.settings |= {here: tidy(value) for here, value in changed.items()}
    if first is not None and first.arguments["dt"] > 0.0:
        world.step_rate = round(1.0 / first.arguments["dt"], 3)
        world.settings["substeps"] = min(max(first.arguments["subStepCount"], 1), MAX_SUBSTEPS)
    return world
