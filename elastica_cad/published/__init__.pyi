from elastica_cad.published.constraint_projection import (
    EnforcedCurve as EnforcedCurve,
    enforce_constraints as enforce_constraints,
)
from elastica_cad.published.ratio_optimization import (
    OptimizedRatio as OptimizedRatio,
    RatioStatus as RatioStatus,
    optimize_ratio as optimize_ratio,
)
from elastica_cad.published.stability_recovery import (
    RecoveredStability as RecoveredStability,
    RecoveryStatus as RecoveryStatus,
    recover_stability as recover_stability,
)
