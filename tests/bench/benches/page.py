"""The table of doc/performance.md: what was measured, a line a variant."""

import statistics
import sys

from benches.machine import PROJECT

NAME = "tests/bench/run"
SCENES = ("block", "layers", "plate", "tube")
HEADINGS = ("scene", "elements", "contactors", "run on", "precision", "algorithm",
            "ns per element-step", "spread", "contact", "bytes an element")


def shown(rows):
    """Blocks of the largest size, and every scene; the ladder and busy machines are other questions."""
    sizes = [row.elements for row in rows if row.case.startswith("block.")]
    for row in rows:
        scene = row.case.split(".")[0]
        if scene == "block" and row.elements < max(sizes):
            continue
        if scene in SCENES and ".noContact" not in row.case and ".busy" not in row.case:
            yield row


def line(row):
    ns = [row.nanoseconds(seconds) for seconds in row.seconds]
    middle = statistics.median(ns)
    machine = row.backend if row.backend == "cuda" else f"{row.backend} x {row.threads}, {row.simd}"
    spread = f"{100 * (max(ns) - min(ns)) / middle:.0f} %" if len(ns) > 1 else "-"
    contact = f"{100 * row.contactShare:.0f} %" if row.contactors and row.contactShare is not None else "-"
    return (row.case, str(row.elements), str(row.contactors or "-"), machine, row.precision,
            row.algorithm, f"{middle:.4g}", spread, contact, f"{row.memory / row.elements:.0f}")


def table(rows, header):
    """What stands between the marks: machine and date, then the lines."""
    text = [f"- {entry}" for entry in header] + [""]
    text += ["| " + " | ".join(HEADINGS) + " |", "|---" * len(HEADINGS) + "|"]
    return "\n".join(text + ["| " + " | ".join(line(row)) + " |" for row in shown(rows)])


def write(page, rows, header):
    sys.path.insert(0, str(PROJECT / "etc"))  # not there in a bundle for another machine
    import markedBlock

    markedBlock.fill(page, NAME, table(rows, header))
