"""The plate impact with every hourglass form, elastic and elastoplastic, one and two elements
through a layer: what the choice is worth."""

from driver.plate import Result, prepared, swapRod

# model, form, elements a layer, curve to compare with, band of the lowest u_z or None: only told.
RUNS = [
    ("elastic", "physical coupled", 1, "elastic", (-6.45 * 1.03, -6.36 * 0.97)),
    ("elastic", "viscous 0.1", 1, "elastic", (-6.45 * 1.05, -6.36 * 0.95)),
    ("elastic", "stiffness 0.05", 1, "elastic", None),
    ("elastic", "physical coupled", 2, "elastic", (-6.45 * 1.03, -6.36 * 0.97)),
    ("elastic", "viscous 0.1", 2, "elastic", (-6.45 * 1.05, -6.36 * 0.95)),
    ("elastic", "stiffness 0.05", 2, "elastic", None),
    ("elastoplastic", "physical coupled", 1, "elastoplasticBbar", (-8.2, -8.0 * 0.96)),
    ("elastoplastic", "physical elastic", 1, "elastoplasticHeph", None),
    ("elastoplastic", "viscous 0.1", 1, "elastoplasticViscous", (-7.79 * 1.03, -7.79 * 0.97)),
    ("elastoplastic", "stiffness 0.05", 1, "elastoplasticBbar", None),
    ("elastoplastic", "physical coupled", 2, "elastoplasticBbar", (-8.2, -8.0 * 0.96)),
    ("elastoplastic", "physical elastic", 2, "elastoplasticBbar", None),
    ("elastoplastic", "viscous 0.1", 2, "elastoplasticBbar", (-8.2, -8.0 * 0.96)),
    ("elastoplastic", "stiffness 0.05", 2, "elastoplasticBbar", None),
]


def measure(binaries, model, form, elements, curve):
    with prepared(binaries, model, form, elements) as case:
        case.solve("-backend", "serial")
        return Result(case, curve)


def measureSwapped(binaries):
    with prepared(binaries) as case:
        swapRod(case)
        case.mesh()
        case.solve("-backend", "serial")
        return Result(case, "elastoplasticBbar")


def check(binaries, marks):
    for model, form, elements, curve, band in RUNS:
        result = measure(binaries, model, form, elements, curve)
        name = f"{model}, {form}, {elements} a layer"
        if band:
            marks.within(name, result.lowest, *band, " mm")
        else:
            marks.note(f"{name} {result.lowest:.3f} mm")
        marks.below("balance", result.balance, 0.01)
        marks.true("none released", not result.released)
