"""The stiffness profile of least ratio that makes a drawn curve a rest shape (Eqs. 4 and 6, section 5.3)."""
