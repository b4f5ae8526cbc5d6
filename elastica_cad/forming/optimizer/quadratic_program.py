"""Small dense convex quadratic programs whose rows may be broken at a price."""

from dataclasses import dataclass

import numpy as np

from elastica_cad import _native
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.forming.optimizer.dense_solves import factor_kkt, solve_kkt

# Interior points, not HiGHS: its active-set QP was tried first and cycled without end on the programs of a
# nearly solved problem. These programs are dense, at most some hundred rows by some tens of unknowns, and
# every unknown has finite bounds (a trust region), so a dozen factorisations always suffice.
MOST_FACTORISATIONS = 60  # a dozen is usual
TOLERANCE = 1e-10  # relative: far below the error of the linear model
_BACKOFF = 0.995  # of the way to the nearest bound, which interior points do not touch
_MOST_GUESSES = 5  # of what binds, before interior points take over
_MOST_GUESSES_NEAR = 12  # the same from the solution of a program like this one
_MOST_COMPILED = 96  # rows: beyond, LAPACK's blocks are faster
_GUESS_AT = 1e-2  # of the gradient: from here interior points tell what binds
_CYCLING = 20  # factorisations after which the corrector may go round in circles, as in one of a thousand
_CENTERED = 0.3  # of mu: what steps aim at from there on, without a corrector
_BINDS = 1e-7  # of the gradient: bounds and rows with a larger multiplier bind
_AT_PRICE = 1 - 1e-6  # of a row's price: a row with a larger multiplier is broken


@dataclass(frozen=True, eq=False)
class QuadraticProgram:
    """Minimise x^T H x / 2 + g^T x + sum of row prices, with lower <= x <= upper.

    A row k stands for A_k x = r_k (or A_k x >= r_k where `one_sided`); breaking it by u costs `price[k]` u.
    A price larger than the row's multiplier makes the row exact.

    Attributes
    ----------
    hessian, gradient : (p, p), (p,) arrays
        Positive semidefinite.
    lower, upper : (p,) arrays
        Finite.
    rows, right : (m, p), (m,) arrays
    price : (m,) array
        Positive.
    one_sided : (m,) boolean array
    """

    hessian: FloatArray
    gradient: FloatArray
    lower: FloatArray
    upper: FloatArray
    rows: FloatArray
    right: FloatArray
    price: FloatArray
    one_sided: BoolArray


@dataclass(frozen=True, eq=False)
class QuadraticSolution:
    """The minimum: x, and the multipliers of rows (positive pushes A x up) and of bounds.

    `converged` tells whether the tolerance was reached, `iterations` after how many factorisations.
    """

    x: FloatArray
    row_multipliers: FloatArray
    lower_multipliers: FloatArray
    upper_multipliers: FloatArray
    converged: bool
    iterations: int


def solve_quadratic(
    program: QuadraticProgram, *, accuracy: float = TOLERANCE, near: QuadraticSolution | None = None
) -> QuadraticSolution:
    """The minimum from a guess of what binds, else by interior points with Mehrotra's predictor and corrector.

    The optimum is met to `accuracy`, relative to the largest number in the gradient or on the Hessian's
    diagonal. `near` may be the solution of a program with as many unknowns and rows: what binds there is the
    first guess, which changes the time only.

    The price of a row bounds its multiplier y: the row is the pairs p (y - y_low) = 0, q (y_high - y) = 0 with
    A x - r = p - q, so that equalities, inequalities and their elastic forms are one case.

    Examples
    --------
    >>> import numpy as np
    >>> one = np.ones(1)
    >>> program = QuadraticProgram(np.eye(1), -one, -9 * one, 9 * one, np.eye(1), 3 * one, 9 * one, one > 0)
    >>> float(solve_quadratic(program).x[0].round(8))
    3.0
    """
    fixed = program.upper - program.lower < 1e-14 * (1 + np.abs(program.lower))
    if fixed.all():
        return _without_unknowns(program)
    start = None
    if near is not None and (near.x.size, near.row_multipliers.size) == (
        program.gradient.size,
        program.right.size,
    ):
        start = _Binding.of(near, program, fixed)
    easy = _by_active_sets(program, fixed, start)
    if easy is not None:
        return easy
    return _without(program, fixed, accuracy) if np.any(fixed) else _by_interior_points(program, accuracy)


def _by_interior_points(program: QuadraticProgram, accuracy: float) -> QuadraticSolution:
    """The minimum where every unknown has room, from its middle; guesses of what binds are tried on the way."""
    if _native.compiled is None or program.right.size > _MOST_COMPILED:
        return _interior_points_in_python(program, accuracy)
    p = program
    out, converged, steps = _native.interior_points(
        p.hessian, p.gradient, p.lower, p.upper, p.rows, p.right, p.price, p.one_sided, accuracy
    )
    return QuadraticSolution(*out, converged, steps)


def _interior_points_in_python(program: QuadraticProgram, accuracy: float) -> QuadraticSolution:
    scaled = _Scaled.of(program, accuracy)
    H, A, g, r = scaled.hessian, scaled.rows, scaled.gradient, scaled.right
    n, m = g.size, r.size
    low, high, up, down = slice(n), slice(n, 2 * n), slice(2 * n, 2 * n + m), slice(2 * n + m, None)
    count = 2 * (n + m)
    x, y, pairs = scaled.start()
    changes = np.empty(2 * count)
    u, v, du, dv = pairs[:count], pairs[count:], changes[:count], changes[count:]
    converged, iteration, guess_at = False, 0, _GUESS_AT * scaled.tolerance / accuracy
    while iteration < MOST_FACTORISATIONS:
        dual = H @ x + g - y @ A - v[low] + v[high]
        primal = A @ x - r - v[up] + v[down]
        product = u * v
        mu = float(product.sum()) / count
        if scaled.is_solved(mu, dual, primal):
            converged = True
            break
        if mu < guess_at:
            exact = _by_active_sets(program, np.zeros(n, dtype=bool), _Binding.nearer(program, u, v))
            if exact is not None:
                return exact
            guess_at = 0.0
        iteration += 1
        ratio = v / u
        system = factor_kkt(H, ratio[low] + ratio[high], A, ratio[up] + ratio[down])
        if system is None or not pairs.min() > 0:  # a pair has run out to zero: no step leaves it
            break
        # Predictor straight to mu = 0, then Mehrotra's corrector towards the centre it leaves room for.
        aim = -product
        for corrector in (False, True):
            change = aim / u
            dx, dy = solve_kkt(system, change[low] - change[high] - dual, change[up] - change[down] - primal)
            du[low], du[high], du[up], du[down] = dx, -dx, dy, -dy
            np.subtract(change, ratio * du, out=dv)
            worst = -float((changes / pairs).min())
            step = min(1 / _BACKOFF, 1 / worst) if worst > 0 else 1 / _BACKOFF
            if not corrector:
                after = float((u + step * du) @ (v + step * dv)) / count
                aim = mu * (after / mu) ** 3 - product - du * dv
                if iteration > _CYCLING:
                    aim = _CENTERED * mu - product
        step *= _BACKOFF
        x, y = x + step * dx, y + step * dy
        pairs += step * changes
    scale = scaled.scale
    return QuadraticSolution(x, y / scale, v[low] / scale, v[high] / scale, converged, iteration)


@dataclass(frozen=True, eq=False)
class _Scaled:
    """A program with its numbers times `scale`, and prices as bounds of the multipliers y of its rows."""

    scale: float
    hessian: FloatArray
    gradient: FloatArray
    rows: FloatArray
    right: FloatArray
    lower: FloatArray
    upper: FloatArray
    y_low: FloatArray
    y_high: FloatArray
    tolerance: float

    @classmethod
    def of(cls, program: QuadraticProgram, accuracy: float) -> "_Scaled":
        """The program over the largest number in its gradient or on its Hessian's diagonal."""
        H, g = program.hessian, program.gradient
        scale = 1 / max(1e-30, float(np.abs(g).max()), float(np.abs(np.diag(H)).max()))
        g, y_high = g * scale, program.price * scale
        y_low = np.where(program.one_sided, 0.0, -y_high)
        tolerance = accuracy * float(np.clip(np.abs(g).max(), 1e-6, 1.0))
        return cls(
            scale,
            H * scale,
            g,
            program.rows,
            program.right,
            program.lower,
            program.upper,
            y_low,
            y_high,
            tolerance,
        )

    def start(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """x and y in the middle, and the complementary pairs u v = mu there.

        Of the pairs all u come first, which are linear in (x, y): x - lower, upper - x, y - y_low, y_high - y; then
        their partners v, which are free: the bounds' multipliers z_low, z_high, and the rows' slacks p, q.
        """
        n, m = self.gradient.size, self.right.size
        inner = 0.1 * (self.upper - self.lower)
        x = np.clip(0.0, self.lower + inner, self.upper - inner)
        y = (self.y_low + self.y_high) / 2
        u = np.concatenate([x - self.lower, self.upper - x, y - self.y_low, self.y_high - y])
        mu = max(1e-3, 0.1 * float(np.abs(self.gradient) @ inner) / n)
        v = mu / u
        gap, room = self.rows @ x - self.right, v[2 * n : 2 * n + m].copy()
        v[2 * n : 2 * n + m] = room + gap / 2 + np.hypot(room, gap / 2)
        v[2 * n + m :] = np.maximum(v[2 * n : 2 * n + m] - gap, mu)
        return x, y, np.concatenate([u, v])

    def is_solved(self, mu: float, dual: FloatArray, primal: FloatArray) -> bool:
        """Are complementarity, gradient and rows met to the tolerance?"""
        met = mu < self.tolerance and _largest(dual) < 10 * self.tolerance
        return met and _largest(primal) < 10 * TOLERANCE


@dataclass(frozen=True, eq=False)
class _Binding:
    """What binds: unknowns at their bounds, rows that are met, rows that are broken with their sign (0: not).

    The multiplier of a broken row is its price, or less its price where it is an equality passed upwards.
    """

    low: BoolArray
    high: BoolArray
    met: BoolArray
    broken: FloatArray

    @classmethod
    def of(cls, solution: QuadraticSolution, program: QuadraticProgram, fixed: BoolArray) -> "_Binding":
        """What binds in a solution of a program like this one."""
        y, least = solution.row_multipliers, _BINDS * float(np.abs(program.gradient).max())
        broken = _broken(program, y, _AT_PRICE)
        met = (~program.one_sided | (y > least)) & (broken == 0)
        low, high = solution.lower_multipliers > least, solution.upper_multipliers > least
        return cls(low & ~fixed, high & ~fixed, met, broken)

    @classmethod
    def nearer(cls, program: QuadraticProgram, u: FloatArray, v: FloatArray) -> "_Binding":
        """What interior points with these pairs tend to: the smaller of each pair goes to zero."""
        n, m = program.gradient.size, program.right.size
        smaller, wide = u < v, u[2 * n + m :] < v[2 * n + m :]
        up = smaller[2 * n : 2 * n + m]
        broken = np.where(wide, 1.0, np.where(up & ~program.one_sided, -1.0, 0.0))
        return cls(smaller[:n], smaller[n : 2 * n], ~(up | wide), broken)

    def differs(self, other: "_Binding") -> int:
        """In how many places."""
        pairs = ((self.low, other.low), (self.high, other.high), (self.met, other.met))
        return sum(int(np.count_nonzero(a != b)) for a, b in (*pairs, (self.broken, other.broken)))


def _broken(program: QuadraticProgram, y: FloatArray, share: float) -> FloatArray:
    """The sign (m,) of multipliers beyond this share of their row's price: only equalities are passed upwards."""
    most = share * program.price
    return np.where(y > most, 1.0, np.where(~program.one_sided & (y < -most), -1.0, 0.0))


def _by_active_sets(
    program: QuadraticProgram, fixed: BoolArray, start: _Binding | None
) -> QuadraticSolution | None:
    """The exact minimum where guessing what binds settles at once, as it does where few bounds bind.

    What is passed binds in the next guess, and what pulls inwards does no more (primal-dual active sets); None
    as soon as the guesses do not come nearer to each other, or where those that began from `start` do not settle.
    """
    none = np.zeros(fixed.size, dtype=bool)
    bound = start or _Binding(none, none, ~program.one_sided, np.zeros(program.right.size))
    return _guess_in_python(program, fixed, bound, near=start is not None)


def _guess_in_python(
    program: QuadraticProgram, fixed: BoolArray, bound: _Binding, *, near: bool
) -> QuadraticSolution | None:
    H, g, A, r = program.hessian, program.gradient, program.rows, program.right
    lower, upper, price, one_sided = program.lower, program.upper, program.price, program.one_sided
    changed = int(np.count_nonzero(~fixed))
    for guess in range(_MOST_GUESSES_NEAR if near else _MOST_GUESSES):
        at_lower = bound.low | fixed
        free = ~(at_lower | bound.high)
        x, y = np.where(at_lower, lower, np.where(bound.high, upper, 0.0)), bound.broken * price
        inner, count = A[bound.met][:, free], int(free.sum())
        system = np.zeros((count + inner.shape[0],) * 2)
        system[:count, :count] = H[free][:, free]
        system[count:, :count] = inner
        right = np.concatenate([-(g + H @ x - y @ A)[free], (r - A @ x)[bound.met]])
        if not right.size:
            return None
        *_, solution, info = lapack().dsysv(system, right, lower=1)
        # some builds of LAPACK divide by a pivot of 1e-140 without a word
        if info != 0 or not np.all(np.isfinite(solution)):
            return None
        x[free], y[bound.met] = solution[:count], -solution[count:]
        pull, gap = H @ x + g - y @ A, A @ x - r
        beyond = _broken(program, y, 1.0)
        broken = np.where(bound.met, beyond, np.where(bound.broken * gap < 0, bound.broken, 0.0))
        following = _Binding(
            (bound.low & (pull > 0)) | (free & (x < lower)),
            (bound.high & (pull < 0)) | (free & (x > upper)),
            (~one_sided | np.where(bound.met, y > 0, (gap < 0) | (bound.broken != 0))) & (broken == 0),
            broken,
        )
        before, changed = changed, bound.differs(following)
        if changed == 0:
            low = np.where(bound.low, pull, np.where(fixed, np.maximum(pull, 0), 0.0))
            high = np.where(bound.high, -pull, np.where(fixed, np.maximum(-pull, 0), 0.0))
            return QuadraticSolution(x, y, low, high, True, guess + 1)
        if not near and 2 * changed > before:
            return None
        bound = following
    return None


def _largest(values: FloatArray) -> float:
    return float(np.abs(values).max()) if values.size else 0.0


def _without_unknowns(program: QuadraticProgram) -> QuadraticSolution:
    """Nothing to choose, as every unknown is given or there is none: rows that are broken cost their price."""
    x = program.lower
    gap = program.right - program.rows @ x
    broken = np.where(program.one_sided, gap > 0, np.sign(gap))
    y = program.price * broken
    pull = program.hessian @ x + program.gradient - y @ program.rows
    return QuadraticSolution(x, y, np.maximum(pull, 0), np.maximum(-pull, 0), True, 0)


def _without(program: QuadraticProgram, fixed: BoolArray, accuracy: float) -> QuadraticSolution:
    """The program with its fixed unknowns put in, by interior points."""
    free = ~fixed
    known = np.where(fixed, program.lower, 0.0)
    inner = _by_interior_points(
        QuadraticProgram(
            program.hessian[np.ix_(free, free)], (program.gradient + program.hessian @ known)[free],
            program.lower[free], program.upper[free], np.ascontiguousarray(program.rows[:, free]),
            program.right - program.rows @ known, program.price, program.one_sided,
        ),
        accuracy,
    )  # fmt: skip
    x = known.copy()
    x[free] = inner.x
    reduced = program.hessian @ x + program.gradient - inner.row_multipliers @ program.rows
    low, high = np.where(fixed, np.maximum(reduced, 0), 0.0), np.where(fixed, np.maximum(-reduced, 0), 0.0)
    low[free], high[free] = inner.lower_multipliers, inner.upper_multipliers
    return QuadraticSolution(x, inner.row_multipliers, low, high, inner.converged, inner.iterations)
