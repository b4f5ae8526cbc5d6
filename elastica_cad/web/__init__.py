"""The studio, a web page for drawing curves that shows their strips immediately, and its server."""
