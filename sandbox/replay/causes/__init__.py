"""Why a run is not as recorded: the recorded run found again, and what was changed since, in plain words."""
