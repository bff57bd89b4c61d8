"""Random valid scenes as plain data, the way a file holds them."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

numbers = st.one_of(st.integers(-1000, 1000), st.floats(-1000, 1000, allow_nan=False))
sizes = st.one_of(st.integers(1, 100), st.floats(0.01, 100))
points = st.tuples(numbers, numbers).map(list)
names = st.from_regex(r"[a-z][a-z0-9_.:-]{0,8}", fullmatch=True)
colors = st.from_regex(r"#[0-9a-f]{6}", fullmatch=True)
MATERIALS = ("wood", "ice")
CATEGORIES = ("player", "debris")


def record(required: dict[str, Any], optional: dict[str, Any]) -> st.SearchStrategy[dict[str, Any]]:
    return st.fixed_dictionaries(required, optional=optional)


surface = {
    "density": st.floats(0.1, 10),
    "friction": st.floats(0, 2),
    "restitution": st.floats(0, 1),
    "rolling_resistance": st.floats(0, 1),
    "surface_speed": st.floats(-10, 10),
}
bits = st.one_of(
    st.integers(0, 0xFFFFFFFF),
    st.sampled_from([*CATEGORIES, "default"]),
    st.lists(st.sampled_from(CATEGORIES), max_size=2, unique=True),
)
shared = {
    **surface,
    "at": points,
    "material": st.sampled_from(MATERIALS),
    "category": bits,
    "mask": bits,
    "group": st.integers(-5, 5),
}
turned = {**shared, "angle": numbers}
ends = st.tuples(points, points).filter(lambda e: e[0] != e[1] and _far(*e)).map(list)


def _far(a: list[float], b: list[float]) -> bool:
    return max(abs(a[0] - b[0]), abs(a[1] - b[1])) > 1e-3


triangles = st.tuples(numbers, numbers, sizes, sizes).map(
    lambda t: [[t[0], t[1]], [t[0] + t[2], t[1]], [t[0], t[1] + t[3]]]
)
shapes = st.one_of(
    record({"circle": sizes}, shared),
    record({"box": st.tuples(sizes, sizes).map(list)}, turned),
    record({"capsule": ends, "radius": sizes}, turned),
    record({"segment": ends, "radius": sizes}, turned),
    record({"polygon": triangles}, {**turned, "radius": sizes}),
)
pattern = {
    "type": st.sampled_from(["dynamic", "kinematic"]),
    "angle": numbers,
    "velocity": points,
    "angular_velocity": numbers,
    "linear_damping": st.floats(0, 10),
    "angular_damping": st.floats(0, 10),
    "gravity_scale": numbers,
    "fixed_rotation": st.booleans(),
    "sleep_speed": st.floats(0, 10),
    "mass": sizes,
    "inertia": sizes,
    "center": points,
    "material": st.sampled_from(MATERIALS),
    "color": colors,
    "thrusters": st.lists(record({"force": points}, {"at": points, "start": st.integers(0, 9)}), max_size=2),
}


def _pushable(made: dict[str, Any]) -> dict[str, Any]:
    """Only dynamic bodies may have thrusters."""
    return {key: made[key] for key in made if key != "thrusters" or made.get("type", "dynamic") == "dynamic"}


materials = st.fixed_dictionaries({name: record({}, surface) for name in MATERIALS})
crates = record({"shapes": st.lists(shapes, min_size=1, max_size=2)}, pattern).map(_pushable)
prefabs = st.fixed_dictionaries({"crate": crates})


@st.composite
def bodies(draw: st.DrawFn) -> list[dict[str, Any]]:
    ids = draw(st.lists(names, min_size=1, max_size=4, unique=True))
    own = record({"shapes": st.lists(shapes, min_size=1, max_size=2)}, {**pattern, "position": points})
    copied = record({"prefab": st.just("crate")}, {**pattern, "position": points})
    return [{"id": name, **draw(st.one_of(own, copied).map(_pushable))} for name in ids]


times = st.one_of(
    st.fixed_dictionaries({"at": st.integers(0, 500)}),
    st.just({"always": True}),
    st.tuples(st.integers(0, 100), st.integers(100, 500)).map(lambda t: {"within": list(t)}),
)


@st.composite
def expectations(draw: st.DrawFn, ids: list[str]) -> list[dict[str, Any]]:
    name = st.one_of(st.sampled_from(ids), st.just("*"))
    many = st.one_of(name, st.lists(name, min_size=1, max_size=3))
    box = st.just([-10, -10, 10, 10.5])
    condition = st.one_of(
        record({"rests": many}, {"tolerance": st.floats(0, 1)}),
        record({"stands": many}, {"moved": st.floats(0, 1), "turned": st.floats(0, 90)}),
        record({"inside": box}, {"of": many}),
        record({"above": numbers}, {"of": many}),
        record({"below": numbers}, {"of": many}),
        record({"touches": st.tuples(name, name).map(list)}, {}),
        record({"apart": st.tuples(name, name).map(list)}, {}),
        record({"senses": st.tuples(name, name).map(list)}, {}),
        record({"asleep": many}, {}),
        record({"near": points, "of": many}, {"tolerance": st.floats(0, 1)}),
        record({"speed": st.just([0, 2.5]), "of": many}, {}),
        record({"angle": st.just([-10, 10]), "of": many}, {}),
    )
    return [{**draw(times), **draw(condition)} for _ in range(draw(st.integers(0, 3)))]


@st.composite
def generators(draw: st.DrawFn) -> list[dict[str, Any]]:
    count, spacing = st.integers(1, 6), st.tuples(sizes, sizes).map(list)
    kinds = st.one_of(
        record({"row": st.just("crate"), "count": count}, {"at": points, "step": points}),
        record({"stack": st.just("crate"), "count": count}, {"at": points, "spacing": sizes}),
        record({"grid": st.just("crate"), "columns": count, "rows": count}, {"at": points, "spacing": spacing}),
        record({"pyramid": st.just("crate"), "rows": count}, {"at": points, "spacing": spacing}),
        record(
            {"scatter": st.just("crate"), "count": count, "inside": st.just([-1e5, -1e5, 1e5, 1e5])},
            {"seed": st.integers(0, 99), "apart": st.floats(0, 5), "angle": st.just([-20, 20])},
        ),
    )
    return [{"id": f"made{k}", **draw(kinds)} for k in range(draw(st.integers(0, 2)))]


area = {"inside": st.just([-10, -10, 10, 10.5]), "start": st.integers(0, 5), "end": st.integers(6, 9)}
regions = st.one_of(
    record({"water": sizes}, {**area, "surface": numbers, "drag": st.floats(0, 10), "flow": points}),
    record({"gravity": points}, area),
    record({"gravity_scale": numbers}, {"disc": st.just([0, 1, 2.5])}),
    record({"attraction": numbers}, {"at": points, "falloff": st.integers(0, 3), "core": sizes, "range": sizes}),
    record({"wind": points}, {"outline": triangles, "density": sizes, "drag": st.floats(0, 10)}),
)


@st.composite
def scenes(draw: st.DrawFn) -> dict[str, Any]:
    """A whole valid scene."""
    made = draw(bodies())
    optional = record(
        {},
        {
            "$schema": st.just("../scene.schema.json"),
            "format": st.just(1),
            "title": st.text(max_size=20),
            "about": st.text(max_size=20),
            "gravity": points,
            "generate": generators(),
            "regions": st.lists(regions, max_size=3),
            "settings": record(
                {},
                {
                    "step_rate": st.integers(10, 240),
                    "substeps": st.integers(1, 10),
                    "sleeping": st.booleans(),
                    "steps": st.integers(1, 600),
                },
            ),
            "view": record({"center": points}, {"height": sizes}),
        },
    )
    fixed = {
        "categories": list(CATEGORIES),
        "materials": draw(materials),
        "prefabs": draw(prefabs),
        "bodies": made,
        "expect": draw(expectations([body["id"] for body in made])),
    }
    return {**draw(optional), **fixed}
