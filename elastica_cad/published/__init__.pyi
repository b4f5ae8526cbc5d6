from elastica_cad.published.enforce_constraints import (
    EnforcedCurve as EnforcedCurve,
    enforce_constraints as enforce_constraints,
)
from elastica_cad.published.optimize_ratio import (
    OptimizedRatio as OptimizedRatio,
    RatioStatus as RatioStatus,
    optimize_ratio as optimize_ratio,
)
from elastica_cad.published.recover_stability import (
    RecoveredStability as RecoveredStability,
    RecoveryStatus as RecoveryStatus,
    recover_stability as recover_stability,
)
