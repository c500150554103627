"""What scripts/package is made of: which files the package has, the rules they keep, and the forms it leaves in."""
