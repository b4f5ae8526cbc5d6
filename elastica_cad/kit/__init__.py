"""A whole model as one folder of files, or none."""
