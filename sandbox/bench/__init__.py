"""One scene in several engines, side by side: who takes how long, and how well it goes."""
