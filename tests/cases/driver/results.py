"""What a run left in its case, so that two runs can be compared byte by byte."""

import hashlib
import json
import os
import pathlib
import re
import shutil
import tempfile

from driver.caseRun import CaseRun
from driver.record import readTexts

RUN = re.compile(rb"\d{8}-\d{6}-[0-9a-f]{8}")  # id of a run
SEAL = 16  # bytes of the checksum behind a file of HDF5, of the id too
NOT_RESULTS = ("constant", "system", "previous", "later", "checkpoint", "failed")
LASTING = ("state", "time", "steps")  # entries of status that do not tell the hour
COUNTED = ("elements", "nodes", "contactors", "steps", "time", "lastStep", "checksum")


def content(path, name):
    """Bytes of a result without the id of the run and what depends on the clock; None: no result."""
    if name.endswith("fields.vtkhdf"):
        return RUN.sub(b"run", path.read_bytes()[:-SEAL])
    if name == "status":
        entries = statusOf(path)
        return " ".join(entries.get(key, "") for key in LASTING).encode()
    if name == "postProcessing/performance/0/performance":
        entries = readTexts(path)
        return " ".join(entries.get(key, "") for key in COUNTED).encode()
    if name.endswith(".series") or name.startswith("postProcessing/"):
        return RUN.sub(b"run", path.read_bytes())
    return None


def statusOf(path):
    """The entries of a status file that are no dictionaries of their own."""
    return {key: value.strip('"')
            for key, value in re.findall(r"^(\w+) (\S+);$", path.read_text(), re.M)}


def results(root):
    """Contents by name of all that a run leaves but its log and its checkpoints."""
    found = {}
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        if name.split("/")[0] in NOT_RESULTS or isTemporary(path) or not path.is_file():
            continue
        here = content(path, name)
        if here is not None:
            found[name] = here
    return found


def isTemporary(path):
    return path.name.startswith(".") and path.name.endswith(".tmp")


def temporaries(root):
    return [path.relative_to(root).as_posix() for path in root.rglob(".*.tmp")]


def different(found, expected):
    """Names of results that are not the same in both."""
    return sorted(name for name in found.keys() | expected.keys()
                  if found.get(name) != expected.get(name))


def damaged(found, expected):
    """Names of results of a run that ended early and are no part of those of the whole run: frames and
    records are whole, tables and lists of frames are as far as they go."""
    return sorted(name for name, here in found.items()
                  if name != "status" and not isPart(name, here, expected.get(name)))


def isPart(name, here, whole):
    if whole is None:
        return False
    if name.endswith(".dat"):
        return whole.startswith(here)
    if name.endswith(".series"):
        listed, there = (json.loads(text)["files"] for text in (here, whole))
        return listed == there[:len(listed)]
    return here == whole


def snapshot(folder, besides):
    """Hashes of all files under a folder but those under one of its own."""
    return {path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*")
            if path.is_file() and besides not in path.parents}


class Copied(CaseRun):
    """A case in a folder that somebody else keeps, made anew from `pristine` by fresh()."""

    def __init__(self, binaries, pristine, root):
        self.binaries = pathlib.Path(binaries).resolve()
        self.pristine, self.root = pristine, root
        self.fresh()

    def fresh(self):
        fresh(self.pristine, self.root)


def fastFolder():
    """A temporary folder in memory, where there is one: nothing is measured that waits for a disk."""
    memory = pathlib.Path("/dev/shm")
    usable = os.access(memory, os.W_OK) and shutil.disk_usage(memory).free > 1 << 28
    return tempfile.TemporaryDirectory(prefix="fpmCase.", dir=memory if usable else None)


def fresh(pristine, root):
    """`root` anew as a copy of a case."""
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(pristine, root, symlinks=True)
