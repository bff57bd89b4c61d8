"""Sweeps from Python: rows in order, the same whoever runs them; errors stay in their rows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sandbox
from sandbox.sweeps.heat_map import cells_of
from sandbox.sweeps.journal import Journal
from sandbox.sweeps.plot import Plot, save_plot
from sandbox.sweeps.study import Outcome
from sandbox.sweeps.table import SweepTable, read_table

GROUND = {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]}
CRATE = {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5], "velocity": [4, 0]}
SLIDING = sandbox.Scene(materials={"wood": {"friction": 0.4}}, bodies=[GROUND, {**CRATE, "material": "wood"}])
WITH = {"materials.wood.friction": "0.2:0.8:4", "bodies.crate.velocity.0": [2, 4]}


def test_a_row_for_each_run_in_the_order_of_the_grid() -> None:
    table = sandbox.sweep(SLIDING, WITH, 90, ["crate = body('crate').position", "energy"])
    assert table.columns == (*WITH, "crate_x", "crate_y", "energy", "digest", "steps", "status")
    assert len(table) == 8
    assert list(table["materials.wood.friction"]) == [0.2, 0.2, 0.4, 0.4, 0.6, 0.6, 0.8, 0.8]
    slid = table["crate_x"].reshape(4, 2)
    assert (np.diff(slid, axis=0) < 0).all()
    assert (slid[:, 1] > slid[:, 0]).all()
    data = SLIDING.to_data()
    data["materials"]["wood"]["friction"], data["bodies"][1]["velocity"][0] = 0.6, 4
    world = sandbox.World(sandbox.Scene(**data))
    world.step(90)
    assert table.rows[5] == {
        "materials.wood.friction": 0.6, "bodies.crate.velocity.0": 4, "crate_x": world.body("crate").position[0],
        "crate_y": world.body("crate").position[1], "energy": table["energy"][5], "digest": world.digest(),
        "steps": 90, "status": "ok",
    }  # fmt: skip


def test_a_run_that_fails_is_a_row() -> None:
    table = sandbox.sweep(SLIDING, {"materials.wood.friction": [0.5, -1.0, "ice"]}, 2, ["energy"])
    assert [status == "ok" for status in table["status"]] == [True, False, False]
    assert "friction" in table["status"][1]
    assert np.isnan(table["energy"][1:]).all()
    assert table.csv().splitlines()[2].startswith("-1.0,,,0,")


def test_a_sample() -> None:
    one = sandbox.sweep(SLIDING, {"gravity.1": "-12:-1"}, 1, draw=(5, 3))
    assert len(one) == 5
    assert one.csv() == sandbox.sweep(SLIDING, {"gravity.1": "-12:-1"}, 1, draw=(5, 3)).csv()
    assert one.csv() != sandbox.sweep(SLIDING, {"gravity.1": "-12:-1"}, 1, draw=(5, 4)).csv()


def test_what_cannot_be_swept_is_told_before_anything_runs() -> None:
    for arguments, said in (
        ({"vary": {"bodies.crat.angle": [1]}}, 'did you mean "crate"'),
        ({"vary": {"bodies.crate.angel": [1]}}, 'did you mean "angle"'),
        ({"vary": {"gravity.1": [1]}, "collect": ["body('crat').x"]}, 'did you mean "crate"'),
        ({"vary": {"gravity.1": [1]}, "collect": ["status = energy"]}, "there is a column 'status' already"),
        ({"vary": {"gravity.1": [1]}, "collect": ["at(9, energy)"], "steps": 8}, "the steps 0 to 8"),
        ({"vary": {"gravity.1": [1]}, "draw": 3}, "a pair"),
        ({"vary": {"gravity.1": [2**63, 1]}}, "gravity.1: a whole number is one of 64 bits, not 9223372036854775808"),
        ({"vary": {"gravity.1": [10**400]}}, "gravity.1: a whole number is one of 64 bits, not a number of more"),
        ({"vary": [1]}, "a dictionary"),
        ({"vary": {"gravity.1": [1]}, "on": 0}, "processes from 1"),
    ):
        with pytest.raises(sandbox.ArgumentError) as error:
            sandbox.sweep(SLIDING, **arguments)  # type: ignore[arg-type]
        assert said in str(error.value)


@pytest.mark.slow
def test_a_cluster_gives_the_same_bytes() -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        there = sandbox.sweep(SLIDING, WITH, 30, ["energy"], on=cluster.scheduler_address)
    assert there.csv() == sandbox.sweep(SLIDING, WITH, 30, ["energy"]).csv()


class TestTables:
    def test_texts_that_could_be_numbers_stay_what_they_are(self) -> None:
        scene = sandbox.Scene(materials={"nan": {}, "1e3": {"friction": 1}}, bodies=[{**CRATE, "material": "nan"}])
        table = sandbox.sweep(scene, {"bodies.crate.material": ["nan", "1e3"]}, 1)
        assert table["bodies.crate.material"].tolist() == ["nan", "1e3"]
        assert table["status"].tolist() == ["ok", "ok"]

    def test_a_file_holds_the_same_numbers(self, tmp_path: Path) -> None:
        table = sandbox.sweep(SLIDING, WITH, 5, ["body('crate').velocity"])
        table.save(tmp_path / "t.csv")
        again = read_table(tmp_path / "t.csv")
        assert again.csv() == table.csv()
        assert all(np.array_equal(again[name], table[name]) for name in table)

    def test_a_parquet_file_does_too(self, tmp_path: Path) -> None:
        pytest.importorskip("pyarrow")
        table = sandbox.sweep(SLIDING, WITH, 5, ["body('crate').velocity"])
        table.save(tmp_path / "t.parquet")
        assert read_table(tmp_path / "t.parquet").csv() == table.csv()

    def test_what_is_no_table(self, tmp_path: Path) -> None:
        for data in (b"", b"\xff\xfe", b"a,b\n1\n"):
            (tmp_path / "t.csv").write_bytes(data)
            with pytest.raises(sandbox.SandboxError, match="this is no table in CSV"):
                read_table(tmp_path / "t.csv")

    def test_unknown_columns_and_pages(self) -> None:
        table = SweepTable({"speed": [1.0, 2.5], "status": ["ok", "<b>"]})
        with pytest.raises(sandbox.ArgumentError, match='did you mean "speed"'):
            _ = table["sped"]
        assert "<td>2.5</td><td>&lt;b&gt;</td>" in table._repr_html_()
        assert repr(table) == "<SweepTable of 2 runs: speed, status>"

    @pytest.mark.parametrize("digest", ["0123456789012345", "84219e7350120012", "1234567e00000001"])
    def test_digests_stay_texts(self, digest: str, tmp_path: Path) -> None:
        """Also those that could be read as a number, one that no float holds among them."""
        table = SweepTable({"digest": [digest]})
        table.save(tmp_path / "t.csv")
        for each in (table, read_table(tmp_path / "t.csv")):
            assert each["digest"].tolist() == [digest]


class TestPlots:
    @pytest.mark.parametrize("theme", ["dark", "light"])
    def test_a_plot_is_the_same_each_time(self, tmp_path: Path, theme: str) -> None:
        table = sandbox.sweep(SLIDING, WITH, 5, ["body('crate').velocity"])
        plot = Plot("materials.wood.friction", ("crate_velocity_x",), "bodies.crate.velocity.0", theme=theme)  # type: ignore[arg-type]
        for name in ("a.svg", "b.svg"):
            save_plot(table, plot, tmp_path / name)
        first = (tmp_path / "a.svg").read_bytes()
        assert first == (tmp_path / "b.svg").read_bytes()
        assert first.startswith(b"<?xml")

    def test_a_heat_map_has_a_cell_for_each_pair(self) -> None:
        across, up = np.array([0.0, 1.0, 0.0, 1.0, 0.0]), np.array([5.0, 5.0, 7.0, 7.0, 7.0])
        values = np.array([1.0, 2.0, 3.0, float("nan"), 5.0])
        cells = cells_of((across, up, values), np.unique(across), np.unique(up))
        assert np.array_equal(cells, [[1.0, 2.0], [4.0, float("nan")]], equal_nan=True)

    @pytest.mark.parametrize(("sampled", "failed"), [(False, True), (True, False)])
    def test_heat_maps_are_drawn(self, tmp_path: Path, sampled: bool, failed: bool) -> None:
        pairs = [(0.1 * k, k * k) for k in range(9)] if sampled else [(0.1 * k, j) for k in range(3) for j in range(3)]
        x, y = map(list, zip(*pairs, strict=True))
        z = [float("nan")] * 9 if failed else [float(k) for k in range(9)]
        table = SweepTable({"x": x, "wood": [f"w{k}" for k in y], "z": z})
        for name in ("a.svg", "b.svg"):
            save_plot(table, Plot("x", ("z",), over="wood"), tmp_path / name)
        drawn = (tmp_path / "a.svg").read_text(encoding="utf-8")
        assert drawn == (tmp_path / "b.svg").read_text(encoding="utf-8")
        with pytest.raises(sandbox.ArgumentError, match="by and over exclude each other"):
            save_plot(table, Plot("x", ("z",), by="wood", over="wood"), tmp_path / "c.svg")

    def test_words_and_missing_values(self, tmp_path: Path) -> None:
        table = SweepTable({"wood": ["ice", "oak", "ice"], "y": [1.0, float("nan"), 2.0]})
        save_plot(table, Plot("wood", ("y",)), tmp_path / "p.png")
        assert (tmp_path / "p.png").stat().st_size > 1000
        with pytest.raises(sandbox.ArgumentError, match="wood holds no numbers"):
            save_plot(table, Plot("y", ("wood",)), tmp_path / "p.png")


class TestJournals:
    def outcome(self, run: int) -> Outcome:
        return Outcome(run, (0.1 * run, float("nan")), "d", 3, "ok")

    def test_what_was_noted_is_there_but_for_a_torn_line(self, tmp_path: Path) -> None:
        path = tmp_path / "t.csv.journal"
        with Journal(path, "f", 9).writing(goes_on=False) as journal:
            for run in (2, 0, 1):
                journal.note(self.outcome(run))
        with open(path, "ab") as file:
            file.write(b"[3, [0.3")
        assert list(Journal(path, "f", 9).done()) == [2, 0, 1]
        with Journal(path, "f", 9).writing(goes_on=True) as journal:
            journal.note(self.outcome(5))
        assert list(Journal(path, "f", 9).done()) == [2, 0, 1, 5]
        assert Journal(path, "f", 9).done()[2].values[0] == 0.2

    def test_two_sweeps_do_not_write_one(self, tmp_path: Path) -> None:
        pytest.importorskip("fcntl")
        path = tmp_path / "t.csv.journal"
        with Journal(path, "f", 9).writing(goes_on=False) as journal:
            journal.note(self.outcome(3))
            for other in ("f", "g"):
                with (
                    pytest.raises(sandbox.SandboxError, match="another sweep writes it now"),
                    Journal(path, other, 9).writing(goes_on=False),
                ):
                    pass
        assert list(Journal(path, "f", 9).done()) == [3]

    def test_another_sweep_is_refused(self, tmp_path: Path) -> None:
        path = tmp_path / "t.csv.journal"
        with Journal(path, "f", 9).writing(goes_on=False):
            pass
        with pytest.raises(sandbox.SandboxError, match="this journal is of another sweep"):
            Journal(path, "g", 9).done()
        path.write_bytes(b"")
        with pytest.raises(sandbox.SandboxError, match="this journal is of another sweep"):
            Journal(path, "f", 9).done()
