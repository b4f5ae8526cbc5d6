"""Models: strips in space, equal parts, surfaces of revolution, assemblies."""
