"""elastica_cad."""
