"""Bodies as triangles, and the files that hold them."""
