"""What a strip is made of: sheets, cross-sections, strain limits, moment-curvature laws."""
