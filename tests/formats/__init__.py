"""Files of other programs: from them to scenes, and back."""
