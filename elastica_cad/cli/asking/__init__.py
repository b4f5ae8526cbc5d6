"""What is typed behind a command: options, and the records that they become."""
