"""The studio: a page on which a curve is drawn while the strip follows, and the server behind it."""
