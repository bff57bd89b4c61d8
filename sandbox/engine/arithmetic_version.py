"""The number of the engine's arithmetic: raised when a change gives other bits on purpose, with a line of why."""

from __future__ import annotations

NOTES: dict[int, str] = {
    1: "the first that recordings carry",
    2: "a rigid pass for pairs just put together, finer substeps for pendulums, sliders not held at a touch",
    3: "joints push both their bodies at the second one's anchor, to keep angular momentum; angles of motors",
    4: "joints that blows tear apart are mended by displacements, no longer by velocities",
    5: "what is caught in mid-step gets the speed of its height; corners that turn in unforeseen bounce and are held",
    6: "hard blows without restitution stop both points of a contact at once; what they fall on bears them",
    7: "what overlaps is swept like all else, what is held where it touches is struck, what wakes in mid-step is held",
    8: "corners in the nook of two static shapes are held by both; links that are pressed into something slide on",
    9: "nets too dense to be factorised have soft joints; a corner of a whole also acts where a side of it just ends; "
    "contacts whose push is cut at the push-out speed grow stiffer: nothing sinks deeper than its load explains; "
    "links of one-sided chains hold what has its middle in front, and the middle of what overlaps a line stays on "
    "its side",
    10: "a body that hangs by one hinge weighs on a pile only what the law of the lever says; impulses fit when an "
    "island's substeps change; only contacts of bodies that overlap deeply take eight relax passes",
    11: "what is pressed into something immovable slides on along it in mid-step, where it stood still before; "
    "contacts that find none of 62 colours get further ones, where they were solved one by one",
    12: "the torque that a gear reports counts from the anchor of the first joint it couples, no longer from a place "
    "that another joint has left; where something heavy lands on light bodies, their pile takes twelve relax passes; "
    "friction on something immovable acts at the surface of what moves, no longer in the middle of the overlap; only "
    "the body whose own velocity or forces are too large is frozen, before anything is solved with them",
    13: "a contact without rolling resistance no longer gets the sign of a zero from others with whom it is solved",
    14: "both points of a contact get the mean of what either order of solving them gives, with one friction for both, "
    "so that what is mirrored falls mirrored; all that a hard blow without restitution reaches stops together; the "
    "relax pass is over-relaxed; what is moved out of an overlap or drawn together by a joint does not fall asleep "
    "meanwhile; contacts are of 57 Hz unless a scene says otherwise, no longer of 55",
    15: "impacts with restitution that do not end one by one in 32 sweeps, as where masses differ by over 100 to 1, "
    "are taken back and strike together; hard blows without restitution are solved until a pass takes a thousandth of "
    "the energy that all have taken",
    16: "what a scene puts down at rest has springs as long as its load asks for and does not sink; islands that begin "
    "to take shorter substeps keep the loads of their contacts, and go back one level a step; what hard blows reach is "
    "solved by Nesterov's method, further than before; the mean velocity also holds for what starts and stops in a "
    "straight line",
    17: "a pile takes finer substeps for no more of its weight than what it stands on bears: what falls takes none; "
    "the body at which a group of impacts begins is no longer left out of a hard blow in the same substep",
    18: "what hard blows without restitution reach is stopped as a step begins and where gaps close, no longer as each "
    "substep begins; only contacts of bodies that overlap deeply take eight relax passes, no longer those of others "
    "that are struck or new beside them",
    19: "rigid joints bear what they bore when a world was put down without giving way; what slides as it is put down "
    "has springs as long as its load asks for, too",
    20: "impacts without restitution that reach few bodies stop what they reach from 0.2 m/s on, no longer from 2, "
    "and down to 0.02; passes over it end by what they change of speeds, no longer of energy, and may be more "
    "in small heaps; a pile goes back to longer substeps only once it bears half of what it could there",
    21: "a body begins a substep with what contacts gave it in the one before, worked out for bodies and no longer for "
    "contacts; friction of a contact acts at one place during a step; contacts go beyond what is asked of them by what "
    "they bore before a pass; sums are in another order, and the record of a contact is laid out anew",
    22: "an impact without restitution is followed on from a body it has reached before only where it makes it 5 % "
    "faster, no longer 0.5 %; energies of passes over such impacts are worked out in another way",
    23: "contacts without friction ask for none, which changes the signs of some zeros",
    24: "what joints hold at something that does not move, each of them by a point or a length, has no weight in "
    "its pile but what it presses with on the rest of it: ropes that hang and touch take no finer substeps",
    25: "where the bounds of a part that blows have torn come to no end, only rows with bounds are left out, no longer "
    "those of its hinges as well",
    26: "rods and springs of nets are solved side by side, colour by colour, as hinges are; their force is the mean "
    "over the step of where it acted, no longer along where they lie last",
    27: "welds of nets are solved side by side as well, the anchors of each at once",
    28: "where the push of a weld's angle is cut in a net, a product is taken in the order that rods have",
    29: "finer substeps only where stiffness can hold a pile up, no longer for columns of discs, and from 60 times the "
    "mass on that weighs on a body, no longer 30, or from where it sinks in by 5 mm; what sleeps on a kinematic body "
    "that a command sets in motion wakes in the step, no longer before it",
    30: "a spring and a limit or motor of one joint share an equation of the linear system, whose unknown is what both "
    "give",
    31: "jointed parts that nothing touches and that have no limits are relaxed in the last substep of a step alone",
    32: "anchors of nets are turned from where they were when the step began, as those of contacts are",
    33: "what follows a body that runs into something slow is looked at as if that body were stopped within the "
    "step, as what follows one near something immovable was, so that rows which fall one after the other no "
    "longer overlap deeply",
    34: "impacts with restitution strike as they come about, first in, first out, no longer in the order of contacts, "
    "so that a row of balls passes them on however long it is and whichever end is its first; a contact strikes 16 "
    "times before its group strikes together, no longer in 32 sweeps",
    35: "friction acts within a blow with restitution, no longer after it, so that a rough corner rebounds as it "
    "should",
    36: "springs of what something bears look ahead of a substep only where they are fast for it, so that they no "
    "longer damp what they swing, and what is borne by them moves as they do, by the velocity at the end of a substep",
    37: "axes and anchors of contacts of what turns are those of the middle of the step, no longer of its "
    "beginning, so that what rolls and rocks no longer swings itself up; what slides over a seam is held by "
    "the next part from the step on in which it gets there; impacts on which contacts cannot agree, as "
    "between belts that draw something in, end once passes go on adding to them",
    38: "impacts without restitution that belts or kinematic bodies drive end where 32 passes bring contacts no "
    "nearer to agreeing or leave them more energy than there was, however much that grows in a pass",
    39: "impacts with restitution fall in the order of time, those that fall on a body in the same moment together, "
    "with friction within the blow; what touches as a substep ends strikes in it; what slides in mid-step is held by "
    "whatever it comes to",
    40: "joints pass impacts with restitution on at once, and what is struck rebounds all the same; springs are not as "
    "long as a blow in the first step asks for; jointed parts that something bears, or whose rigid joints would give "
    "them energy, keep to velocities, and are brought together by displacements",
    41: "stops that hold in an impact on jointed bodies are found in a guess or two; loads take up what friction turns "
    "in an impact with restitution, so that what lands flat and slides leaves flat; parts of one body and lines "
    "that abut are one surface, sensors cover nothing; springs have one stiffness whichever way they pull; rolling "
    "resistance agrees with loads and friction where contacts are solved until all agree; what falls freely takes no "
    "finer substeps for what is heavy in it",
    42: "impacts with restitution that do not end one by one strike together as soon as that is known, from the top "
    "down, each group with passes of its own",
    43: "what counts as slow or near is meant in metres, of which there are fewer where gravity is beyond any "
    "planet's; bullets and moving bodies that touch already come so deep in a step that their contact sees it, and are "
    "struck apart where that stops them",
    44: "joints with bounds are guessed to be where the substep before left them, each by what was solved, and held "
    "there where guesses go in circles; parts with motors or stops that joints would give energy keep to velocities, "
    "too; what comes to touch within a step without restitution is stopped no more often than the scene has substeps; "
    "what turns about its own centre takes no finer ones",
    45: "smaller nets have soft joints, and keep what these bear where single ones of them would turn light bodies "
    "fast; they are as stiff at every substep level, and impulses of joints fit when the level changes; what goes on "
    "pressing on something immovable sinks until its contact bears the load",
    46: "contacts of jointed bodies are soft enough for what is joined to them, and stiffen up to 2.5 times; light "
    "bodies at which heavy jointed parts stand get finer substeps",
    47: "what nothing but friction joints or slack ropes hold takes the usual substeps",
    48: "round ends that jut out of what covers a corner of their line are touched all around; jointed bodies that "
    "bounce move in other units as in metres",
    49: "where guesses at which stops of joints hold go in circles, impulses descend from those before; nets are swept "
    "twice a substep at least",
    50: "parts that are sparse but for a few bodies with many joints are factorised, with these bodies as unknowns; "
    "static tiles beside one that comes, goes or is put elsewhere know of it at once; what rattles is taken back to "
    "velocities of its own step; nobody floats once the last region is gone",
    51: "what rounding alone leaves of the impulse of a contact that bears nothing is no load, and no longer says "
    "where friction acts and what is supported",
    52: "a single point of a contact keeps its load as long as it stays at the same vertex, whatever side or corner "
    "that meets; what arrives just so, starts from rest, lies across a blow or rolls on evenly is no longer told "
    "from what does not by rounding; blows are followed by both points of a contact alike, and by what a stop "
    "does by itself where they bring a joint there; what lands flat with friction leaves flat whatever its slip; "
    "what closes in slowly strikes where it touches; blows with friction give back no more than they took",
}
"""For each number, what changed the bits. The next change appends a line; no line is ever taken away."""

ARITHMETIC = max(NOTES)
"""The number of this version. Recordings carry it, so that a divergence on purpose can say its reason."""


def changes_since(number: int) -> list[str]:
    """What changed the bits after arithmetic `number`, oldest first; nothing if that is this version's or later."""
    return [f"arithmetic {at}: {why}" for at, why in sorted(NOTES.items()) if at > number]
