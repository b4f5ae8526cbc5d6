"""Can it be cut and handled: limits of sheet, machine and stock, and the places of a part that break them."""
