"""A page of doc/ of which a program writes one part: what stands between

    <!-- begin <name> -->
    <!-- end <name> -->
"""

import pathlib
import sys


def fill(page, name, text):
    """Puts `text` between the marks of `name`; the rest of the page stays as it is."""
    page = pathlib.Path(page)
    begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
    before, found, rest = page.read_text().partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed:
        sys.exit(f"{page}: no lines '{begin.strip()}' and '{end}' to write between")
    page.write_text(before + begin + text.strip("\n") + "\n" + end + after)
