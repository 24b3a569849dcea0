"""The machine: what it is, what it can do, how fast its memory is."""

import json
import os
import pathlib
import subprocess
import time

PROJECT = pathlib.Path(__file__).resolve().parents[3]
DEVICE = 8  # exit code where the wanted device is missing


def output(*command):
    """First line of what a command says; empty where there is no such command."""
    try:
        done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              cwd=PROJECT)
    except OSError:
        return ""
    return done.stdout.splitlines()[0].strip() if done.returncode == 0 and done.stdout else ""


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return "unknown processor"


class Machine:
    def __init__(self, binaries, megabytes, repeats):
        self.binaries = pathlib.Path(binaries).resolve()
        self.cores = len(os.sched_getaffinity(0))
        self.gpu = output("nvidia-smi", "--query-gpu=name", "--format=csv,noheader")
        self.bandwidths = {}
        asked = [("serial", 1), ("openmp", self.cores)]
        if self.gpu:
            asked.append(("cuda", 0))
        for backend, threads in asked:
            done = subprocess.run(
                [self.binaries / "bench_copy", backend, str(threads), str(megabytes), str(repeats)],
                text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            if done.returncode == DEVICE:
                self.gpu = ""
                continue
            if done.returncode != 0:
                raise RuntimeError(f"bench_copy {backend}: {done.stderr}")
            found = json.loads(done.stdout)
            self.bandwidths[backend, found["threads"]] = found

    def header(self, options):
        lines = [f"{time.strftime('%Y-%m-%d %H:%M', time.gmtime())} UTC, "
                 + output(self.binaries / "fpmExplicit", "-version"),
                 f"{processor()}, {self.cores} cores, load {os.getloadavg()[0]:.1f}; "
                 + (self.gpu or "no GPU"), f"options: {options}"]
        for (backend, threads), found in self.bandwidths.items():
            name = backend if backend == "cuda" else f"{backend} x {threads}"
            lines.append(f"memory, {name}: copy {found['copy'] / 1e9:.4g} GB/s, "
                         f"triad {found['triad'] / 1e9:.4g} GB/s")
        return lines
