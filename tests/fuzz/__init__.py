"""Damaged scenes, recordings, snapshots and commands, by the thousand: errors of the package, in time, or nothing."""
