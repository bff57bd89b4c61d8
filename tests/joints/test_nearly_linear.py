"""Hinges that can hardly miss their aim are not looked at again: the same bits as when all are."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.world.digest import digest
from tests.examples import examples
from tests.flat import body, box
from tests.joints.jointed import joint, jointed
from tests.joints.lanes import some_part_is_separated

SPEED = st.sampled_from([0.0, 0.5, 3.0, 20.0, 90.0])


@st.composite
def chains(draw: st.DrawFn) -> list[tuple[float, float, float]]:
    """The velocities of up to six planks, from rest to far too fast for a substep."""
    speeds = draw(st.lists(st.tuples(SPEED, SPEED, SPEED), min_size=2, max_size=6))
    signs = draw(st.lists(st.sampled_from([-1.0, 1.0]), min_size=3 * len(speeds), max_size=3 * len(speeds)))
    return [(x * signs[3 * k], y * signs[3 * k + 1], w * signs[3 * k + 2]) for k, (x, y, w) in enumerate(speeds)]


def chain(speeds: list[tuple[float, float, float]]) -> World:
    """Such a chain, and one like it that is put down at rest and shares its batch."""
    planks, joints = [], []
    for name, share, height in (("p", 1.0, 0.0), ("q", 0.0, 50.0)):
        for k, (x, y, w) in enumerate(speeds):
            fast = {"velocity": (share * x, share * y), "angular_velocity": share * w}
            planks.append(body(f"{name}{k}", box(1.0, 0.2, mask=0), position=(k + 0.5, height), **fast))
            kind, before = "weld" if k % 3 == 2 else "revolute", f"{name}{k - 1}" if k else None
            joints.append(joint(f"{name}j{k}", kind, before, f"{name}{k}", (float(k), height)))
    return jointed(tuple(planks), tuple(joints))


@given(chains())
@examples(60)
def test_what_is_surely_met_is_not_missed(speeds):
    world, judge = chain(speeds), chain(speeds)
    assert world.scratch.joints.direct.layouts.hinged.tolist() == [1]
    judge.scratch.joints.direct.layouts.hinged[:] = 0
    for step in range(30):
        world.step()
        judge.step()
        assert some_part_is_separated(world) == some_part_is_separated(judge), step
        assert digest(world.state) == digest(judge.state), step
