"""The studio: a web page for drawing curves, which shows the strip at once, and its server."""
