"""What stands behind the pytest plugin: collected files, and fixtures for tests written in Python."""
