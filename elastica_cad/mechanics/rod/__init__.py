"""The rod as a record and as discrete equations."""
