"""Experiments with a known outcome, run by this engine, by pymunk and by Box2D: `python -m tests.physics.truth`.

Every engine gets the same flat scene, 60 steps a second of 4 substeps each, and nothing falls asleep. What each is
given besides is said in `ours.py`, `with_pymunk.py` and `with_box2d.py`. An experiment (`falling.py` and the files
beside it) sees only the protocol `Run`, so it cannot know whom it is measuring; its truth is a closed form.
"""
