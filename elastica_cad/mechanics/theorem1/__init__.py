"""Theorem 1: can a flat strip take a drawn curve, and if not, where and why not."""
