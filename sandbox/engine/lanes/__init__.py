"""Many worlds of one scene through the memory of few.

In: worlds as rows of plain memory. Out: the same rows, some steps later, bit for bit as if each had been stepped alone.
A lane is one world with its scratch memory and machine code; a row is written into its tables, stepped, and read back.
That is allowed because a step asks nothing of scratch memory but that it be told when the tables are others
(`World.restore` rests on the same).
"""
