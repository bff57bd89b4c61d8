"""Contacts of the middle of the step, against the narrow phase there and against closed forms."""
