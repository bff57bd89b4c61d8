"""The rules, one a file; each gives its `RULE`."""
