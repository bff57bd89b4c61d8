"""Pages that a browser shows without a server: a player of any run, and a report of replays that did not pass."""
