"""tests/cases/proofs.json: what fuzzers, sanitizers, coverage and mutants found when they were last run.

Their commands write it (tests/fuzz/run, tests/coverage/run, tests/mutation/run, the checks `sanitized` and
`races` with tests/cases/reliability); tests/cases/reliability makes a table of it."""

import datetime
import json

from driver.caseRun import PROJECT

FILE = PROJECT / "tests/cases/proofs.json"


def readProofs():
    return json.loads(FILE.read_text()) if FILE.exists() else {}


def noteProof(name, **figures):
    """Replaces the figures of this name, with the date of today."""
    proofs = {**readProofs(), name: {**figures, "date": datetime.date.today().isoformat()}}
    FILE.write_text(json.dumps(proofs, indent=1, sort_keys=True) + "\n")
