"""Meridians of surfaces of revolution that equal strips tile without gaps (section 9.4)."""
