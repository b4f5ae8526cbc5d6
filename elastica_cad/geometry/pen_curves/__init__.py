"""What a pen tool and a file leave in a curve: where its numbers come from, tangents that rounding broke."""
