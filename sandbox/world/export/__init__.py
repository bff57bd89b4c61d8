"""From a world back to the words of a scene file: what `build.py` does, the other way round.

What is as its author wrote it keeps its entry; of everything else only the fields that have changed are written anew.
"""
