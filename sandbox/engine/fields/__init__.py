"""Fields: regions of water, wind and gravity, and thrusters come in; forces on bodies for the coming step go out.
Archimedes' principle and Newton's impact law over areas clipped exactly (I. Sutherland, G. Hodgman 1974; Green's
theorem), taken in mid-step as by the leapfrog method.
"""
