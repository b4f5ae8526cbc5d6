"""A strip or a whole model as one folder of files, or none."""
