"""From a scene to its flat form: prefabs, materials, generators and defaults expanded, degrees to radians."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace
from typing import Any

from sandbox.geometry.decompose import decompose
from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.arrange import chain_step, placings
from sandbox.scene.body import Body, BodyFields
from sandbox.scene.colors import hex_color
from sandbox.scene.finding import Finding, Path
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, FlatSettings, FlatShape
from sandbox.scene.flat_joints import chain_joints, flat_joint, joint_faults
from sandbox.scene.flat_rules import FlatAction, FlatCounter, FlatSpawn
from sandbox.scene.flat_shapes import flat_shapes
from sandbox.scene.generators import Chain, Generator, body_count, body_names, kind_of
from sandbox.scene.known import NOTHING, Known
from sandbox.scene.limits import MAX_ALIKE, MAX_SHAPES
from sandbox.scene.play.actions import Action, SpawnBody
from sandbox.scene.play.flatten_play import flat_controls, flat_rules
from sandbox.scene.prefab import Prefab
from sandbox.scene.scene_fields import SceneFields
from sandbox.scene.shapes import PolygonShape
from sandbox.scene.solidity import faults
from sandbox.scene.units import guessed_units

_FARTHEST = 1e9
_FIELDS = tuple(BodyFields.model_fields)
_SAME = [
    "type", "velocity", "linear_damping", "angular_damping", "gravity_scale", "fixed_rotation", "sleep_speed", "bullet",
    "mass", "inertia", "center",
]  # fmt: skip


class Flattener:
    """Expands one scene, which may refer to what is `known`; `findings` collects mistakes that show only now."""

    def __init__(self, scene: SceneFields, known: Known = NOTHING) -> None:
        self.scene = scene
        self._known = known
        self.findings: list[Finding] = []
        self._crowded = 0
        self._shapes: dict[tuple[int, str | None], tuple[FlatShape, ...]] = {}

    def flat(self) -> FlatScene:
        """The flat scene; use it only if `findings` stays empty."""
        if self._too_many_shapes():
            return FlatScene(())
        settings = {field.name: getattr(self.scene.settings, field.name) for field in fields(FlatSettings)}
        settings["units_per_meter"] = settings["units_per_meter"] or guessed_units(self.scene.gravity)
        bodies = (*self._written(), *self._generated())
        joints = (*self._written_joints(), *self._chained())
        regions = tuple(region.flat() for region in self.scene.regions)
        self.findings += joint_faults(joints, bodies, self._known)
        counters = tuple(FlatCounter(name, value) for name, value in self.scene.counters.items())
        play = counters, flat_controls(self.scene.controls, self._action), flat_rules(self.scene.rules, self._action)
        return FlatScene(bodies, self.scene.gravity, FlatSettings(**settings), joints, regions, *play)

    def _action(self, action: Action, path: Path) -> FlatAction:
        """An action in plain values; what it brings is read as a body of the scene is."""
        flat = action.flat()
        if not isinstance(flat, FlatSpawn) or not isinstance(action, SpawnBody):
            return flat
        entry = action.spawn
        traits = self._traits(self._merged(entry), (*path, "spawn"))
        return replace(flat, body=FlatBody(id=entry.id, position=entry.position, **traits))

    def _too_many_shapes(self) -> bool:
        own = self._known.shapes + sum(_part_count(self._shapes_of(body)) for body in self.scene.bodies)
        made = sum(body_count(each) * _part_count(self._prefab(each).shapes) for each in self.scene.generate)
        if own + made > MAX_SHAPES:
            text = f"the scene has {own + made} shapes; {MAX_SHAPES} is the limit"
            self.findings.append(Finding(("generate",) if made > own else ("bodies",), text))
        return own + made > MAX_SHAPES

    def _shapes_of(self, body: Body) -> tuple[Any, ...]:
        own = body.prefab is None or "shapes" in body.model_fields_set
        return body.shapes if own else self.scene.prefabs[str(body.prefab)].shapes

    def _written(self) -> Iterator[FlatBody]:
        for i, body in enumerate(self.scene.bodies):
            values = self._merged(body)
            traits = self._traits(values, ("bodies", i))
            yield FlatBody(id=body.id, position=body.position, prefab=body.prefab or "", **traits)

    def _generated(self) -> Iterator[FlatBody]:
        for i, generator in enumerate(self.scene.generate):
            if self._crowded >= MAX_ALIKE:  # the scene is refused anyway
                return
            prefab = self._prefab(generator)
            traits = self._traits(_values(prefab), ("generate", i))
            traits["prefab"] = getattr(generator, kind_of(generator))
            places = placings(generator, traits["shapes"], prefab.angle)
            self._check_places(generator, places, ("generate", i))
            for name, (x, y, degrees) in zip(body_names(generator), places, strict=False):
                if degrees is not None:
                    traits["angle"] = degrees * RADIANS_PER_DEGREE
                yield FlatBody(id=name, position=(x, y), **traits)

    def _written_joints(self) -> Iterator[FlatJoint]:
        return (flat_joint(joint, i) for i, joint in enumerate(self.scene.joints))

    def _chained(self) -> Iterator[FlatJoint]:
        for i, generator in enumerate(self.scene.generate):
            if isinstance(generator, Chain):
                prefab = self._prefab(generator)
                shapes = self._flat_shapes(prefab.shapes, prefab.material)
                yield from chain_joints(generator, chain_step(generator, shapes), i)

    def _check_places(self, generator: Generator, places: list[Any], path: Path) -> None:
        wanted = body_count(generator)
        if len(places) < wanted:
            self._crowded += 1
            text = f"only {len(places)} of {wanted} bodies fit"
            self.findings.append(Finding(path, text, 'widen "inside", or give a smaller "apart"'))
        if any(max(abs(x), abs(y)) > _FARTHEST for x, y, _ in places):
            self.findings.append(Finding(path, f"some bodies lie farther than {_FARTHEST:g} m from the origin"))

    def _prefab(self, generator: Generator) -> Prefab:
        return self.scene.prefabs[getattr(generator, kind_of(generator))]

    def _merged(self, body: Body) -> dict[str, Any]:
        """A body's fields: its own, else its prefab's, else the defaults."""
        if body.prefab is None:
            return _values(body)
        return {**_values(self.scene.prefabs[body.prefab]), **body.given()}

    def _traits(self, values: dict[str, Any], path: Path) -> dict[str, Any]:
        """The fields of a flat body that do not depend on where it is; adds what is wrong with them."""
        traits = {name: values[name] for name in _SAME}
        traits["color"] = None if values["color"] is None else hex_color(values["color"])
        traits["shapes"] = self._flat_shapes(values["shapes"], values["material"])
        traits["angle"] = values["angle"] * RADIANS_PER_DEGREE
        traits["angular_velocity"] = values["angular_velocity"] * RADIANS_PER_DEGREE
        traits["path"] = None if values["path"] is None else values["path"].flat()
        traits["thrusters"] = tuple(thruster.flat() for thruster in values["thrusters"])
        traits["pointer"] = "".join(f"/{part}" for part in path)
        self.findings += [Finding(path, message, hint) for message, hint in faults(traits)]
        return traits

    def _flat_shapes(self, shapes: tuple[Any, ...], material: str | None) -> tuple[FlatShape, ...]:
        """One tuple for all bodies of one `shapes` (the scene keeps it, hence its id, alive) and material."""
        key = (id(shapes), material)
        if key not in self._shapes:
            names = [shape.material or material for shape in shapes]
            materials = [self.scene.materials[name] if name else None for name in names]
            each = zip(shapes, materials, names, strict=True)
            bits = self.scene.categories
            self._shapes[key] = tuple(flat for s, m, name in each for flat in flat_shapes(s, m, bits, name or ""))
        return self._shapes[key]


def _part_count(shapes: tuple[Any, ...]) -> int:
    """How many convex shapes these are."""
    polygons = (shape for shape in shapes if isinstance(shape, PolygonShape))
    return len(shapes) + sum(len(decompose(shape.polygon, shape.holes).parts) - 1 for shape in polygons)


def _values(pattern: BodyFields) -> dict[str, Any]:
    return {name: getattr(pattern, name) for name in _FIELDS}
