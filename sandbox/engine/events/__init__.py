"""In: the contact tables of the last two steps, the solver's reports, what sensors overlap, and what commands did.

Out: `Events`, arrays of what began, ended, struck, entered, left, slept, woke, broke, in a fixed order. A contact or an
overlap begins and ends by comparing two sorted sets of pairs, as in Box2D (Catto, Box2D v3, contact and sensor events).
"""
