"""The same bits: every scene in every setting against the others and against a recorded table.

A scene is hashed output by output: its mesh, the state of the solver, every history, the health table
and every field of the last frame. Backend, threads, vector width and assembly change none of them;
precision does and has rows of its own in tests/cases/bits.csv. The numbers of the kernels do not depend
on the machine: they use +, -, *, /, sqrt and fma, contraction is off, exp and log are our own. The
mesher asks the C library for sines; where those differ, so does `mesh`, and the table says nothing."""

import csv
import hashlib
import re

from driver.bitContact import CONTACT
from driver.bitScenes import SCENES as OTHERS
from driver.bitTutorials import TUTORIALS
from driver.caseRun import DEVICE, PROJECT, CaseRun, Failed
from driver.equalBits import missing
from driver.record import readTexts

SCENES = {**OTHERS, **CONTACT, **TUTORIALS}
TABLE = PROJECT / "tests/cases/bits.csv"
PRECISIONS = ("double", "mixed", "single")
LONGER = 4  # times the steps of the short form


def settings(backend, threads, widths, assembly="patch"):
    extra = ("-threads", str(threads)) if threads else ()
    return {f"{backend}{threads or ''} {simd} {assembly}":
            ("-backend", backend, "-simd", simd, *extra, assembly) for simd in widths}


FEW = {**settings("serial", 0, ("scalar",)), **settings("openmp", 2, ("avx2",))}
SHORT = {"double": {**FEW, **settings("serial", 0, ("avx512",))}, "mixed": FEW, "single": FEW}
LONG = dict.fromkeys(PRECISIONS, {
    **settings("serial", 0, ("scalar", "avx2", "avx512")),
    **settings("openmp", 2, ("scalar", "avx2", "avx512")), **settings("openmp", 3, ("avx2",), "gather")})
CUDA = dict.fromkeys(PRECISIONS, {**settings("serial", 0, ("scalar",)),
                                  "cuda": ("-backend", "cuda", "patch")})


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()[:8]


def numbers(path):
    """The rows of a table without its heading."""
    return "".join(line + "\n" for line in path.read_text().splitlines() if line[:1] != "#")


def meshOf(case):
    label = (case.root / "constant/mesh.vtkhdf").read_bytes()[-400:]
    return re.search(rb"mesh ([0-9a-f]{16})", label).group(1).decode()[:8]


def histories(case):
    """Hashes of the numbers of every history and of the health table, whose words may change."""
    out, folder = {}, case.root / "postProcessing"
    for path in sorted(folder.glob("*/0/*.dat")):
        name = "/".join(path.relative_to(folder).with_suffix("").parts[::2])
        out[name] = digest(numbers(path))
    figures = readTexts(folder / "health/0/health")["figures"]
    out["health/health"] = digest(" ".join(
        row.get(key, other) for row in figures
        for key, other in (("value", ""), ("limit", "0"), ("time", "-1"), ("verdict", ""))))
    return out


NODE = ("U", "V", "FCONT", "CPRESS", "GAP")
FIELDS = (*NODE, "S", "Mises", "PEEQ", "HourglassEnergy", "BendingEnergy", "Utilisation", "TEMP",
          "STATUS")


def frameFields(case):
    """Hashes of the sums of every field of the frames."""
    frame = max(case.root.glob("*/fields.vtkhdf"), key=lambda path: float(path.parent.name))
    content = frame.read_bytes()
    fields = [name for name in FIELDS if name.encode() + b"\0" in content]
    (case.root / "system/probeDict").write_text("tables\n{\n" + "".join(
        f"sum_{name} {{ type sum; field {name}; }}\n" for name in fields) + "}\n")
    case.run("fpmProbe")
    folder = case.root / "postProcessing"
    return {f"frames/{name}": digest(numbers(folder / f"sum_{name}/0/{name}.dat")) for name in fields}


def solved(case, steps, precision, way, frames):
    """Hashes by output of a run; None where the processor has no such vectors."""
    *options, assembly = way
    case.setEntry("assembly", assembly)
    done = case.start("fpmExplicit", "-precision", precision, "-maxSteps", str(steps), *options)
    if done.returncode == DEVICE:
        return None
    if done.returncode != 0:
        tail = "\n".join(done.stdout.splitlines()[-12:])
        raise Failed(f"{precision}, {' '.join(way)}: status {done.returncode}\n{tail}")
    out = {"mesh": meshOf(case), "state": CaseRun.checksum(done.stdout), **histories(case)}
    return {**out, **frameFields(case)} if frames else out


def differences(found, expected):
    """Names of the outputs that differ, of those both have."""
    return [name for name in expected if name in found and found[name] != expected[name]]


def stepsOf(scene):
    """Of the short and the long form; none of a scene that is no more."""
    return [SCENES[scene][1] * times for times in (1, LONGER)] if scene in SCENES else []


class Recorded:
    """tests/cases/bits.csv: hashes by scene, steps and precision."""

    def __init__(self):
        self.rows = {}
        if TABLE.exists():
            with TABLE.open() as file:
                for scene, steps, precision, outputs in list(csv.reader(file))[1:]:
                    self.rows[scene, int(steps), precision] = dict(
                        word.split("=") for word in outputs.split())

    def judge(self, key, found):
        """What is wrong, or an empty text."""
        if key not in self.rows:
            return "not in the table: bits -record"
        expected = self.rows[key]
        differ = differences(found, expected)
        if "mesh" in differ:
            return "another mesh: other sines of the C library, or fpmMesh has changed"
        missing = sorted(expected.keys() ^ found.keys())
        return ", ".join(differ + [f"{name} not in both" for name in missing])

    def save(self):
        with TABLE.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(("scene", "steps", "precision", "outputs"))
            for (scene, steps, precision), outputs in sorted(self.rows.items()):
                if steps not in stepsOf(scene):
                    continue  # of a scene as it was
                writer.writerow((scene, steps, precision, " ".join(
                    f"{name}={value}" for name, value in outputs.items())))


def judgeScene(binaries, name, settings, recorded, record, absent):
    """Failures of one scene in every setting, as texts; settings this machine has not go to `absent`."""
    make, steps = SCENES[name]
    steps *= LONGER if settings is LONG else 1
    failures = []
    with make(binaries) as case:
        case.mesh()
        for precision in PRECISIONS:
            key, first = (name, steps, precision), None
            for way, options in settings[precision].items():
                found = solved(case, steps, precision, options, first is None)
                if found is None:
                    absent.add(way)
                    continue
                if first is None:
                    first = found
                    if record:
                        recorded.rows[key] = found
                    elif settings is LONG and key not in recorded.rows:
                        continue  # compared among the settings alone
                    elif wrong := recorded.judge(key, found):
                        failures.append(f"{name}, {precision}, {steps} steps: {wrong}")
                elif differ := differences(found, first):
                    failures.append(f"{name}, {precision}, {way}: not as on one thread by scalars: "
                                    f"{', '.join(differ)}")
    return failures


def judgeAll(binaries, marks, names, settings, record=False):
    recorded, absent = Recorded(), set()
    for name in names or SCENES:
        try:
            marks.failures += judgeScene(binaries, name, settings, recorded, record, absent)
        except Failed as failure:
            marks.failures.append(f"{name}: {failure}")
    count = sum(len(settings) for settings in settings.values())
    marks.note(f"{len(names or SCENES)} scenes in {count} settings")
    if absent:
        marks.note(f"this machine has no {', '.join(sorted(absent))}")
    if record:
        recorded.save()
        marks.note(f"written {TABLE.relative_to(PROJECT)}")


def check(binaries, marks):
    judgeAll(binaries, marks, (), SHORT)


def full(binaries, marks):
    judgeAll(binaries, marks, (), LONG)


def gpu(binaries, marks):
    with SCENES["bar"][0](binaries) as case:
        case.mesh()
        if why := missing(binaries, case, ("-backend", "cuda", "-maxSteps", "1")):
            return why
    judgeAll(binaries, marks, (), CUDA)
    return None
