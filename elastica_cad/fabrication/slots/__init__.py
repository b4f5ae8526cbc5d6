"""Slots in one strip: their shape, the outline they open, the marks beside them."""
