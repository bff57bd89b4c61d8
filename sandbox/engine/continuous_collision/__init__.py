"""Continuous collision: what would have passed through something is stopped at its time of impact.

In: the poses at both ends of a step, and what moved far in it.
Out: bodies rolled back to where they first touch what they may not pass.
Source: conservative advancement (Mirtich 1996; as b2TimeOfImpact) on the signed distance of cores.
"""
