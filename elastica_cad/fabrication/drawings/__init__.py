"""Drawings on named layers: lettering, kerf, holding bridges, colours."""
