"""Reports of strips and models as JSON records."""
