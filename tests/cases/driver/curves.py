"""Tables of numbers and how far two curves are apart."""

import bisect
import math


def readTable(path):
    """Columns by name: '# time ux uy' and blanks, or '# t,uz' and commas; other # lines are notes."""
    names, rows = [], []
    with open(path) as lines:
        for line in lines:
            if line.startswith("#"):
                names = line[1:].replace(",", " ").split()
            elif line.strip():
                rows.append([float(word) for word in line.replace(",", " ").split()])
    return {name: [row[i] for row in rows] for i, name in enumerate(names)}


def at(x, xs, ys):
    """Linear interpolation; the end values hold outside."""
    if x <= xs[0]:
        return ys[0]
    if x >= xs[-1]:
        return ys[-1]
    i = bisect.bisect_right(xs, x)
    return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1])


def relativeL2(xs, ys, referenceXs, referenceYs, end=math.inf):
    """Root of the sum of squared differences at the reference's points, over that of the reference."""
    difference = norm = 0.0
    for x, y in zip(referenceXs, referenceYs):
        if x > end:
            break
        difference += (at(x, xs, ys) - y) ** 2
        norm += y * y
    return math.sqrt(difference / norm)


def lowest(xs, ys):
    """The smallest value and where it is."""
    least = min(ys)
    return least, xs[ys.index(least)]
