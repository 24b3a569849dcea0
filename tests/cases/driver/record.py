"""Records that runs write for programs: dictionaries of numbers, texts and lists of dictionaries."""

import re

TOKEN = re.compile(r'\s+|//[^\n]*|"(?P<text>[^"\n]*)"|(?P<mark>[(){};])|(?P<word>[^\s(){};"]+)')


def tokens(text):
    """(kind, text) of each; anything that is no token is an error."""
    at = 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"no record: {text[at:at + 40]!r}")
        if match.lastgroup:
            yield match.lastgroup, match.group(match.lastgroup)
        at = match.end()


def value(kind, text):
    """A number where it is written as one; whole ones as int."""
    if kind == "word":
        for number in (int, float):
            try:
                return number(text)
            except ValueError:
                pass
    return text


def entries(stream, valueOf=value):
    """Up to the closing bracket or the end: key value; or key ( { ... } ... );"""
    found = {}
    for kind, key in stream:
        if (kind, key) == ("mark", "}"):
            break
        token = next(stream)
        if token == ("mark", "("):
            found[key] = []
            while next(stream) == ("mark", "{"):
                found[key].append(entries(stream, valueOf))
        else:
            found[key] = valueOf(*token)
        if next(stream) != ("mark", ";"):
            raise ValueError(f"no ';' after {key}")
    return found


def readRecord(path):
    return entries(tokens(path.read_text()))


def readTexts(path):
    """The same with every value as it is written."""
    return entries(tokens(path.read_text()), lambda kind, text: text)
