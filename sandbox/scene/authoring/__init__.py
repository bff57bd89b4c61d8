"""What an author writes so as not to repeat himself: numbers by name, prefabs with parameters, parts in other files.

All of it is worked out on plain data before the models of a scene see any, and every value remembers where it was
written.
"""
