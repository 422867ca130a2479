# SPDX-License-Identifier: MIT
"""Functions with their frames and calls, as gcc's report FILE.ci (-fcallgraph-info=su) has them."""

import re

INDIRECT_CALL = "__indirect_call"


class Refused(Exception):
    """The stack has no bound that can be known."""


class Function:
    def __init__(self, title):
        self.title, self.frame, self.calls = title, None, set()


def demangled(title):
    """The unqualified name in a mangled one: _ZN6fixrad12_GLOBAL__N_14lookE... -> look."""
    title = title.rsplit(":", 1)[-1]
    names, rest = [], re.sub(r"^_ZNK?", "", title)
    while match := re.match(r"L?(\d+)", rest):
        end = match.end() + int(match.group(1))
        names.append(rest[match.end():end])
        rest = rest[end:]
    return names[-1] if title.startswith("_Z") and names else title


def one_constructor(text):
    """A constructor is defined once, C2, and called C1 where it makes a whole object."""
    return re.sub(r"([CD])1E", r"\g<1>2E", text)


def read_ci(path, functions):
    """Adds the functions of the report at `path` to {title: Function}."""
    with open(path, encoding="utf-8") as file:
        text = one_constructor(file.read())
    for title, label in re.findall(r'^node: \{ title: "([^"]*)" label: "([^"]*)"', text, re.MULTILINE):
        function = functions.setdefault(title, Function(title))
        usage = re.search(r"\\n(\d+) bytes \(([^)]*)\)", label)
        if usage:
            if "static" not in usage.group(2) and "bounded" not in usage.group(2):
                raise Refused(f"{demangled(title)}: the size of its frame is not known: {usage.group(2)}")
            function.frame = max(function.frame or 0, int(usage.group(1)))
    for source, target in re.findall(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', text, re.MULTILINE):
        functions.setdefault(source, Function(source)).calls.add(target)
