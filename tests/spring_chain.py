"""A chain of axial and rotary springs between two clamps; its unknowns are the coordinates of its nodes."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np


@dataclass(frozen=True, eq=False)
class SpringChain:
    """Chain with n springs.

    Attributes
    ----------
    nodes : (n+1, 2) array
        Pose, mm, in which the springs have the force `tension`.
    axial : (n,) array
        E A, N.
    bending : (n+1,) array
        E I, N mm2.
    tension : (n,) array
        N.
    clamps : (2,) array
        Angles at both ends, rad.
    """

    nodes: np.ndarray
    axial: np.ndarray
    bending: np.ndarray
    tension: np.ndarray
    clamps: np.ndarray

    @cached_property
    def differences(self):
        """Matrix from coordinates to edge vectors."""
        return np.kron(np.diff(np.eye(len(self.nodes)), axis=0), np.eye(2))

    def forces(self, x):
        """Return the gradient and the Hessian of the energy, N and N/mm, at coordinates x."""
        n, D = len(self.axial), self.differences
        lengths = np.hypot(*np.diff(self.nodes, axis=0).T)
        natural = lengths / (1 + self.tension / self.axial)
        spring = self.bending / np.concatenate(
            [[lengths[0] / 2], np.full(n - 1, lengths.mean()), [lengths[-1] / 2]]
        )
        e = (D @ x).reshape(-1, 2)
        size = np.hypot(*e.T)
        t = e / size[:, None]
        across = np.column_stack([-t[:, 1], t[:, 0]])
        angles = np.concatenate([self.clamps[:1], np.unwrap(np.arctan2(*e.T[::-1])), self.clamps[1:]])
        turned = -np.diff(spring * np.diff(angles))
        pull = self.axial * (size - natural) / natural
        gradient = D.T @ (pull[:, None] * t + (turned / size)[:, None] * across).ravel()
        by_edge = np.zeros((n, n, 2))
        by_edge[range(n), range(n)] = across / size[:, None]
        by_edge = by_edge.reshape(n, -1)
        bends = np.diag(spring[:-1] + spring[1:]) - np.diag(spring[1:-1], 1) - np.diag(spring[1:-1], -1)
        hessian = by_edge.T @ bends @ by_edge
        mixed = t[:, :, None] * across[:, None]
        blocks = (
            (self.axial / natural)[:, None, None] * t[:, :, None] * t[:, None]
            + (pull / size)[:, None, None] * across[:, :, None] * across[:, None]
            - (turned / size**2)[:, None, None] * (mixed + mixed.swapaxes(1, 2))
        )
        for i, block in enumerate(blocks):
            hessian[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] += block
        return gradient, D.T @ hessian @ D

    def rest(self, loads, pinned=(), start=None):
        """Return the nodes at rest, the forces of the supports on the nodes, and the number of unstable modes.

        `loads` are forces (2,), N, by node; `pinned` nodes stay where they are. `start` are first nodes.
        """
        force = np.zeros(self.nodes.shape)
        for node, load in loads.items():
            force[node] += load
        held = np.zeros(len(self.nodes), dtype=bool)
        held[[0, -1, *pinned]] = True
        free = np.flatnonzero(np.repeat(~held, 2))
        x = (self.nodes if start is None else start).ravel().copy()
        for _ in range(50):
            gradient, hessian = self.forces(x)
            hessian = hessian[np.ix_(free, free)]
            step = np.linalg.solve(hessian, (force.ravel() - gradient)[free])
            x[free] += step * min(1.0, 5 / max(np.abs(step).max(), 1e-30))
            if np.abs(step).max() < 1e-9:
                break
        reactions = self.forces(x)[0].reshape(-1, 2) - force
        return x.reshape(-1, 2), reactions, int(np.count_nonzero(np.linalg.eigvalsh(hessian) < 0))
