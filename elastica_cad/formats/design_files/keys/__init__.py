"""What may be written in a design file: the keys of every table, for its readers, its JSON schema and its page."""
