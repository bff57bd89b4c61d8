"""In: a world's records, row by row. Out: how a user sees them: columns of all bodies, one body, one joint.

Nothing is copied: a view reads the record of now, and setting a property applies a command. The source is the Proxy
pattern of Gamma, Helm, Johnson and Vlissides, Design Patterns (1994).
"""
