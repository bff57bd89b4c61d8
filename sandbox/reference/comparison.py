"""A scene run and checked: every pair of every step is decided a second time by pymunk."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from sandbox.engine.narrow_phase.examine_pair import FACE_BIAS
from sandbox.engine.world import World
from sandbox.reference.answer import Answer
from sandbox.reference.arbitration import arbitrate
from sandbox.reference.ask_pymunk import Answers, Probe
from sandbox.reference.brute_force import not_joined, overlapping_pairs, that_matter
from sandbox.reference.compare_answers import ComparedPairs, compare_answers, find_rows
from sandbox.reference.comparison_result import KEEP, Comparison, Disagreement, Miss
from sandbox.reference.decide import decide
from sandbox.reference.poses import Poses
from sandbox.reference.tolerance import ROUNDING
from sandbox.scene import Scene
from sandbox.scene.flat import FlatScene
from sandbox.tables import Floats, Integers

_REPORT_EVERY = 16


def compare(
    scene: Scene | FlatScene, steps: int, every: int = 1, on_steps: Callable[[int], None] | None = None, first: int = 1
) -> Comparison:
    """Run `scene` for `steps` steps and hold every `every`-th, from step `first` on, against pymunk.

    A step decides on the poses at its beginning, so step 1 is about the scene as it was written. `on_steps` hears now
    and then how many steps are done.
    """
    world = World(scene)
    observer = Observer(world)
    for k in range(1, steps + 1):
        if k >= first and (k - first) % every == 0:
            observer.step()
        else:
            world.step()
        if on_steps is not None and k % _REPORT_EVERY == 0:
            on_steps(k)
    return observer.tally


class Observer:
    """Steps a world and compares; `tally` is what came of it so far."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.tally = Comparison()
        self._roster = world.names
        self._probe = Probe(self._poses(), world.state.vertices)

    def _poses(self) -> Poses:
        state = self.world.state
        return Poses.of(state.bodies, state.shapes, state.vertices)

    def step(self) -> None:
        """One step of the world, compared, unless bodies came or went at its end."""
        poses = self._poses()
        if self.world.names != self._roster:
            self._roster = self.world.names
            self._probe = Probe(poses, self.world.state.vertices)
        # A joint that breaks in the step still keeps its bodies apart in it.
        bonds = self.world.scratch.joint_filter.bonds.copy()
        self.world.step()
        if self.world.names != self._roster:
            return  # rules have brought bodies or taken some away since: the tables are no longer those of the step
        self.tally.steps += 1
        candidates = that_matter(overlapping_pairs(self._search_boxes(poses)), poses.bodies, poses.shapes)
        candidates = not_joined(candidates, bonds, poses.shapes)
        self._note_misses(candidates)
        pairs = candidates[_overlap(poses.boxes[candidates[:, 0]], poses.boxes[candidates[:, 1]])]
        if len(pairs):
            self._compare_pairs(poses, pairs)

    def _search_boxes(self, poses: Poses) -> Floats:
        """The step's own boxes, which cover margins and ways, widened where a shape sticks out of its box."""
        rows: Any = self.world.scratch.colliders.boxes[: len(poses.shapes)]
        boxes = np.stack([rows.lower_x, rows.lower_y, rows.upper_x, rows.upper_y], axis=1)
        tight, slack = poses.boxes, ROUNDING * np.abs(poses.boxes).max(axis=1, keepdims=True, initial=0.0)
        lower, upper = tight[:, :2] + slack, tight[:, 2:] - slack
        return np.concatenate([np.minimum(boxes[:, :2], lower), np.maximum(boxes[:, 2:], upper)], axis=1)

    def _note_misses(self, candidates: Integers) -> None:
        rows: Any = self.world.scratch.grid.pairs[: int(self.world.state.counters[0].pair_count)]
        proposed = np.stack([rows.shape_a, rows.shape_b], axis=1)
        missed = candidates[find_rows(candidates, proposed, len(self.world.state.shapes)) < 0]
        self.tally.missed += len(missed)
        for a, b in missed[: KEEP - len(self.tally.misses)].tolist():
            self.tally.misses.append(Miss(self.world.step_count, self._names(a, b), (a, b)))

    def _compare_pairs(self, poses: Poses, pairs: Integers) -> None:
        separation, normal = decide(poses, pairs)
        theirs = self._probe.ask(poses, pairs)
        bias = FACE_BIAS * float(self.world.state.settings[0].units_per_meter)
        compared = compare_answers(poses, pairs, separation, normal, theirs, self.world.contacts, bias)
        tally = self.tally
        tally.pairs += len(pairs)
        tally.agreed += int(compared.agreed.sum())
        tally.touching += int(compared.touching.sum())
        tally.other_axis += compared.other_axis
        tally.depth_error = max(tally.depth_error, compared.depth_error)
        tally.normal_error = max(tally.normal_error, compared.normal_error)
        for found in self._open(poses, pairs, separation, normal, theirs, compared):
            self._note(found)

    def _open(
        self,
        poses: Poses,
        pairs: Integers,
        separation: Floats,
        normal: Floats,
        theirs: Answers,
        compared: ComparedPairs,
    ) -> Iterator[Disagreement]:
        """Every pair left open, with what the third referee says of it."""
        for k in np.flatnonzero(~(compared.agreed | compared.touching)).tolist():
            a, b = pairs[k].tolist()
            pair = poses.pair(a, b)
            ours = Answer.ours(float(separation[k]), (float(normal[k, 0]), float(normal[k, 1])))
            contact = (float(theirs.depth[k]), (float(theirs.normal[k, 0]), float(theirs.normal[k, 1])))
            other = Answer.theirs(contact if theirs.hit[k] else None)
            what = "no contact" if compared.no_contact[k] else "contact axis" if compared.wrong_axis[k] else ""
            what = what or ("verdict" if theirs.hit[k] != (separation[k] < 0.0) else "depth or axis")
            ruling = arbitrate(pair, ours, other)
            yield Disagreement(self.world.step_count, what, self._names(a, b), (a, b), pair, ours, other, ruling)

    def _note(self, found: Disagreement) -> None:
        wrong, trap = found.who_is_wrong, found.ruling.trap
        if wrong == "nobody":
            self.tally.agreed += 1
            return
        if wrong == "pymunk" and trap is not None:
            self.tally.pymunk_wrong[trap.name] += 1
            return
        self.tally.disagreed += 1
        if len(self.tally.disagreements) < KEEP:
            self.tally.disagreements.append(found)

    def _names(self, a: int, b: int) -> tuple[str, str]:
        owner = self.world.state.shapes.body
        return self.world.names[owner[a]], self.world.names[owner[b]]


def _overlap(a: Floats, b: Floats) -> Any:
    """Whether boxes share a point, row by row."""
    return ((a[:, :2] <= b[:, 2:]) & (b[:, :2] <= a[:, 2:])).all(axis=1)
