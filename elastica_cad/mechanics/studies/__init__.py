"""Studies of a finished rod: calibration of its sheet, tolerances, how far it can be pushed."""
