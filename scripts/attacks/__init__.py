"""The rows of scripts/attack. Each file is one kind of attack; arena.py has what they share."""
