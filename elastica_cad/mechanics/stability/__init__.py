"""Does a rest shape stay, or does it snap away: second variation and conjugate points (section 6.2)."""
