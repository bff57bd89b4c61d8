"""The last step of `sandbox sat --step-by-step`: how the contact points come about."""

from __future__ import annotations

from sandbox.cli.sat_pair import SatPair
from sandbox.geometry.clip_steps import BestFace, Clipping, best_faces, clipping
from sandbox.geometry.sat_table import SatTable
from sandbox.render.number_text import metres, plain, point


def clipping_lines(pair: SatPair, table: SatTable) -> list[str]:
    """Reference face, incident edge, cuts and points; `table` is of a colliding pair."""
    assert table.contact is not None
    faces = best_faces(pair.a, pair.b)
    lines = ["The engine asks every face how deep the other shape lies behind it; the least deep one of each:"]
    lines += [f"  {_face(name, best)}" for name, best in zip(pair.names, faces, strict=True)]
    clipped = clipping(pair.a, pair.b, table.contact)
    if clipped is not None:
        lines += _cuts(pair, clipped)
    elif table.contact.axis_owner == "corners":
        lines.append("Two corners or discs are nearest: the point lies on the line from one to the other.")
    else:
        lines.append("A disc has no edge to cut: its centre gives the only point.")
    points = " and ".join(point(each) for each in table.contact.points)
    return [*lines, f"Half way between the surfaces: {points}."]


def _face(name: str, best: BestFace | None) -> str:
    if best is None:
        return f"{name}: a disc has no faces"
    return f"{name}: edge {best.edge}, {metres(abs(best.separation))} {'behind' if best.separation < 0 else 'in front'}"


def _cuts(pair: SatPair, clip: Clipping) -> list[str]:
    mine, other = pair.names if clip.owner == "a" else pair.names[::-1]
    towards = -clip.normal[1] + 0.0, clip.normal[0]
    ends = sorted(clip.before)
    lines = [
        f"Reference face: edge {clip.reference_edge} of {mine}, {_ends(clip.reference)}, normal {point(clip.normal)}.",
        f"Incident edge: edge {clip.incident_edge} of {other}, {_ends(clip.incident)}, faces it most.",
        f"Along the face, {point(towards)}, it covers {plain(clip.low)} to {plain(clip.high)};"
        f" the edge {plain(ends[0])} to {plain(ends[1])}.",
    ]
    return lines + [_end(*each) for each in zip(clip.incident, clip.clipped, clip.gaps, strict=True)]


def _end(before: tuple[float, float], after: tuple[float, float], gap: float) -> str:
    cut = f"{point(before)}" + (f", cut at the side to {point(after)}" if after != before else "")
    depth = metres(abs(gap))
    return f"  {cut}: {depth} beneath the face, a point" if gap <= 0.0 else f"  {cut}: {depth} above it, dropped"


def _ends(edge: tuple[tuple[float, float], tuple[float, float]]) -> str:
    return f"{point(edge[0])} to {point(edge[1])}"
