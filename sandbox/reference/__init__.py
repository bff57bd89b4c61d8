"""The same scene in pymunk, the engine that contact decisions and speed are compared with."""
