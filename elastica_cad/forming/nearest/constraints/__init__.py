"""What a nearest rod keeps and the limits that it meets, as numbers with their derivatives."""
