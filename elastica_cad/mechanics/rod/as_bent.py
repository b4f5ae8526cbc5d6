"""A rod whose stiffness follows its bend, as one that is as stiff as its shape makes it."""

from dataclasses import replace

from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.rod.curling_law import CurlingLaw
from elastica_cad.mechanics.rod.rod_record import Rod

PROFILE_SHARE = 1e-6
"""Error of the stiffness between the nodes, of its largest."""


def as_bent(rod: Rod) -> Rod:
    """A rod in balance with the stiffness that it has in its shape, whose law is the material's alone."""
    law = rod.law
    if not isinstance(law, CurlingLaw):
        return rod
    share = law.share(rod.curvature - rod.natural_curvature)
    K, B, drawn = rod.stiffness * share, rod.bending_stiffness, rod.profile
    least, follow = float(K.min()), Profile.interpolate(rod.s, share)
    profile = Profile.fit(
        lambda s: drawn(s) * follow(s) / least, rod.length, breaks=drawn.breaks, knots=drawn.knots,
        tolerance=PROFILE_SHARE * float(K.max()) / least,
    )  # fmt: skip
    weight = rod.weight
    if weight is not None:  # it stays what it is, whatever the stiffness
        alpha, beta = weight.along(rod.s)
        weight = replace(weight, alpha=Profile.interpolate(rod.s, alpha + beta * rod.stiffness), beta=0.0)
    return replace(
        rod, law=law.below, stiffness=K / least, profile=profile, weight=weight, moment=rod.moment / least,
        force=rod.force / least, bending_stiffness=B and B * least,
    )  # fmt: skip
