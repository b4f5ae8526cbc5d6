"""Sequential quadratic programming with a trust region and an exact penalty; it knows no rods."""
