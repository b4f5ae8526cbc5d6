"""One strip: its request, its style, its flat outline, and the strip as it is built."""
