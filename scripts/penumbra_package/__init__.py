"""The parts of scripts/package: the files of the package, the rules that they follow, and the output formats."""
