"""What can happen in a scene, as data: controls of a player, rules, and the paths of driven bodies."""
