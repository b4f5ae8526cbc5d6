"""Files read and written with care: sources that exist, targets that appear whole or not at all."""
