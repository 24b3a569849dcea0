"""What a benchmark leaves: results.csv, results.md and the saturation curve."""

import csv
import dataclasses
import pathlib
import shutil
import statistics
import subprocess

COLUMNS = ("case", "backend", "threads", "simd", "precision", "algorithm", "elements", "contactors",
           "steps", "wall_s", "ns_per_element_step", "ns_per_contactor_step", "contact_share",
           "bytes_per_element", "memory_per_element", "checksum")


@dataclasses.dataclass
class Row:
    """One variant of one case; `seconds` of every repeat."""

    case: str
    backend: str
    threads: int
    simd: str
    precision: str
    algorithm: str
    elements: int
    contactors: int
    steps: int
    seconds: list
    contactShare: float | None
    bytesPerElement: float | None  # of elements and nodes, a step; None where contact adds to them
    memory: int  # bytes the solver holds on its device
    checksum: str

    @property
    def wall(self):
        return statistics.median(self.seconds)

    def nanoseconds(self, seconds):
        return 1e9 * seconds / (self.elements * self.steps)

    def perContactor(self):
        if self.contactShare is None or not self.contactors:
            return None
        return 1e9 * self.wall * self.contactShare / (self.contactors * self.steps)

    def values(self):
        """As COLUMNS; what is not known is empty."""
        known = [self.case, self.backend, self.threads, self.simd, self.precision, self.algorithm,
                 self.elements, self.contactors, self.steps, f"{self.wall:.6g}",
                 f"{self.nanoseconds(self.wall):.5g}"]
        for value in (self.perContactor(), self.contactShare, self.bytesPerElement,
                      self.memory / self.elements):
            known.append("" if value is None else f"{value:.4g}")
        return known + [self.checksum]

    def way(self):
        """Everything but the size, in words."""
        threads = f" x {self.threads}" if self.backend == "openmp" else ""
        simd = "" if self.backend == "cuda" else f" {self.simd}"
        return f"{self.backend}{threads}{simd} {self.precision}"


def writeCsv(path, rows):
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        table.writerows(row.values() for row in rows)


def markdown(rows, bandwidths):
    """Table with the median, the least and the spread, and the share of the copy bandwidth used."""
    lines = ["| case | backend | vector width | precision | algorithm | elements | contactors | "
             "steps | median ns | least ns | spread | contact | GB/s | of copy | bytes held | checksum |",
             "|" + "---|" * 16]
    for row in rows:
        ns = [row.nanoseconds(seconds) for seconds in row.seconds]
        rate = share = ""
        if row.bytesPerElement is not None:
            used = row.bytesPerElement / statistics.median(ns)
            rate = f"{used:.3g}"
            copy = bandwidths.get((row.backend, row.threads))
            share = f"{100 * used / (copy['copy'] / 1e9):.0f} %" if copy else ""
        contact = "" if row.contactShare is None else f"{100 * row.contactShare:.1f} %"
        threads = "" if row.backend == "cuda" else f" x {row.threads}"
        lines.append("| " + " | ".join(map(str, (
            row.case, row.backend + threads, row.simd, row.precision, row.algorithm, row.elements,
            row.contactors, row.steps, f"{statistics.median(ns):.4g}", f"{min(ns):.4g}",
            f"{100 * (max(ns) - min(ns)) / statistics.median(ns):.0f} %", contact, rate, share,
            f"{row.memory / row.elements:.0f}", row.checksum))) + " |")
    return "\n".join(lines)


def differingChecksums(rows):
    """Cases whose state depends on backend, threads or vector width: there should be none."""
    found = {}
    for row in rows:
        found.setdefault((row.case, row.precision, row.algorithm, row.elements, row.steps),
                         set()).add(row.checksum)
    return [f"{key[0]} ({key[1]}, {key[2]}, {key[3]} elements): {', '.join(sorted(sums))}"
            for key, sums in found.items() if len(sums) > 1]


def curves(rows):
    """Series of points (elements, ns) of what was run in several sizes, by name."""
    series = {}
    for row in rows:
        case = ".".join(word for word in row.case.split(".") if not word.isdigit())
        algorithm = "" if row.algorithm == "default" else f" {row.algorithm}"
        series.setdefault(f"{case} {row.way()}{algorithm}", []).append(
            (row.elements, row.nanoseconds(row.wall)))
    return {name: sorted(points) for name, points in series.items() if len(points) > 1}


def drawCurves(folder, rows, binaries):
    """saturation.svg: ns per element-step over the number of elements, by fpmProbe."""
    series = curves(rows)
    if not series:
        return None
    case = folder / "saturation"
    (case / "system").mkdir(parents=True, exist_ok=True)
    entries = []
    for number, (name, points) in enumerate(series.items()):
        file = f"curve{number}.csv"
        text = "".join(f"{elements},{ns:.6g}\n" for elements, ns in points)
        (case / file).write_text("elements,ns\n" + text)
        entries.append(f'curve{number} {{ file "{file}"; x elements; y ns; label "{name}"; }}')
    (case / "system/controlDict").write_text("// Marks a case; only its probeDict is used.\n")
    (case / "system/probeDict").write_text(
        'plots\n{\n    saturation\n    {\n        title "Time of an element and step";\n'
        '        xLabel "elements"; yLabel "ns per element-step";\n'
        "        xAxis logarithmic; yAxis logarithmic;\n        series\n        {\n"
        + "".join(f"            {entry}\n" for entry in entries) + "        }\n    }\n}\n")
    done = subprocess.run([pathlib.Path(binaries) / "fpmProbe", "-case", case], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise RuntimeError(f"fpmProbe: status {done.returncode}\n{done.stdout}")
    picture = folder / "saturation.svg"
    shutil.copy(case / "postProcessing/plots/saturation.svg", picture)
    return picture
