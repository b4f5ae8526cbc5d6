"""Task panels; their widgets are .ui files named as the modules."""
