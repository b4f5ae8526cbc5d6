"""What acts on a rod: supports of its ends, gravity, hung weights; and the arguments that name them."""
