"""The studio: a web page for drawing curves, which shows their strips immediately, and its server."""
