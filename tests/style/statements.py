#!/usr/bin/env python3
"""Codes inside, words at the edge: what the rooms of the method state, and the words for it.

  statements.py sentences   no string literal of src/method, src/verdict, src/friction, src/simulate and
                            render is a sentence: three words or more
  statements.py codes       every code that is stated has one message in templates/messages, every message
                            is stated somewhere, and values have the names that the message asks for

Prints what is wrong; exit status 1 if anything is. Environment: TRIBOLOG_ROOMS, another tree than
this one."""

import collections
import os
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).parents[2] / "templates" / "messages"))
import message_files

ROOT = pathlib.Path(os.environ.get("TRIBOLOG_ROOMS") or pathlib.Path(__file__).parents[2]).resolve()
WORDLESS = ("method", "verdict", "friction", "simulate", "render")
LITERALS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
SYNTAX = re.compile(r"render/vector/(pdf|svg)_\w+\.cpp")  # what these write is PDF and SVG
KEYS = {"waiboer"}  # of a result's numbers: "waiboer.stribeck_power"
CODE = r"[a-z][a-z0-9_]*(?:\.[A-Za-z0-9_]+)+"


def source_of(path):
    """Without comments and without includes."""
    text = re.sub(r"^\s*#.*$", "", path.read_text(), flags=re.M)
    return re.sub(r'("(?:[^"\\\n]|\\.)*")|//[^\n]*', lambda m: m.group(1) or "", text)


def sources(*tops):
    for top in tops:
        for path in sorted((ROOT / top if top == "render" else ROOT / "src" / top).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                yield path, source_of(path)


def joined(literals):
    """Neighbouring literals as one."""
    return "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals))


def sentences():
    wrong = []
    for path, text in sources(*WORDLESS):
        if SYNTAX.fullmatch(str(path.relative_to(ROOT))):
            continue
        for match in LITERALS.finditer(text):
            words = re.findall(r"[^\W\d_]{2,}[^\s]*", joined(match.group(0)))
            if len(words) >= 3 and " " in match.group(0):
                wrong.append(f"{path.relative_to(ROOT)}: \"{joined(match.group(0))}\" is a sentence")
    return wrong


def balanced(text, start):
    """From the brace at `start` to the one that closes it."""
    depth, inside = 0, False
    for at in range(start, len(text)):
        if text[at] == '"' and text[at - 1] != "\\":
            inside = not inside
        if inside:
            continue
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return text[start:at + 1]
    return text[start:]


def codes():
    messages, wrong = message_files.messages(ROOT)
    known = {message.code: set(re.findall(r"\{([a-z][A-Za-z0-9_]*)", message.one + message.many))
             for message in messages}
    topics = {code.split(".")[0] for code in known}
    stated, beginnings = collections.defaultdict(set), set()
    for path, text in sources("", "render"):
        name = path.relative_to(ROOT)
        made = dict(re.findall(r'StatedValue (\w+)\{"(\w+)"', text))
        beginnings |= set(re.findall(r'"([a-z][a-z0-9_.]*\.)"', text))
        beginnings |= {topic + "." for topic in re.findall(r'words_for\("([a-z_]+)"', text)}
        for match in re.finditer(r'"(' + CODE + r'|verbatim)"\s*(.?)', text):
            code = match.group(1)
            if code not in known:
                room = str(name).removeprefix("src/").split("/")[0]
                if code.split(".")[0] in topics - KEYS and room in (*WORDLESS, "truth", "identify", "history"):
                    wrong.append(f"{name}: {code} has no message")
                continue
            stated[code].add(name)
            values = re.match(r"\s*\{\s*\{", text[match.end(2):]) if match.group(2) == "," else None
            if values is None:
                continue
            block = balanced(text, match.end(2) + text[match.end(2):].index("{"))
            given = set(re.findall(r'^\{\{"(\w+)"', block)) | set(re.findall(r'[,}]\s*\{"(\w+)",', block))
            given |= {made[one] for one in re.findall(r"[{,]\s*(\w+)\s*(?=[,}])", block) if one in made}
            missing = known[code] - given
            if missing:
                wrong.append(f"{name}: {code} does not state {', '.join(sorted(missing))}")
    for message in messages:
        if message.code not in stated and not any(message.code.startswith(b) for b in beginnings):
            wrong.append(f"{message.place}: nobody states {message.code}")
    return wrong


def main():
    rule = sys.argv[1] if len(sys.argv) > 1 else ""
    if rule not in ("sentences", "codes"):
        sys.exit(__doc__)
    wrong = sentences() if rule == "sentences" else codes()
    print("\n".join(wrong) if wrong else f"{rule}: nothing wrong")
    sys.exit(1 if wrong else 0)


main()
