from elastica_cad.paper.control_points import (
    enforce_constraints as enforce_constraints,
    EnforcedCurve as EnforcedCurve,
)
from elastica_cad.paper.control_points import (
    optimize_ratio as optimize_ratio,
    OptimizedRatio as OptimizedRatio,
    RatioStatus as RatioStatus,
    recover_stability as recover_stability,
    RecoveredStability as RecoveredStability,
    RecoveryStatus as RecoveryStatus,
)
