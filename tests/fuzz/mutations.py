# parcelImpact. License: GPL-3.0-or-later, see COPYING.
"""Entries of a dictionary file, found in its text, and what may be done to
them by mistake."""

import re

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
                    r"(?![\w.])")
VALUES = ("-1", "0", "1e300", "-1e300", "nan", "word")
WRONG_TYPE = {True: "(1 2 3)", False: "7"}      # for a number, for a word


def bare(text):
    """The text without comments, at the same places."""
    def blank(found):
        return re.sub(r"[^\n]", " ", found.group(0))
    return re.sub(r"//[^\n]*|/\*.*?\*/", blank, text, flags=re.S)


class Entry:
    def __init__(self, path, key, start, keyEnd, valueStart, end, isDict):
        self.path, self.key = path, key
        self.start, self.keyEnd = start, keyEnd
        self.valueStart, self.end, self.isDict = valueStart, end, isDict


def closing(text, at):
    depth = 0
    while at < len(text):
        depth += text[at] in "({[" and 1 or text[at] in ")}]" and -1 or 0
        if depth == 0:
            return at
        at += 1
    raise RuntimeError("unbalanced brackets")


def entries(text, at=0, end=None, path=()):
    """All entries of a bare text, those of sub-dictionaries too."""
    end = len(text) if end is None else end
    found = []
    while at < end:
        c = text[at]
        if c.isspace() or c in ";)":
            at += 1
        elif c == "#":
            at = text.find("\n", at) + 1 or end
        elif c == "$":
            # The entries of another dictionary, copied
            at = text.find(";", at) + 1 or end
        elif c in "({":
            stop = closing(text, at)
            found += entries(text, at + 1, stop, path)
            at = stop + 1
        else:
            m = re.compile(r'"[^"]*"|[^\s;(){}]+').match(text, at)
            key, after = m.group(0), m.end()
            while after < end and text[after].isspace():
                after += 1
            if after < end and text[after] == "{":
                stop = closing(text, after)
                if key != "FoamFile":
                    found.append(Entry(path, key, at, m.end(), after,
                                       stop + 1, True))
                    found += entries(text, after + 1, stop,
                                     path + (key.strip('"'),))
                at = stop + 1
                continue
            stop = after
            while stop < end and text[stop] != ";":
                stop = (closing(text, stop) if text[stop] in "({["
                        else stop) + 1
            value = text[after:stop]
            found.append(Entry(path, key, at, m.end(), after, stop + 1, False))
            if "{" in value:
                found += entries(text, after, stop, path + (key,))
            at = stop + 1
    return found


def misspelt(key):
    """A letter less, or one more in a short word. A pattern gets it where it
    matches no longer."""
    if key.startswith('"'):
        return '"x' + key[1:]
    if len(key) > 3:
        middle = len(key)//2
        return key[:middle] + key[middle + 1:]
    return key + "x"


def mutations(text, chosen=lambda entry: True):
    """(name, entry, new text) of every mistake."""
    for e in entries(bare(text)):
        if not chosen(e):
            continue
        where = "/".join(e.path + (e.key,))
        yield f"drop {where}", e, text[:e.start] + text[e.end:]
        yield (f"misspell {where}", e,
               text[:e.start] + misspelt(e.key) + text[e.keyEnd:])
        if e.isDict:
            continue
        value = text[e.valueStart:e.end - 1]
        if "{" in value or '"' in value:
            continue
        numbers = list(NUMBER.finditer(bare(value)))
        # The first number, the last and the one between them
        places = sorted({0, len(numbers)//2, len(numbers) - 1})
        for k in places if numbers else ():
            at = numbers[k]
            which = f" number {k + 1} of" if k else ""
            for new in VALUES:
                yield (f"{new}{which} {where}", e, text[:e.valueStart]
                       + value[:at.start()] + new + value[at.end():]
                       + text[e.end - 1:])
        if not numbers:
            yield (f"word {where}", e,
                   text[:e.valueStart] + "word" + text[e.end - 1:])
        yield (f"type {where}", e, text[:e.valueStart]
               + WRONG_TYPE[bool(numbers) and "(" not in value]
               + text[e.end - 1:])


def blocks(text, chosen=lambda entry: True):
    """(path, place of its end) of the dictionaries of a text, the whole
    first."""
    yield (), len(text)
    for e in entries(bare(text)):
        if e.isDict and chosen(e):
            yield e.path + (e.key.strip('"'),), e.end - 1
