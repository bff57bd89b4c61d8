"""In: a command, plain data, and the world it is for. Out: changed records, and what of the world's books it touched.

Each command is checked as a whole before it changes anything. The Command pattern of Gamma, Helm, Johnson and
Vlissides, Design Patterns (1994): what is done to a world is an object, so that it can be recorded, sent and repeated.
"""
