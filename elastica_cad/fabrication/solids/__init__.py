"""Bodies of flat and bent strips as boundary records that a CAD kernel only translates."""
