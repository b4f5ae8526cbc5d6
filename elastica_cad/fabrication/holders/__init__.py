"""What holds the ends of strips: fixtures, base plates, slotted frames, rings."""
