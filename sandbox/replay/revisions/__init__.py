"""The same run with the code of other git revisions."""
