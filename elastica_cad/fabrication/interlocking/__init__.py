"""Strips that cross in space: where their surfaces meet, and the slots that let them through."""
