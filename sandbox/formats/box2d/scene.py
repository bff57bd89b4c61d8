"""A Box2D world as a scene."""

from __future__ import annotations

from sandbox.formats.box2d.bodies import body_words
from sandbox.formats.box2d.joints import joint_words
from sandbox.formats.box2d.world import Body, Joint, World
from sandbox.formats.draft import Draft
from sandbox.formats.numbers import tidy, tidy_point
from sandbox.formats.outlines import Words


def write_world(world: World, draft: Draft) -> None:
    """Bring bodies and joints into the draft, in the order of the file."""
    settings: Words = {"restitution_threshold": tidy(world.restitution_threshold), **world.settings}
    if world.step_rate:
        settings["step_rate"] = tidy(min(max(world.step_rate, 1.0), 1e4))
    if not world.sleeping:
        settings["sleeping"] = False
    if not world.warm_starting:
        settings["warm_starting"] = False
    draft.fields |= {"gravity": tidy_point(world.gravity), "settings": settings}
    _Writer(world, draft).write()


class _Writer:
    def __init__(self, world: World, draft: Draft) -> None:
        self._world, self._draft = world, draft
        self._ids: dict[int, str | None] = {}
        self._joint_ids: dict[int, str] = {}

    def write(self) -> None:
        world, draft = self._world, self._draft
        held = {number for joint in world.joints for number in (joint.a, joint.b)}
        for number, body in enumerate(world.bodies):
            self._write_body(number, body, number in held)
        gears = [(number, joint) for number, joint in enumerate(world.joints) if joint.kind == "gear"]
        for number, joint in enumerate(world.joints):
            if joint.kind != "gear" and (words := self._words(joint)):
                self._joint_ids[number] = draft.add_joint(joint.name, words)
        for _, joint in gears:
            self._write_gear(joint)

    def _write_body(self, number: int, body: Body, held: bool) -> None:
        if not body.active:
            self._draft.remarks.note(body.place, "a body that is not active is left out")
            return
        words = body_words(body, self._draft.remarks) if body.fixtures or held else None
        self._ids[number] = self._draft.add_body(body.name, words) if words else None
        if words is None and not (held and body.type == "static"):
            self._draft.remarks.note(body.place, "a body without shapes is left out")

    def _words(self, joint: Joint) -> Words | None:
        if not (joint.a in self._ids and joint.b in self._ids):
            self._draft.remarks.note(joint.place, "a joint is left out: one of its bodies is not there")
            return None
        a, b = (self._world.bodies[number] for number in (joint.a, joint.b))
        if joint.a == joint.b or "dynamic" not in (a.type, b.type):
            self._draft.remarks.note(joint.place, "a joint between bodies neither of which can be moved is left out")
            return None
        words = joint_words(joint, a, b, self._draft.remarks)
        if words is None:
            return None
        ends = [self._ids[joint.b]] if words["type"] == "target" else [self._ids[joint.a], self._ids[joint.b]]
        return {"type": words["type"], "bodies": ends, **words}

    def _write_gear(self, joint: Joint) -> None:
        coupled = [self._joint_ids.get(number) for number in joint.joints]
        kinds = ("revolute", "prismatic", "wheel")
        known = {each["id"]: each["type"] for each in self._draft.joints}
        if any(name is None or known[name] not in kinds for name in coupled) or coupled[0] == coupled[1]:
            self._draft.remarks.note(joint.place, "a gear is left out: it couples two hinges, slides or wheels")
            return
        self._draft.add_joint(joint.name, {"type": "gear", "joints": coupled, "ratio": tidy(joint.ratio)})
