"""A strip whose tabs lie in pockets with play: contact at the mouth and at the bottom, by an active set.

Rigid walls touch a tab that has taken up its play along two lines, where the free part ends and at the bottom, on
one face or the other. A face is tried; the walls must push there, or the other face is taken.
"""

import re
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from tests.campaign.finite_elements.bricks import Bricks
from tests.campaign.finite_elements.calculix import (
    Answer,
    Material,
    displaced,
    model_cards,
    run,
    strict,
    weight_cards,
)

__all__ = ["solve_in_pockets"]

TRIALS = 6


def solve_in_pockets(
    body: Bricks,
    material: Material,
    place: Callable[[np.ndarray], np.ndarray],
    length: float,
    folder: Path,
    *,
    depth: float,
    play: float,
    gravity: Sequence[float] | None = None,
) -> Answer:
    """The rest shape of a strip of one sheet, each tab of which touches its pocket at two lines.

    Where the free part ends the tab keeps its place along the strip and across.

    Parameters
    ----------
    place : callable
        From flat points (n, 3) to the drawn pose, rigid beyond the ends.
    length : float
        Of the free part, mm.
    depth : float
        Of the pockets, from the end of the free part, mm: the length of the tabs.
    play : float
        Room on either face, mm.
    gravity : (gx, gy, gz), optional
        Direction in which things fall.
    """
    faces = np.array([1, -1, 1, -1])  # of the lines: start's mouth and bottom, end's; +1 for the upper face
    for _ in range(TRIALS):
        answer, push = _touched(body, material, place, length, folder, depth, play, faces, gravity)
        pulled = push * faces > 0  # a wall above the tab pushes down
        if not pulled.any():
            return answer
        faces = np.where(pulled, -faces, faces)
    raise RuntimeError(f"no faces were found on which the pockets push in {TRIALS} trials")


def _touched(
    body: Bricks,
    material: Material,
    place: Callable[[np.ndarray], np.ndarray],
    length: float,
    folder: Path,
    depth: float,
    play: float,
    faces: np.ndarray,
    gravity: Sequence[float] | None,
) -> tuple[Answer, np.ndarray]:
    """The strip that touches on these faces, and the forces of the walls there off the strip, N."""
    x, _, z = body.nodes.T
    frames = [_frame(place, at) for at in (0.0, length)]
    lines = []
    for at, upper in zip((0.0, -depth, length, length + depth), faces, strict=True):
        lines.append(
            np.flatnonzero((abs(x - at) < 1e-6) & (abs(z - (z.max() if upper > 0 else z.min())) < 1e-9))
        )
    stops = [np.flatnonzero((abs(x - at) < 1e-6) & (abs(z) < 1e-9)) for at in (0.0, length)]
    moved = place(body.nodes) - body.nodes
    deck = model_cards(body, [material])
    for end, frame in enumerate(frames):
        turned = np.concatenate([*lines[2 * end : 2 * end + 2], stops[end]])
        moved[turned] = moved[turned] @ frame.T
        deck += [*_set(f"END{end}", turned), f"*TRANSFORM, NSET=END{end}, TYPE=R"]
        deck.append(", ".join(f"{value:.12g}" for value in (*frame[0], *frame[1])))
    for k, line in enumerate(lines):
        deck += _set(f"LINE{k}", line)
    placed = [displaced(i, j, moved) for i in range(len(moved)) for j in (0, 2)]
    kept = [displaced(i, j, moved) for stop in stops for i in stop for j in (0, 1)]
    touching = moved.copy()
    for line, upper in zip(lines, faces, strict=True):
        touching[line, 2] += play * upper
    walls = [displaced(i, 2, touching) for line in lines for i in line]
    across = [condition for condition in kept if ", 2, 2, " in condition]
    result = [
        card for k in range(4) for card in (f"*NODE PRINT, NSET=LINE{k}, TOTALS=ONLY, GLOBAL=YES", "RF")
    ]
    tabs = np.flatnonzero((x < 1e-6) | (x > length - 1e-6))
    tight = [displaced(i, j, moved) for i in tabs for j in range(3)]
    load = weight_cards(gravity)
    for kind, conditions in (("*STATIC, DIRECT\n1., 1.", [*placed, *across]), ("*STATIC\n1., 1., 1e-5", tight),
                             ("*STATIC\n0.2, 1., 1e-5", [*kept, *walls])):  # fmt: skip
        deck += [
            "*STEP, NLGEOM, INC=300",
            kind,
            *strict(),
            "*BOUNDARY, OP=NEW",
            *conditions,
            *load,
            "*END STEP",
        ]
    deck[-1:] = ["*NODE PRINT, NSET=ALL, GLOBAL=YES, FREQUENCY=1000", "U", *result, "*END STEP"]
    answer = run(deck, len(body.nodes), folder)
    text = (folder / "strip.dat").read_text()
    found = [re.findall(rf"total force .* set LINE{k} .*\n\s*\n\s*(.*)", text)[-1].split() for k in range(4)]
    return answer, np.array(
        [np.array(force, dtype=float) @ frames[k // 2][2] for k, force in enumerate(found)]
    )


def _set(name: str, nodes: np.ndarray) -> list[str]:
    return [f"*NSET, NSET={name}", *(f"{i + 1}," for i in nodes)]


def _frame(place: Callable[[np.ndarray], np.ndarray], at: float) -> np.ndarray:
    """Rows: along the strip, across it, off it, where the free part ends."""
    origin, across, off = place(np.array([(at, 0.0, 0.0), (at, 1.0, 0.0), (at, 0.0, 1.0)]))
    y, n = across - origin, off - origin
    return np.array([np.cross(y, n), y, n])
