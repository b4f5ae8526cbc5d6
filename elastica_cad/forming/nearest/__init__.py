"""The nearest rod to a drawn curve that meets limits: the problem in numbers, and advice on its answer."""
