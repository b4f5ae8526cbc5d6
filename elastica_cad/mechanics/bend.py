"""Bending forward: from a rod and what is done to its ends to its rest shape."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.mechanics.arguments import required_supports, whole_number
from elastica_cad.mechanics.balance import Balance, State, edge_state
from elastica_cad.mechanics.bifurcation import from_straight, is_straight, stretched
from elastica_cad.mechanics.continuation import Reached, follow, is_balanced, relax, unstable_modes
from elastica_cad.mechanics.discrete import edge_positions
from elastica_cad.mechanics.gravity import Gravity
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.supports import Supports

__all__ = ["as_steps", "balance_of", "bend", "bend_path", "reach", "resampled", "state_of"]

Keep = Literal["keep"]

COARSE = 60.0  # degrees between neighbouring edges


def bend(
    rod: Rod,
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    angles: tuple[float | None, float | None] | ArrayLike | None = None,
    *,
    gravity: Gravity | Keep | None = "keep",
    supports: Supports | None = None,
    force: ArrayLike | None = None,
    moment: float | tuple[float, float] | None = None,
    guess: "Rod | ArrayLike | None" = None,
    side: int | None = None,
    mode: int = 1,
    samples: int | None = None,
    settle: bool = False,
) -> Rod:
    """The rest shape of a rod whose ends are moved, turned, loaded or supported anew.

    Newton's method with line search on the discrete rod of paper section 7.1 (with weight), O(n) a step.
    When the shape asked for is far from the rod's present one, ends, angles and loads are changed in
    adaptive steps, starting from the present shape (or `guess`), so the answer lies on the same branch of
    equilibria, stable or not; ask `stability`. Where that branch ends the rod snaps: the answer is then a
    stable shape found by descending the energy, and `warnings` of the answer says so.

    Parameters
    ----------
    rod : Rod
        From `optimal_rod`, `Rod.straight` or `bend`.
    start, end : (2,) array_like, optional
        Positions of the ends, mm; the rod's own unless given. A coordinate that its end leaves free is not
        used.
    angles : pair of float, optional
        Angles of the tangent at the start and the end, rad, counted continuously along the rod (a full
        loop differs by 2 pi); None, or None in the pair, keeps the rod's own.
    gravity : Gravity, None or "keep"
    supports : Supports, optional
        New supports; the rod's own unless given.
    force : (2,) array_like, optional
        Dead force over the least bending stiffness, 1/mm2 (F / B with F in N, B in N mm2), in the
        direction of x and y; each component acts at the end that leaves this coordinate free. None keeps
        what the rod carries.
    moment : float or pair of float, optional
        Moment over the least bending stiffness, 1/mm, counterclockwise positive, applied at the end whose
        angle is free (a pair for start and end). None keeps what the rod carries.
    guess : Rod or array_like, optional
        Another shape to start from: a rod, or angles at the n nodes or n-1 edges.
    side : {+1, -1}, optional
        Where a straight state branches: the side, left (+1) or right of the direction of travel, to which
        the first bulge goes. A straight rod whose ends are pushed together goes left unless told; one that
        can stay straight under its dead load stays straight unless told.
    mode : int
        Buckling mode to leave the straight state in; modes above 1 are unstable as a rule.
    samples : int, optional
        Number of nodes; the rod's own unless given.
    settle : bool
        Let an unstable shape go: it snaps to the stable one that descending the energy leads to.

    Returns
    -------
    Rod
        In balance to 1e-10 of its moments, ends in place to 1e-10 of its length. Reactions at the ends:
        `force[0]`, `force[-1]` (lambda, minus the internal force) and `moment`.

    Raises
    ------
    InputError
        Ends farther apart than the length, loads where nothing can move, wrong shapes.
    NotConvergedError
        No equilibrium found; says how far the way led.

    Examples
    --------
    >>> arch = bend(Rod.straight(100.0, samples=101), end=(70.0, 0.0))
    >>> round(float(arch.position[:, 1].max()), 1)
    31.4
    """
    if not isinstance(rod, Rod):
        raise InputError(
            f"bend needs a Rod, as optimal_rod or Rod.straight makes one, not {type(rod).__name__}"
        )
    ends = rod.position[0], rod.position[-1]
    start, end = (own if given is None else given for given, own in zip((start, end), ends, strict=True))
    if samples is not None and samples != rod.s.size:
        rod = resampled(rod, samples)
    if not (gravity is None or isinstance(gravity, Gravity) or gravity == "keep"):
        raise InputError(f'gravity must be a Gravity record, None or "keep", not {gravity!r}')
    if side not in {None, 1, -1}:
        raise InputError(f"side must be +1 or -1, got {side!r}")
    whole_number(mode, "mode", 1)
    wanted = replace(
        rod,
        gravity=rod.gravity if isinstance(gravity, str) else gravity,
        supports=rod.supports if supports is None else required_supports(supports),
    )
    balance = balance_of(wanted, rod, start, end, angles, force=force, moment=moment)
    state = state_of(rod, balance) if guess is None else _guessed(guess, balance)
    reached = reach(balance, state, side, mode)
    balanced = reached.arrived and is_balanced(balance, reached.state)
    if balanced and not (settle and unstable_modes(balance, reached.state)):
        return replace(balance.rod(reached.state, wanted), warnings=_too_coarse(reached.state))
    snapped = relax(balance, reached.state)
    if snapped is None:
        raise NotConvergedError(
            f"no rest shape found: {reached.fraction:.1%} of the way from the present shape was possible; "
            "move the ends in smaller steps, or give a guess nearer to the answer"
        )
    warning = f"the rod snaps {reached.fraction:.1%} of the way from its present shape; here it comes to rest"
    return replace(balance.rod(snapped, wanted), warnings=(warning, *_too_coarse(snapped)))


def _too_coarse(state: State) -> tuple[str, ...]:
    turn = float(np.degrees(np.abs(np.diff(state.angles)).max()))
    if turn < COARSE:
        return ()
    return (f"the rod turns by {turn:.0f} degrees between two nodes: its shape is rough, use more samples",)


def bend_path(
    rod: Rod,
    path: "ArrayLike | Sequence[Mapping[str, Any]]",
    *,
    side: int | None = None,
    mode: int = 1,
) -> tuple[Rod, ...]:
    """The family of shapes of a rod whose ends are led along a path (kinetic use, paper section 9.5).

    Parameters
    ----------
    rod : Rod
    path : (k, 2) array_like or sequence of mappings
        Positions of the end one after the other, mm, or for each step the keywords of `bend` (start, end,
        angles, gravity, force, moment, supports).
    side, mode
        As in `bend`, for the first step.

    Returns
    -------
    tuple of Rod
        One a step; reactions are `force` and `moment` at the first and the last node.

    Raises
    ------
    InputError, NotConvergedError
        As `bend`, naming the step.

    Examples
    --------
    >>> rods = bend_path(Rod.straight(100.0, samples=101), [(90.0, 0.0), (80.0, 0.0), (80.0, 10.0)])
    >>> len(rods)
    3
    """
    rods: list[Rod] = []
    steps = as_steps(path)
    for k, step in enumerate(steps):
        try:
            rod = bend(rod, **step, side=side if k == 0 else None, mode=mode if k == 0 else 1)
        except NotConvergedError as error:
            raise NotConvergedError(f"step {k + 1} of {len(steps)} of the path: {error}") from error
        rods.append(rod)
    return tuple(rods)


def as_steps(path: "ArrayLike | Sequence[Mapping[str, Any]]") -> list[dict[str, Any]]:
    """A path as keywords of `bend`: mappings as they are, rows of two numbers as positions of the end."""
    if isinstance(path, Sequence) and path and all(isinstance(step, Mapping) for step in path):
        steps = [dict(step) for step in path if isinstance(step, Mapping)]
        known = {"start", "end", "angles", "gravity", "force", "moment", "supports"}
        for step in steps:
            if set(step) - known:
                raise InputError(
                    f"unknown entry {sorted(set(step) - known)[0]!r} in a path: "
                    f"use {', '.join(sorted(known))}"
                )
        return steps
    try:
        points = np.asarray(path, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(
            "a path is a row of (x, y) of the end, or of mappings with keywords of bend"
        ) from error
    if points.ndim != 2 or points.shape[1] != 2 or not np.all(np.isfinite(points)):
        raise InputError(f"a path of end positions must be finite with shape (k, 2), got {points.shape}")
    return [{"end": point} for point in points]


def balance_of(
    rod: Rod,
    present: Rod,
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    angles: "tuple[float | None, float | None] | ArrayLike | None" = None,
    *,
    force: ArrayLike | None = None,
    moment: float | tuple[float, float] | None = None,
) -> Balance:
    """The equations of `rod` (stiffness, weight, supports); what is not given is kept from `present`."""
    if rod.s.size < 4:
        raise InputError(f"a rod of {rod.s.size} nodes cannot be bent: use samples=4 or more")
    balance = Balance(
        stiffness=np.asarray(rod.stiffness), edge_length=rod.length / (rod.s.size - 1), load=rod.nodal_load,
        natural_curvature=rod.natural_curvature, supports=rod.supports,
        start=_pair(start, present.position[0], "start"), end=_pair(end, present.position[-1], "end"),
        end_angles=_end_angles(angles, rod.supports, present), force=_end_force(force, rod.supports,
        present), moments=_end_moments(moment, rod.supports, present), law=rod.law,
    )  # fmt: skip
    apart = float(np.linalg.norm(balance.chord))
    if apart > balance.length * (1 + 1e-12):
        raise InputError(
            f"the ends are {apart:.6g} mm apart, but the rod is only {balance.length:.6g} mm long: "
            "bring them closer or use a longer rod"
        )
    return balance


def state_of(rod: Rod, balance: Balance) -> State:
    """Edge angles and reactions of a rod's present shape as a first state for `balance`."""
    edge_angles, force = edge_state(rod)
    extra = (force - balance.given_force).mean(axis=0)
    return State(edge_angles, extra[list(balance.held)])


def resampled(rod: Rod, samples: int) -> Rod:
    """The same rod on another number of nodes: stiffness from its profile, the rest interpolated."""
    whole_number(samples, "samples", 4)
    s = np.linspace(0.0, rod.length, samples)
    K = rod.profile(s)

    def at(values: FloatArray) -> FloatArray:
        return np.asarray(np.interp(s, rod.s, values))

    middles = (s[:-1] + s[1:]) / 2
    angles = np.interp(middles, (rod.s[:-1] + rod.s[1:]) / 2, edge_state(rod)[0])
    kappa_0 = rod.natural_curvature
    return replace(
        rod, s=s, position=edge_positions(rod.position[0], angles, s[1]), angle=at(rod.angle),
        curvature=at(rod.curvature), stiffness=K / K.min(), profile=rod.profile.scaled(1 / float(K.min())),
        moment=at(rod.moment), force=np.column_stack([at(rod.force[:, 0]), at(rod.force[:, 1])]),
        natural_curvature=at(kappa_0) if isinstance(kappa_0, np.ndarray) and kappa_0.ndim else kappa_0,
    )  # fmt: skip


def reach(balance: Balance, state: State, side: int | None, mode: int) -> Reached:
    """Follow from `state` to the wanted equilibrium; leave a straight state where it must or is told to."""
    if balance.held and float(np.linalg.norm(balance.chord)) > balance.length * (1 - 1e-12):
        taut = stretched(balance, state)
        if not is_balanced(balance, taut):
            raise InputError(
                f"the ends are as far apart as the rod is long ({balance.length:.6g} mm), so it must be "
                "straight, which its end angles or its weight do not allow: bring the ends closer together"
            )
        return Reached(taut, 1.0, 0)
    return from_straight(balance, state, side, mode) if is_straight(state) else follow(balance, state)


def _guessed(guess: "Rod | ArrayLike", balance: Balance) -> State:
    """Edge angles from a guess, with the reactions that balance it best."""
    n = balance.edges
    if isinstance(guess, Rod):
        edges = edge_state(guess)[0]
        at = (np.arange(edges.size) + 0.5) / edges.size
        edges = np.interp((np.arange(n) + 0.5) / n, at, edges)
    else:
        edges = np.asarray(guess, dtype=float)
        if edges.shape == (n + 1,):
            edges = (edges[:-1] + edges[1:]) / 2
        if edges.shape != (n,) or not np.all(np.isfinite(edges)):
            raise InputError(
                f"guess must be a Rod or {n + 1} angles at the nodes (or {n} at the edges), got {edges.shape}"
            )
    state = State(edges, np.zeros(len(balance.held)))
    rows = balance.constraint_rows(state)
    imbalance = balance.residual(state)[0]
    reactions = (
        np.linalg.lstsq(rows @ rows.T, -rows @ imbalance, rcond=1e-9)[0] if balance.held else np.zeros(0)
    )
    return State(edges, np.asarray(reactions, dtype=float))


def _pair(value: ArrayLike | None, own: FloatArray, name: str) -> FloatArray:
    if value is None:
        return np.array(own)
    pair = np.asarray(value, dtype=float)
    if pair.shape != (2,) or not np.all(np.isfinite(pair)):
        raise InputError(f"{name} must be two finite numbers, mm, got {value!r}")
    return pair


def _end_angles(
    angles: "tuple[float | None, float | None] | ArrayLike | None", supports: Supports, present: Rod
) -> FloatArray:
    found = np.array([present.angle[0], present.angle[-1]])
    if angles is None:
        return found
    given = np.atleast_1d(np.asarray(angles, dtype=object))
    if given.shape != (2,):
        raise InputError(f"angles must be two numbers, rad, for start and end, got {angles!r}")
    for i, (value, support, name) in enumerate(zip(given, supports.ends, ("start", "end"), strict=True)):
        if value is None:
            continue
        if not support.angle:
            raise InputError(
                f"an angle is given at the {name}, but its support leaves the angle free: give None"
            )
        found[i] = float(value)
    if not np.all(np.isfinite(found)):
        raise InputError(f"angles must be finite, rad, got {angles!r}")
    return found


def _end_force(force: ArrayLike | None, supports: Supports, present: Rod) -> FloatArray:
    """Dead force at the ends that are free along x and along y."""
    both = np.array(supports.transmits_force)
    if force is not None:
        given = _pair(force, np.zeros(2), "force")
        if np.any(both & (given != 0)):
            axis = "xy"[int(np.argmax(both & (given != 0)))]
            raise InputError(
                f"a force along {axis} does nothing: both ends hold {axis}; free one end along {axis}"
            )
        return given
    own = np.zeros(2)
    before, now = present.supports.ends, supports.ends
    for i, axis in enumerate("xy"):
        # lambda at an end is minus what is applied at the last node, and what is applied at the first
        for node, sign, k in ((0, 1.0, 0), (-1, -1.0, 1)):
            if not getattr(now[k], axis) and not getattr(before[k], axis):
                own[i] = sign * present.force[node, i]
    return own


def _end_moments(moment: float | tuple[float, float] | None, supports: Supports, present: Rod) -> FloatArray:
    """Counterclockwise moments at the ends whose angle is free."""
    before, now = present.supports.ends, supports.ends
    free = [not end.angle for end in now]
    own = np.zeros(2)
    if moment is None:
        for k, (node, sign) in enumerate(((0, -1.0), (-1, 1.0))):
            if free[k] and not before[k].angle:
                own[k] = sign * present.moment[node]
        return own
    given = np.asarray(moment, dtype=float)
    if given.shape == ():
        if free == [True, True]:
            raise InputError("both ends turn freely: give the moments of both, (start, end)")
        own[free.index(True) if True in free else 0] = float(given)
    elif given.shape == (2,):
        own[:] = given
    else:
        raise InputError(f"moment must be one number or two (start, end), 1/mm, got {moment!r}")
    for k, name in enumerate(("start", "end")):
        if own[k] != 0 and not free[k]:
            raise InputError(
                f"a moment at the {name} does nothing: its support holds the angle; free the angle there"
            )
    if not np.all(np.isfinite(own)):
        raise InputError(f"moment must be finite, 1/mm, got {moment!r}")
    return own
