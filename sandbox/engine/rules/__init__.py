"""In: the controls, counters, rules and paths of a scene, what a player holds, the events of a step. Out: commands.

Before a step, controls act and driven bodies get the velocities of their paths; after it, rules follow its events in
the order of the scene. All that is known from one step to the next lies in tables of the state, so a snapshot goes on
to the same bits. Event-condition-action rules (McCarthy and Dayal, The Architecture of an Active Database, 1989).
"""
