"""The separating-axis test of two convex polygons. A polygon is a list of its vertices (x, y)."""

SQUARE_ONE = [(13, 10), (13, 3), (6, 3), (6, 10)]
TRIANGLE_ONE = [(14, 18), (15, 11), (10, 13)]
SQUARE_TWO = [(11, 10), (11, 3), (4, 3), (4, 10)]
TRIANGLE_TWO = [(13, 13), (8, 9), (7, 15)]


def edges(polygon):
    """The vector from each vertex to the next, and from the last one to the first."""
    vectors = []
    for i in range(len(polygon)):
        x1, y1 = polygon[i]
        x2, y2 = polygon[(i + 1) % len(polygon)]
        vectors.append((x2 - x1, y2 - y1))
    return vectors


def perpendicular(vector):
    """The same arrow, turned a quarter to the left."""
    x, y = vector
    return (-y, x)


def dot(a, b):
    """How far a goes along b, times the length of b."""
    return a[0] * b[0] + a[1] * b[1]


def length(vector):
    """A vector's dot product with itself is the square of its length."""
    return dot(vector, vector) ** 0.5


def is_convex(polygon):
    """Whether an outline that does not cross itself turns the same way at every vertex."""
    sides = edges(polygon)
    turns = [dot(perpendicular(sides[i - 1]), sides[i]) for i in range(len(sides))]
    return all(turn >= 0 for turn in turns) or all(turn <= 0 for turn in turns)


def axes(a, b):
    """The directions along which two convex polygons that are apart show a gap."""
    if not (is_convex(a) and is_convex(b)):
        raise ValueError("the test is for convex polygons: cut a concave one into convex parts")
    return [perpendicular(edge) for edge in edges(a) + edges(b)]


def project(polygon, axis):
    """How far along the axis every vertex lies, times the length of the axis."""
    return [dot(vertex, axis) for vertex in polygon]


def interval(polygon, axis):
    """The ends of the polygon's shadow on the axis: the least number and the greatest."""
    numbers = project(polygon, axis)
    low = high = numbers[0]
    for number in numbers[1:]:
        if number < low:
            low = number
        if number > high:
            high = number
    return low, high


def overlap(amin, amax, bmin, bmax):
    """Whether two intervals share more than an end."""
    return amin < bmax and bmin < amax


def rows(a, b):
    """The table: (amax, amin, bmax, bmin, gap) of one axis after the other, up to the first gap."""
    table = []
    for axis in axes(a, b):
        amin, amax = interval(a, axis)
        bmin, bmax = interval(b, axis)
        gap = not overlap(amin, amax, bmin, bmax)
        table.append((amax, amin, bmax, bmin, gap))
        if gap:
            break
    return table


def colliding(a, b):
    """Whether no axis shows a gap."""
    *_, gap = rows(a, b)[-1]
    return not gap


def metres(number, axis):
    """A number of the table as a length: without the length of the axis."""
    return number / length(axis)


def ways(amin, amax, bmin, bmax):
    """How far b has to go to leave a: forwards along the axis, and backwards."""
    return amax - bmin, bmax - amin


def way_out(a, b):
    """The shortest vector that moves b out of a, or None if the two are apart."""
    if not colliding(a, b):
        return None
    best, least = None, None
    for axis in axes(a, b):
        forwards, backwards = ways(*interval(a, axis), *interval(b, axis))
        depth = metres(min(forwards, backwards), axis)
        if best is None or depth < least:
            x, y = axis if forwards <= backwards else (-axis[0], -axis[1])
            best, least = (metres(x * depth, axis), metres(y * depth, axis)), depth
    return best


def show(title, a, b):
    """Print the table of two polygons, and what follows from it."""
    print(title)
    print("   amax  amin  bmax  bmin  gap")
    for number, (amax, amin, bmax, bmin, gap) in enumerate(rows(a, b), start=1):
        print(f"{number}  {amax:4}  {amin:4}  {bmax:4}  {bmin:4}  {'Yes' if gap else 'No':>3}")
    if colliding(a, b):
        x, y = way_out(a, b)
        print(f"colliding; the shortest way out is ({x:g}, {y:g})")
    else:
        print("not colliding")


if __name__ == "__main__":
    show("Test one", SQUARE_ONE, TRIANGLE_ONE)
    show("Test two", SQUARE_TWO, TRIANGLE_TWO)
