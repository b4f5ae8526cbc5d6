"""Curves changed through their control points: constraints that hold, waves that are made fair."""
