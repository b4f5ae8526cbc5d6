"""Polynomials and splines as numbers: Bernstein roots, Bezier pieces, least-squares fits."""
