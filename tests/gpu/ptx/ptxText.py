"""Functions and statements of PTX text as nvcc writes it (PTX ISA, one module)."""

import re

SKIPPED = (".loc ", ".loc\t", ".file", ".version", ".target", ".address_size", ".pragma")
HEAD = re.compile(r"(?:\.visible\s+|\.weak\s+)?\.(entry|func)\s+(?:\(.*?\)\s*)?([\w$]+)")
PARAMETER = re.compile(r"\.param\s+(?:\.align\s+\d+\s+)?\.\w+\s+([\w$]+)(?:\[(\d+)\])?")


class Function:
    """kind: entry (a kernel) or func; parameters: their names in order; statements: labels, braces,
    declarations and instructions, each as one string."""

    def __init__(self, kind, name, parameters, statements):
        self.kind, self.name, self.parameters, self.statements = kind, name, parameters, statements


def plainLines(text):
    """Without comments, and without what is said for debuggers."""
    for line in re.sub(r"/\*.*?\*/", "", text, flags=re.S).split("\n"):
        line = line.split("//")[0].strip()
        if line.startswith(".section"):
            return
        if line and not line.startswith(SKIPPED):
            yield line


def statementsOf(lines):
    """Lines of a body, those of one statement joined."""
    begun = ""
    for line in lines:
        if line in ("{", "}") or re.fullmatch(r"[\w$]+:", line):
            yield line
            continue
        begun = (begun + " " + line).strip()
        if begun.endswith(";"):
            yield begun
            begun = ""


def bodyOf(lines, at):
    """Lines between the brace at `at` and its partner, and where to go on."""
    depth, end = 0, at
    while True:
        depth += {"{": 1, "}": -1}.get(lines[end], 0)
        end += 1
        if depth == 0:
            return lines[at + 1:end - 1], end


def functions(text, shared):
    """All functions of a module that declares no data but the dynamic shared memory `shared`."""
    lines, found, at = list(plainLines(text)), [], 0
    while at < len(lines):
        match = HEAD.match(lines[at])
        if not match:
            if lines[at].startswith(".extern .shared") and shared not in lines[at]:
                raise ValueError(f"other shared memory than {shared}: {lines[at]}")
            if lines[at].startswith((".global", ".const", ".visible .global", ".visible .const")):
                raise ValueError(f"data of the module: {lines[at][:120]}")
            at += 1
            continue
        head = ""
        while lines[at] != "{" and not lines[at].endswith(";"):
            head += " " + lines[at]
            at += 1
        if lines[at] != "{":  # declared, not defined
            at += 1
            continue
        body, at = bodyOf(lines, at)
        found.append(Function(match.group(1), match.group(2),
                              [name for name, size in PARAMETER.findall(head)],
                              list(statementsOf(body))))
    return found
