"""Blocks that would overlap are told: by the distance of arches, by linear programs in any place."""

from itertools import combinations

import numpy as np
import pytest
from scipy.optimize import linprog

from elastica_cad import Placed, PlaneCurve, make_strip
from elastica_cad.model import end_fixtures
from elastica_cad.model.fixtures import crowded_blocks

pytestmark = pytest.mark.core

ARCH = PlaneCurve.arc((0, 0), 60, 3.1, 0.04)


def strip(label):
    return make_strip(ARCH, "birch-plywood-0.8", max_width=20, label=label)


@pytest.mark.parametrize(("share", "count"), [(1.001, 0), (0.95, 2)])
def test_arches_side_by_side_are_as_near_as_their_blocks_are_wide(share, count):
    (block, *_) = end_fixtures([Placed(strip("A"), (0, 0, 0), (1, 0, 0), (0, 0, 1))])
    apart = share * block.across
    placed = [Placed(strip(name), (0, i * apart, 0), (1, 0, 0), (0, 0, 1)) for i, name in enumerate("AB")]
    result = crowded_blocks(end_fixtures(placed), placed)
    assert len(result) == (count > 0)
    if result:
        assert result[0].startswith("the printed blocks of A:1 and B:1 (and 1 more pair) would overlap")


def hulls(block):
    """Corners of the convex parts of a block, in space."""
    for part in block.solid.added:
        flat = np.array([[*segment.start, 0.0] for segment in part.outline.segments])
        yield np.concatenate(
            [part.frame.point(flat + np.array([0.0, 0.0, z])) for z in (0.0, part.thickness)]
        )


def share_a_point(first, second):
    """Is some point a mean of the corners of either?"""
    n, m = len(first), len(second)
    equal = np.vstack(
        [np.hstack([first.T, -second.T]), np.repeat([[1, 0], [0, 1]], [n, m], axis=1).reshape(2, n + m)]
    )
    found = linprog(np.zeros(n + m), A_eq=equal, b_eq=[0, 0, 0, 1, 1], bounds=(0, None))
    return found.status == 0


@pytest.mark.campaign
def test_blocks_anywhere_in_space():
    rng = np.random.default_rng(3)
    made = strip("A")
    found = []
    for _ in range(60):
        turned = [np.linalg.qr(rng.normal(size=(3, 3)))[0][:2] for _ in range(2)]
        # both begin within a few centimetres
        starts = [ARCH.sample(2).position[0] @ axes for axes in turned]
        places = (-starts[0], rng.normal(size=3) * 15 - starts[1])
        placed = [
            Placed(made, tuple(place), tuple(x), tuple(y))
            for place, (x, y) in zip(places, turned, strict=True)
        ]
        blocks = end_fixtures(placed, ends=("start",))
        expected = any(
            share_a_point(a, b)
            for one, two in combinations(blocks, 2)
            for a in hulls(one)
            for b in hulls(two)
        )
        found.append(expected)
        assert bool(crowded_blocks(blocks, [])) == expected
    assert 5 < sum(found) < 55


def test_halves_of_a_ring_run_through_each_others_blocks():
    halves = [
        make_strip(
            PlaneCurve.arc((0, 0), 60, start, start + np.pi), "birch-plywood-0.8", max_width=20, label=name
        )
        for name, start in (("A", 0.0), ("B", np.pi))
    ]
    apart = [Placed(half, (0, 0, 60 * i), (1, 0, 0), (0, 1, 0)) for i, half in enumerate(halves)]
    assert crowded_blocks(end_fixtures(apart), apart) == ()
    ring = [Placed(half, (0, 0, 0), (1, 0, 0), (0, 1, 0)) for half in halves]
    blocks = end_fixtures(ring)
    (message,) = crowded_blocks(blocks, ring)
    assert message.startswith(
        "A would pass through the printed block of B:1 (and 3 more places): let the strips end farther apart"
    )
    # 10 mm of the other half lie where the tab is to be
    for block, other in zip(blocks, (1, 1, 0, 0), strict=True):
        points = np.column_stack([halves[other].rod.position, np.zeros(halves[other].rod.s.size)])
        inside = block.tab.frame.local(points)
        near = (np.abs(inside[:, 2]) < 2) & (inside[:, 0] > 0) & (inside[:, 0] < block.tab.length)
        assert np.ptp(inside[near, 0]) > 0.8 * block.tab.length


def test_a_block_between_the_middle_and_the_edge_of_a_wide_strip():
    """13 mm wide, it stands in a strip of 100 mm clear of its middle, of both edges and of half way to them."""
    wide = make_strip(ARCH, "birch-plywood-0.8", max_width=100, label="W")
    slim = make_strip(ARCH, "birch-plywood-0.8", max_width=5, label="B")
    placed = [
        Placed(wide, (0, 0, 0), (1, 0, 0), (0, 0, 1)),
        Placed(slim, (60, 12.5, 62), (1, 0, 0), (0, 0, 1)),
    ]
    blocks = end_fixtures(placed[1:])
    assert 12.5 - blocks[0].across / 2 > 5.0
    assert 12.5 + blocks[0].across / 2 < 20.0
    (message,) = crowded_blocks(blocks, placed)
    assert message.startswith(
        "W would pass through the printed block of B:1: let the strips end farther apart"
    )
    beside = Placed(slim, (60, 50.5 + blocks[0].across / 2, 62), (1, 0, 0), (0, 0, 1))
    assert crowded_blocks(end_fixtures([beside]), [placed[0], beside]) == ()
