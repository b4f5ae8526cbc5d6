"""How a strip is held: what its holders leave free, and the shape that it takes in them."""
