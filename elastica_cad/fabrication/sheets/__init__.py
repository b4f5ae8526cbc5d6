"""Pieces on sheets: nesting, cut lists, the bend coupon."""
