"""Parametric objects. Users' files name these modules and classes: they are never moved or renamed."""
