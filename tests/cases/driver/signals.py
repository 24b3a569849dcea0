"""Signals at random instants of a run: those that stop it leave a checkpoint and code 75, others let it go
on; continued, it ends as if there had been none."""

import pathlib
import random
import signal
import time

from driver.caseRun import Failed
from driver.kills import ACKNOWLEDGED, Killer
from driver.results import different, fastFolder, fresh, isPart, results

STOPPED = 75
STOP = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU)
BEFORE = 0.02  # seconds in which a program is not yet a run; a signal then ends it as any program


def sent(killer, numbers, delay):
    """Starts or continues the run and sends it signals after some seconds; code and output."""
    process = killer.started("-continue")
    time.sleep(delay)
    for number in numbers:
        process.send_signal(number)
    output = process.communicate(timeout=120)[0]
    return process.returncode, output


def withoutStops(found, expected):
    """A run that is stopped writes a frame where it stops, which is no damage: results without it."""
    extra = [name for name in found if name.endswith("fields.vtkhdf") and name not in expected]
    out = {name: here for name, here in found.items() if name not in extra}
    for name in out:
        if name.endswith(".series"):
            lines = [line for line in out[name].decode().splitlines()
                     if not any(frame in line for frame in extra)]
            out[name] = "\n".join([*lines, ""]).replace("},\n  ]", "}\n  ]").encode()
    return out


def stopped(killer, marks, draw):
    """One signal that stops: at most one step is lost, that is, the checkpoint is of the end."""
    number = draw.choice(STOP)
    code, output = sent(killer, [number], BEFORE + draw.uniform(0, killer.seconds))
    if code == -number or code == 0:
        return 0  # before the run, or after it
    if code != STOPPED:
        raise Failed(f"{number.name}: status {code}\n{output[-1500:]}")
    if not ACKNOWLEDGED.search(output):
        marks.failures.append(f"{number.name}: no checkpoint\n{output[-800:]}")
    for name, here in withoutStops(results(killer.root), killer.expected).items():
        if name.endswith((".vtkhdf", ".series")) and not isPart(name, here, killer.expected[name]):
            marks.failures.append(f"{number.name}: {name} is damaged")
    return 1


def check(binaries, marks, count=20):
    draw, stops = random.Random(11), 0
    with fastFolder() as name:
        killer = Killer(binaries, marks, pathlib.Path(name).resolve())
        while stops < count and not marks.failures:
            fresh(killer.pristine, killer.root)
            stops += sum(stopped(killer, marks, draw) for _ in range(4))
            killer.finish("continued", "-continue")
            found = withoutStops(results(killer.root), killer.expected)
            if other := different(found, killer.expected):
                marks.failures.append(f"after stops: {', '.join(other)} not as in one run")
        code = -signal.SIGUSR1
        while code == -signal.SIGUSR1:  # it came before the program was loaded
            fresh(killer.pristine, killer.root)
            code, _ = sent(killer, [signal.SIGUSR1], BEFORE + killer.seconds / 2)
        marks.true(f"SIGUSR1: status {code}, as in one run",
                   code == 0 and not different(results(killer.root), killer.expected))
    marks.note(f"{stops} stops by {', '.join(one.name for one in STOP)}")
    marks.true("code 75, a checkpoint, whole files; continued as in one run", not marks.failures)
