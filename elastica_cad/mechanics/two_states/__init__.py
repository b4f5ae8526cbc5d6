"""Two drawn curves and one strip: can it rest in both, and how it is made."""
