#!/usr/bin/env python3
"""Which sources can be compiled as one file: those that do not declare the same name in unnamed namespaces (ADR 31).

ci/source_batches.py SIZE SOURCE...   prints the number of its batch for each source, as a list of CMake
ci/source_batches.py --self-test      sources that clash are apart, and one source less leaves most batches of tests as they are
"""

import functools
import hashlib
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER = re.compile(r'^#include "(.*)"', re.MULTILINE)
UNNAMED_NAMESPACE = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
# Lines without indentation: a type or an alias; else the name before what begins parameters or a value. Macros are capitals.
TYPE = re.compile(r"^(?:(?:struct|class|enum class|enum) (\w+)|(?:using|namespace) (\w+) =)", re.MULTILINE)
VALUE = re.compile(r"^(?!struct|class|enum|using|namespace|template)[^\s#/}].*?(\w+) ?[({=;\[]", re.MULTILINE)
CONSTANTS = re.compile(r"^const.*;$", re.MULTILINE)  # there may be several in a line
CALLED = re.compile(r"(?<![\w.:>])(\w+)\(")
MACRO = re.compile(r"[A-Z0-9_]+")


def types(text):
    return {name for names in TYPE.findall(text) for name in names if name}


def declared(text):
    values = set(VALUE.findall(text)).union(*(re.findall(r"(\w+) = ", line) for line in CONSTANTS.findall(text)))
    return types(text) | {name for name in values if not MACRO.fullmatch(name)}


@functools.cache
def types_of(header):
    """The types that a header declares, and those that it includes."""
    path = ROOT / header
    text = path.read_text() if path.exists() else ""
    return types(text).union(*map(types_of, HEADER.findall(text)))


class Names:
    """What a source declares in unnamed namespaces; what it calls, and the types of its headers. Not a parser: who uses
    batches must get by with a wrong one."""

    def __init__(self, source):
        text = Path(source).read_text()
        self.own = set().union(*map(declared, UNNAMED_NAMESPACE.findall(text)))
        self.used = set(CALLED.findall(text)).union(*map(types_of, HEADER.findall(text)))

    def clash_with(self, other):
        """The same name declared by both, or one that hides what the other uses."""
        return self.own & other.own or self.own & other.used or self.used & other.own


def rank(source, number):
    """By lot, but always the same: which of the lists a source would rather be in."""
    return hashlib.sha1(f"{Path(source).name} {number}".encode()).digest()


def number_of_lists(sources, size):
    """A multiple of four where there are many, so that one more source seldom makes another number: most lists would then
    be others."""
    lists = -(-sources // size)
    return lists if lists <= 4 else 4 * -(-lists // 4)


def batches(sources, size):
    """Lists of at most `size` sources that do not clash. A source goes into the list that it ranks first of those that take
    it: as ranks do not hang on the other sources, one more of them, or one more name, leaves most lists as they were, and
    with them what is compiled."""
    names = {source: Names(source) for source in sources}
    lists = [[] for _ in range(number_of_lists(len(sources), size))]
    for source in sorted(sources):
        for number in sorted(range(len(lists)), key=functools.partial(rank, source)):
            if len(lists[number]) < size and not any(names[source].clash_with(names[other]) for other in lists[number]):
                lists[number].append(source)
                break
        else:
            lists.append([source])
    return [each for each in lists if each]


def self_test():
    folders = {path.parent for path in ROOT.glob("*/*/*_test.cpp")}
    kept = possible = 0
    for sources in [sorted(map(str, folder.glob("*_test.cpp"))) for folder in folders]:
        whole = {tuple(each) for each in batches(sources, 4)}
        names = {source: Names(source) for source in sources}
        assert sorted(source for each in whole for source in each) == sources
        assert all(len(each) <= 4 for each in whole)
        assert not any(names[a].clash_with(names[b]) for each in whole for a in each for b in each if a < b)
        if len(whole) > 4:
            for left_out in sources[::5]:
                rest = {tuple(each) for each in batches([source for source in sources if source != left_out], 4)}
                kept += len(rest & whole)
                possible += len(whole)
    assert kept > 0.75 * possible, (kept, possible)
    print(f"source_batches: without one source {kept} of {possible} batches are as they were")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit()
    number_of = {source: number for number, each in enumerate(batches(sys.argv[2:], int(sys.argv[1]))) for source in each}
    print(";".join(str(number_of[source]) for source in sys.argv[2:]), end="")
