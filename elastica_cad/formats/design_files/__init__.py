"""Design files: a whole model in TOML, read, checked and made."""
