"""Files that mean harm, for driver/hostile.py: meshes, results, and what is no regular file."""

import os
import shutil

from driver.gmshFile import Hexahedra
from driver.hostileText import MESH, PROBE, RUN, body, both, fifo, whole

CONTINUE = "fpmExplicit -continue -maxSteps 20"


def folder(path):
    def prepare(root):
        shutil.rmtree(root / path, ignore_errors=True)
        (root / path).unlink(missing_ok=True) if (root / path).is_file() else None
        (root / path).mkdir(parents=True)
    return prepare


def instead(path, text="no folder"):
    """A file where a folder belongs."""
    def prepare(root):
        shutil.rmtree(root / path, ignore_errors=True)
        (root / path).write_text(text)
    return prepare


def device(path):
    """The endless file of zeros, where we may make one; else a pipe."""
    def prepare(root):
        (root / path).unlink(missing_ok=True)
        try:
            os.mknod(root / path, 0o20666, os.makedev(1, 5))
        except PermissionError:
            os.mkfifo(root / path)
    return prepare


def sparse(path, size):
    """A file that claims to be large and holds nothing."""
    def prepare(root):
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        with (root / path).open("wb") as stream:
            stream.truncate(size)
    return prepare


def unreadable(path):
    def prepare(root):
        (root / path).chmod(0)
    return prepare


def cut(path, share):
    def prepare(root):
        content = (root / path).read_bytes()
        (root / path).write_bytes(content[:int(share * len(content))])
    return prepare


def flipped(path, step):
    """Every so many bytes one is another."""
    def prepare(root):
        content = bytearray((root / path).read_bytes())
        content[::step] = bytes(byte ^ 0x55 for byte in content[::step])
        (root / path).write_bytes(content)
    return prepare


IMPORT = body('a { type file; file "m.msh"; }')


def brick():
    mesh = Hexahedra("a")
    mesh.block((1, 1, 1), lambda u, v, w: (u, v, w))
    return mesh.text()


def msh(old, new, count=1):
    """The mesh of one element with something in it that is not so."""
    text = brick()
    assert old in text, old
    return both(IMPORT, whole("m.msh", text.replace(old, new, count)))


def nodes(count):
    return msh("$Nodes\n8\n", f"$Nodes\n{count}\n")


def elements(count):
    return msh("$Elements\n1\n", f"$Elements\n{count}\n")


REFUSED = (3, 4)
MESHES = {
    "no mesh file": (MESH, (3, 4, 6), IMPORT),
    "mesh file upwards": (MESH, (3, 6), body('a { type file; file "../secret"; }')),
    "mesh file of the system": (MESH, (3, 6), body('a { type file; file "/etc/passwd"; }')),
    "mesh file is a pipe": (MESH, (3, 4, 6), both(IMPORT, fifo("m.msh"))),
    "mesh file is a folder": (MESH, (3, 4, 6), both(IMPORT, folder("m.msh"))),
    "mesh file is a device": (MESH, (3, 4, 6), both(IMPORT, device("m.msh"))),
    "mesh file of 4 TiB": (MESH, (3, 4, 6, 12), both(IMPORT, sparse("m.msh", 1 << 42))),
    "mesh file of zeros": (MESH, REFUSED, both(IMPORT, whole("m.msh", bytes(100_000)))),
    "mesh file is a script": (MESH, REFUSED, both(
        body('a { type file; file "m.geo"; }'),
        whole("m.geo", 'SystemCall "touch ../evil"; Merge "/etc/passwd";'))),
    "script in a mesh file": (MESH, REFUSED, both(
        IMPORT, whole("m.msh", 'SystemCall "touch ../evil";\n'))),
    "options beside a mesh file": (MESH, (0, 3, 4), both(
        IMPORT, whole("m.msh", brick()), whole("m.msh.opt", 'SystemCall "touch ../evil";\n'))),
    "10^15 nodes": (MESH, REFUSED, nodes(10**15)),
    "2^63 nodes": (MESH, REFUSED, nodes(2**63)),
    "-1 nodes": (MESH, REFUSED, nodes(-1)),
    "one node too many": (MESH, REFUSED, nodes(9)),
    "one node too few": (MESH, REFUSED, nodes(7)),
    "10^9 elements": (MESH, REFUSED, elements(10**9)),
    "-1 elements": (MESH, REFUSED, elements(-1)),
    "tag 2^63 - 1": (MESH, (0, *REFUSED), msh("\n8 0.0", f"\n{2**63 - 1} 0.0")),
    "tag -1": (MESH, REFUSED, msh("\n1 0.0", "\n-1 0.0")),
    "tag twice": (MESH, REFUSED, msh("\n2 ", "\n1 ")),
    "node that is not there": (MESH, REFUSED, msh("5 2 1 1 1 ", "5 2 1 1 77 ")),
    "node twice in an element": (MESH, REFUSED, msh("5 2 1 1 1 ", "5 2 1 1 8 ")),
    "10^9 tags of an element": (MESH, REFUSED, msh("5 2 1 1 ", "5 1000000000 1 1 ")),
    "element of unknown type": (MESH, REFUSED, msh("1 5 2 1 1", "1 99 2 1 1")),
    "place that is no number": (MESH, REFUSED, msh("\n1 0.0", "\n1 nan")),
    "place at infinity": (MESH, REFUSED, msh("\n1 0.0", "\n1 inf")),
    "place at 1e308": (MESH, REFUSED, msh("\n1 0.0", "\n1 1e308")),
    "part with escape sequences": (MESH, (0, *REFUSED), msh('"a"', '"\x1b[2J\x9b"')),
    "part with a name upwards": (MESH, (0, *REFUSED), msh('"a"', '"../../evil"')),
    "part of a million letters": (MESH, (0, *REFUSED), msh('"a"', '"' + "x" * 1_000_000 + '"')),
    "format of another age": (MESH, REFUSED, msh("2.2 0 8", "9.9 0 8")),
    "binary that is none": (MESH, REFUSED, msh("2.2 0 8", "2.2 1 8")),
    "numbers of 400 digits": (MESH, REFUSED, msh("\n1 0.0", "\n1 " + "9" * 400)),
    "mesh.vtkhdf of zeros": (RUN, REFUSED, whole("constant/mesh.vtkhdf", bytes(100_000))),
    "mesh.vtkhdf of 4 TiB": (RUN, (4, 6, 12), sparse("constant/mesh.vtkhdf", 1 << 42)),
    "half of mesh.vtkhdf": (RUN, (4,), cut("constant/mesh.vtkhdf", 0.5)),
    "bits of mesh.vtkhdf": (RUN, (4,), flipped("constant/mesh.vtkhdf", 1009)),
    "mesh.vtkhdf is a pipe": (RUN, (4, 6), fifo("constant/mesh.vtkhdf")),
    "mesh.vtkhdf is a folder": (RUN, (4, 6), folder("constant/mesh.vtkhdf")),
    "mesh.vtkhdf is a device": (RUN, (4, 6), device("constant/mesh.vtkhdf")),
}

NO_CHECKPOINT = (0, 5, 6)  # what is no file is none, and may be in the way of a new one
FRAME = "1e-06/fields.vtkhdf"
PLACES = {
    "controlDict is a pipe": (RUN, (3,), fifo("system/controlDict")),
    "controlDict is a folder": (RUN, (3,), folder("system/controlDict")),
    "controlDict is a device": (RUN, (3,), device("system/controlDict")),
    "controlDict that none may read": (RUN, (0, 3), unreadable("system/controlDict")),
    "constant is a file": (RUN, (3, 4, 6), instead("constant")),
    "the lock is a pipe": (RUN, (6,), fifo(".lock")),
    "the lock is a folder": (RUN, (6,), folder(".lock")),
    "the log is a folder": (RUN, (0, 6), folder("log.fpmExplicit")),
    "the log before is a folder": (RUN, (0, 6), folder("log.fpmExplicit.1")),
    "the log is a pipe": (RUN, (0, 6), fifo("log.fpmExplicit")),
    "status is a folder": (RUN, (0, 6), folder("status")),
    "status is a pipe": (PROBE, (0, 3, 6), fifo("status")),
    "status with escape sequences": (PROBE, (0, 3, 6), whole(
        "status", 'state failed;\nrunId "\x1b[2J\x9b";\nhost "\x1b[2J";\n')),
    "why.txt with escape sequences": (PROBE, (0, 3, 4), both(
        whole("why.txt", "\x1b[2J\x9b owned\n"), whole("status", "state failed;\nrunId x;\n"))),
    "why.txt is a pipe": (PROBE, (0, 3, 4), both(
        fifo("why.txt"), whole("status", "state failed;\nrunId x;\n"))),
    "postProcessing is a file": (RUN, (0, 6), instead("postProcessing")),
    "a history is a folder": (RUN, (0, 6), folder("postProcessing/energies/0/energies.dat")),
    "a history is a pipe": (RUN, (0, 6), fifo("postProcessing/energies/0/energies.dat")),
    "previous is a file": (RUN, (0, 6), instead("previous")),
    "the series is a folder": (RUN, (0, 6), folder("case.vtkhdf.series")),
    "the series is a pipe": (RUN, (0, 6), fifo("case.vtkhdf.series")),
    "a frame is a pipe": (PROBE, (0, 4, 6), fifo(FRAME)),
    "a frame is a folder": (PROBE, (0, 4, 6), folder(FRAME)),
    "a frame is a device": (PROBE, (0, 4, 6), device(FRAME)),
    "a frame of 4 TiB": (PROBE, (0, 4, 6, 12), sparse(FRAME, 1 << 42)),
    "half a frame": (PROBE, (4,), cut(FRAME, 0.5)),
    "bits of a frame": (PROBE, (0, 4), flipped(FRAME, 509)),
    "the checkpoint is a file": (RUN, (0, 6), instead("checkpoint")),
    "the checkpoint is a pipe": (CONTINUE, NO_CHECKPOINT, both(
        folder("checkpoint"), fifo("checkpoint/state.h5"))),
    "the checkpoint is a folder": (CONTINUE, NO_CHECKPOINT, folder("checkpoint/state.h5")),
    "the checkpoint is a device": (CONTINUE, NO_CHECKPOINT, both(
        folder("checkpoint"), device("checkpoint/state.h5"))),
    "a checkpoint of zeros": (CONTINUE, (5,), both(
        folder("checkpoint"), whole("checkpoint/state.h5", bytes(100_000)))),
    "a checkpoint of 4 TiB": (CONTINUE, (5,), both(
        folder("checkpoint"), sparse("checkpoint/state.h5", 1 << 42))),
    "a file called image": (RUN, (0,), sparse("image", 3 << 30)),
    "case that is a device": ("fpmExplicit -case /dev/null", (2,), lambda root: None),
    "steps without number": ("fpmExplicit -maxSteps 1e99", (2,), lambda root: None),
}

FILES = {**MESHES, **PLACES}
