"""What every command does alike: lengths with units, one voice for people and programs, remaking on change."""
