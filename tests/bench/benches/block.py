"""A block of n^3 hexahedra without contact: element and particle solver."""

import json
import subprocess

from benches.results import Row

SATURATION = "stiffness"  # form of the curve over the sizes


def cpuVariants(cores, largest):
    """Ways through the block; at the largest size every form, precision and vector width."""
    ways = [("serial", 1, "auto", "double", SATURATION), ("openmp", cores, "auto", "double", SATURATION),
            ("openmp", cores, "auto", "mixed", SATURATION)]
    if not largest:
        return ways
    ways += [("serial", 1, "auto", "double", form)
             for form in ("elastic", "physical", "viscous", "selective")]
    ways += [("serial", 1, simd, "double", SATURATION) for simd in ("scalar", "avx2", "avx512")]
    ways.append(("serial", 1, "auto", "double", SATURATION, "random"))
    return ways + [("serial", 1, "auto", precision, SATURATION) for precision in ("mixed", "single")]


def gpuVariants(largest):
    ways = [("cuda", 0, "auto", precision, SATURATION) for precision in ("double", "mixed", "single")]
    if largest:
        ways += [("cuda", 0, "auto", "double", form)
                 for form in ("elastic", "physical", "viscous", "selective")]
    return ways


def measure(binaries, n, steps, repeats, variants):
    """Rows of one size; what the machine lacks is left out."""
    done = subprocess.run(
        [binaries / "bench_block", str(n), str(steps), str(repeats),
         *(",".join(map(str, variant)) for variant in variants)],
        text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        raise RuntimeError(f"bench_block {n}: status {done.returncode}\n{done.stderr}")
    rows = []
    for found in map(json.loads, done.stdout.splitlines()):
        if "skipped" in found:
            print(f"  {found['variant']} left out: {found['skipped']}", flush=True)
            continue
        backend, threads, simd, precision, form, *order = found["variant"].split(",")
        simd = "" if backend == "cuda" else found["description"].split(", ")[2]
        name = ".".join(["block", form, *order, str(n)])
        rows.append(Row(name, backend, int(threads), simd, precision, "default",
                        found["elements"], 0, found["steps"], found["seconds"], 0.0,
                        found["bytesPerElementStep"], found["deviceBytes"], found["checksum"]))
    return rows


def run(machine, options):
    """Rows of one size after the other."""
    for n in options.sizes:
        largest = n == max(options.sizes)
        print(f"block {n}^3", flush=True)
        # Long enough for the clock, short enough for a million elements on one core.
        steps = options.steps or max(5, min(500, 2_000_000 // n**3))
        rows = []
        if "cpu" in options.on:
            rows += measure(machine.binaries, n, steps, options.repeats,
                            cpuVariants(machine.cores, largest))
        if machine.gpu and "gpu" in options.on:
            rows += measure(machine.binaries, n, options.steps or 200, options.repeats,
                            gpuVariants(largest))
        unique = {(row.case, row.way()): row for row in rows}  # auto is one of the vector widths
        yield list(unique.values())
