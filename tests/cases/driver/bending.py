"""Bodies one element thick: with one integration point, bending is the work of the hourglass control.

Both are loaded slowly and damped critically until they rest."""

from driver.caseRun import CaseRun

# Euler-Bernoulli with shear (kappa 5/6): F L^3 / 3 E I + F L / (5/6) G A.
BEAM = 0.4 * 40**3 / (3 * 70000 * 2 * 2**3 / 12) + 0.4 * 40 / (5 / 6 * 70000 / 2.6 * 4)
# Clamped square plate under uniform pressure (Timoshenko): 0.00126532 p a^4 / D.
PLATE = 0.00126532 * 0.01 * 40**4 / (70000 / (12 * (1 - 0.3**2)))

FORMS = {
    "physical 1": "",  # the default
    "stiffness 0.05": "hourglass { form stiffness; coefficient 0.05; }\n",
    "viscous 0.1": "hourglass { form viscous; coefficient 0.1; }\n",
}


def measure(binaries, case, point, theory, form):
    """Deflection at rest over that of the theory, and how still it is."""
    with CaseRun(f"tests/cases/{case}", binaries) as run:
        run.replace("constant/partProperties", r"^(?= *bulkViscosity )", FORMS[form])
        run.mesh()
        run.solve()
        deflection = [-u for u in run.table(f"{point}/0/displacement.dat")["uz"]]
        last = deflection[-len(deflection) // 10:]
        return deflection[-1] / theory, (max(last) - min(last)) / abs(deflection[-1])


def beam(binaries, form):
    return measure(binaries, "cantilever", "tip", BEAM, form)


def plate(binaries, form):
    return measure(binaries, "clampedPlate", "centre", PLATE, form)


def check(binaries, marks):
    for name, body in (("cantilever", beam), ("clamped plate", plate)):
        ratio, unrest = body(binaries, "physical 1")
        marks.within(f"{name}, physical / theory", ratio, 0.98, 1.02)
        marks.below("unrest", unrest, 0.005)
        ratio, unrest = body(binaries, "stiffness 0.05")
        marks.note(f"stiffness 0.05: {ratio:.3f}")
        ratio, unrest = body(binaries, "viscous 0.1")
        marks.note(f"viscous 0.1: {ratio:.3g} (no rest: {unrest:.2g})")


def relaxed(binaries, marks):
    """The same bodies by dynamic relaxation, with loads applied at once, and with scaled mass."""
    for case, point, theory in (("cantilever", "tip", BEAM), ("clampedPlate", "centre", PLATE)):
        with CaseRun(f"tests/cases/{case}", binaries) as run:
            run.mesh()
            slow = run.run("fpmExplicit")
            damped = int(run.status()["steps"])
            settle(run)
            output = run.run("fpmExplicit")
            ratio = -run.table(f"{point}/0/displacement.dat")["uz"][-1] / theory
            steps = int(run.status()["steps"])
            marks.within(f"{case}, relaxed / theory", ratio, 0.98, 1.02)
            marks.below("steps of those with the mass damping of known frequency", steps / damped, 0.5)
            marks.below("balance", run.worstBalance(), 0.01)
            marks.true("told", "dynamic relaxation: at rest" in output
                       and "dynamic relaxation" not in slow)
            run.replace("system/controlDict", r"^dynamicRelaxation.*$",
                        "massScaling { factor 9; } quasiStatic { after 0; }")
            output = run.run("fpmExplicit")
            marks.true("800 % mass told", " (800 %), " in output)
            marks.true("inertia told", "more than quasiStatic.kineticShare" in output)


def settle(run):
    run.replace("system/controlDict", r"^massDamping .*$", "dynamicRelaxation { }")
    loads = (run.root / "constant/boundaryConditions").read_text().count("amplitude smooth")
    run.replace("constant/boundaryConditions", r"amplitude smooth .*\)\);", "amplitude constant;",
                loads)
