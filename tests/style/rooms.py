#!/usr/bin/env python3
"""The rooms of src/ and render/: one folder, one CMake target, and no circle between them.

  rooms.py circles          no folder needs one that needs it, on whatever way round
  rooms.py lists            each room's CMakeLists.txt has all of its sources, and names the rooms
                            that it includes and no other: PUBLIC for its headers, PRIVATE for its
                            sources alone; its files stand in the namespace of its name
  rooms.py walls BUILD      the compiler finds no header of a room that is not named: one unit of each
                            room is asked for every header there is
  rooms.py graph            the rooms and what each needs, for `dot`
  rooms.py size             files, headers, lines, and the headers whose change rebuilds most sources
  rooms.py drawing          the house on one page, for `dot`: a box for each folder of src/, and arrows
                            to what it needs that nothing else it needs would bring along
  rooms.py drawn            docs/rooms.dot is that drawing, and docs/rooms.svg was made from it

Prints what is wrong; exit status 1 if anything is. Environment: TRIBOLOG_ROOMS, another tree than
this one."""

import collections
import html
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import textwrap

from single_units import units_of

ROOT = pathlib.Path(os.environ.get("TRIBOLOG_ROOMS") or pathlib.Path(__file__).parents[2]).resolve()
INCLUDE = re.compile(r'^\s*#\s*include "([^"]+)"', re.M)
CALL = re.compile(r"\btribolog_(room|module)\(([^)]*)\)")


NAMESPACE = re.compile(r"^namespace (tribolog[a-z0-9_:]*) \{", re.M)


# The headers that other programs include, as "tribolog/dataset.h", are the room api's.
PUBLIC_HEADERS = "tribolog/"


def namespaces_of(room):
    """What every room stands on, base, is the namespace around all of them; so is what the door
    shows."""
    own = "tribolog" if room in ("", "base") else "tribolog::" + room.replace("/", "::")
    return {own, "tribolog"} if room == "api" else {own}


def room_of(header):
    return "api" if header.startswith(PUBLIC_HEADERS) else header.rpartition("/")[0]


def read_rooms():
    """Room -> its files, as they are included."""
    rooms = collections.defaultdict(dict)
    for top in ("src", "render"):
        base = ROOT / "src" if top == "src" else ROOT
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                name = path.relative_to(base).as_posix()
                if name.startswith("api/" + PUBLIC_HEADERS):
                    name = name.removeprefix("api/")
                rooms[room_of(name)][name] = path.read_text()
    return rooms


def needs(rooms):
    """(room, needed room) -> the files that include it."""
    headers = {name for files in rooms.values() for name in files}
    edges = collections.defaultdict(list)
    for room, files in rooms.items():
        for name, text in files.items():
            for header in INCLUDE.findall(text):
                if header in headers and room_of(header) != room:
                    edges[room, room_of(header)].append((name, header))
    return edges


def circles(rooms):
    edges = needs(rooms)
    after = collections.defaultdict(set)
    for room, other in edges:
        after[room].add(other)
    state, way, found = {}, [], []

    def walk(room):
        state[room] = "open"
        way.append(room)
        for other in sorted(after[room]):
            if state.get(other) == "open":
                found.append(way[way.index(other):] + [other])
            elif other not in state:
                walk(other)
        way.pop()
        state[room] = "done"

    for room in sorted(rooms):
        if room not in state:
            walk(room)
    for circle in found:
        print("a circle:", " -> ".join(circle))
        for room, other in zip(circle, circle[1:]):
            name, header = edges[room, other][0]
            print(f"  {name} includes {header}")
    return not found


def folder_of(room):
    return ROOT / room if room.startswith("render") else ROOT / "src" / room


def read_list(room):
    """The call of tribolog_room() or tribolog_module() in a room's CMakeLists.txt, by its words."""
    text = re.sub(r"#.*", "", (folder_of(room) / "CMakeLists.txt").read_text())
    call = CALL.search(text)
    if not call:
        return None
    appended = collections.defaultdict(list)  # by options that are on by default
    for name, words in re.findall(r"list\(APPEND (\w+) ([^)]*)\)", text):
        appended[name] += words.split()
    lists, key = collections.defaultdict(list), "NAME"
    words = re.sub(r"\$\{(\w+)\}",
                   lambda of: " ".join(appended[of[1]]) if of[1] in appended else of[0],
                   call.group(2))
    for word in words.split():
        if word in ("SOURCES", "PUBLIC", "PRIVATE", "LIBRARIES", "PUBLIC_LIBRARIES", "ROOMS"):
            key = word
        else:
            lists[key].append(word)
    return lists


def lists(rooms):
    faults = []
    edges = needs(rooms)
    for room, files in sorted(rooms.items()):
        if not room:  # main.cpp
            continue
        if not (folder_of(room) / "CMakeLists.txt").exists():
            faults.append(f"{room}: a folder with sources and without a CMakeLists.txt")
            continue
        listed = read_list(room)
        if listed is None or room not in listed["NAME"]:
            faults.append(f"{room}: its CMakeLists.txt makes no room of this name")
            continue
        text = (folder_of(room) / "CMakeLists.txt").read_text()
        for name in files:
            stem = pathlib.Path(name).name
            if stem.endswith(".cpp") and stem not in listed["SOURCES"] and "${" not in text:
                faults.append(f"{room}: {stem} is not among its SOURCES")
        for name, code in files.items():
            for space in NAMESPACE.findall(code):
                declares = re.search(rf"namespace {space} {{\n(struct|class) \w+;\n}}", code)
                if space not in namespaces_of(room) and not declares:
                    own = " or ".join(sorted(namespaces_of(room)))
                    faults.append(f"{name}: stands in namespace {space}, not {own}")
        public = {other for (mine, other), where in edges.items()
                  if mine == room and any(name.endswith(".h") for name, _ in where)}
        private = {other for mine, other in edges if mine == room} - public
        is_module = bool(listed["ROOMS"])
        wanted = [("ROOMS", public | private)] if is_module else \
            [("PUBLIC", public), ("PRIVATE", private)]
        for key, needed in wanted:
            for other in sorted(needed - set(listed[key])):
                faults.append(f"{room}: includes {other}, which is not in its {key}")
            for other in sorted(set(listed[key]) - needed):
                faults.append(f"{room}: names {other} in its {key}, and does not include it there")
    for fault in faults:
        print(fault)
    return not faults


def walls(rooms, build):
    """__has_include() of every header, by the search path that the room's units are compiled with."""
    headers = sorted(name for files in rooms.values() for name in files if name.endswith(".h"))
    probe = "".join(f'#if __has_include("{h}")\nSEEN {h}\n#endif\n' for h in headers)
    commands = {}
    for unit in units_of(pathlib.Path(build)):
        path = pathlib.Path(unit["directory"], unit["file"]).resolve()
        for top in (ROOT / "src", ROOT):
            if path.is_relative_to(top) and room_of(path.relative_to(top).as_posix()) in rooms:
                commands.setdefault(room_of(path.relative_to(top).as_posix()), unit)
                break
    closure = {}

    def seen_from(room, through_public):
        """Rooms whose headers a room may include: those it names, and what their headers include."""
        listed = read_list(room)
        named = listed["PUBLIC"] + listed["ROOMS"]
        if listed["ROOMS"]:  # a module, which has its version from there
            named = named + ["base"]
        if not through_public:
            named = named + listed["PRIVATE"]
        seen = {room}
        for other in named:
            if other not in closure:
                closure[other] = seen_from(other, True)
            seen |= closure[other]
        return seen

    faults = []
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place) / "probe.cpp"
        file.write_text(probe)
        for room in sorted(rooms):
            if not room:
                continue
            if room not in commands:
                faults.append(f"{room}: none of its units is in compile_commands.json")
                continue
            words = shlex.split(commands[room]["command"])
            flags = [w for w in words[1:] if w.startswith(("-I", "-std"))]
            seen = subprocess.run([words[0], *flags, "-E", "-P", str(file)], text=True, check=True,
                                  capture_output=True, cwd=commands[room]["directory"]).stdout
            allowed = seen_from(room, False)
            found = {room_of(line.split()[1]) for line in seen.splitlines() if "SEEN" in line}
            # A module may lie in a folder of the room that it is loaded by.
            for other in sorted(found - allowed):
                if not any(other.startswith(f"{a}/") for a in allowed):
                    faults.append(f"{room}: its units find headers of {other}, which it does not name")
            for other in sorted(allowed - found):
                if any(h for h in headers if room_of(h) == other):
                    faults.append(f"{room}: its units do not find headers of {other}")
    for fault in faults:
        print(fault)
    return not faults


def graph(rooms):
    print("digraph rooms {\n  rankdir=TB; node [shape=box];")
    for room, other in sorted(needs(rooms)):
        print(f'  "{room or "main"}" -> "{other}";')
    print("}")
    return True


def size(rooms):
    """What the house weighs. Prints alone."""
    files = {name: text for room in rooms.values() for name, text in room.items()}
    headers = [name for name in files if name.endswith(".h")]
    short = sum(files[name].count("\n") < 30 for name in headers)
    lines = sum(text.count("\n") for text in files.values())
    print(f"{len(files)} files, {len(headers)} of them headers ({short} under 30 lines), {lines} lines, "
          f"{len(rooms)} rooms")
    included = {name: {h for h in INCLUDE.findall(text) if h in files} for name, text in files.items()}
    sources = [name for name in files if name.endswith(".cpp")]
    rebuilt = collections.Counter()
    for source in sources:
        reached, left = set(), [source]
        while left:
            for header in included[left.pop()] - reached:
                reached.add(header)
                left.append(header)
        rebuilt.update(reached)
    direct = collections.Counter(h for name in files for h in included[name])
    print(f"sources that a change rebuilds, of {len(sources)}: the ten headers included by most files")
    for header, count in direct.most_common(10):
        print(f"  {header:40} {rebuilt[header]:4} {100 * rebuilt[header] / len(sources):5.1f} %"
              f"   included by {count}")
    print("the ten that rebuild most")
    for header, count in rebuilt.most_common(10):
        print(f"  {header:40} {count:4} {100 * count / len(sources):5.1f} %")
    return True


def house(rooms):
    """Folder of src/, or render -> the folders that it needs."""
    after = {(room or "main").split("/")[0]: set() for room in rooms}
    for room, other in needs(rooms):
        mine, theirs = (room or "main").split("/")[0], other.split("/")[0]
        if mine != theirs:
            after[mine].add(theirs)
    return after


def reduced(after):
    """The same order with the fewest arrows: none to what another arrow leads to."""
    below = {}

    def all_below(folder):
        if folder not in below:
            below[folder] = set()
            for other in after[folder]:
                below[folder] |= {other} | all_below(other)
        return below[folder]

    return {folder: sorted(other for other in others
                           if not any(other in all_below(via) for via in others - {other}))
            for folder, others in sorted(after.items())}


def purpose(room):
    """The comment that a room's list begins with."""
    lines = []
    for line in (folder_of(room) / "CMakeLists.txt").read_text().splitlines():
        if not line.startswith("# "):
            break
        lines.append(line[2:])
    return " ".join(lines).split(". ")[0].rstrip(".")


def order_of_building(rooms):
    """A key that puts rooms where src/CMakeLists.txt and render/CMakeLists.txt do."""
    words = []
    for top in ("src", "render"):
        file = ROOT / top / "CMakeLists.txt"
        words += re.findall(r"[\w/]+", file.read_text()) if file.exists() else []
    place = {word: n for n, word in reversed(list(enumerate(words)))}
    return lambda room: (place.get(room, place.get(room.removeprefix("render/"), len(words))), room)


def drawing_of(rooms):
    def text(words, size):
        rows = textwrap.wrap(html.escape(words, quote=False), 38)
        return "".join(f'<FONT POINT-SIZE="{size}">{row}</FONT><BR ALIGN="LEFT"/>' for row in rows)

    lines = ["// Made by tests/style/rooms.py drawing: the folders of the source, what each is for and what",
             "// it needs. An arrow that another way already implies is left out.",
             "digraph house {",
             '  graph [rankdir=BT, nodesep=0.25, ranksep=0.35, fontname="DejaVu Sans"];',
             '  node [shape=box, style="filled,rounded", fillcolor="#f5f2ea", color="#6b6658",'
             ' fontname="DejaVu Sans", fontsize=11, margin="0.12,0.07"];',
             '  edge [color="#6b6658", arrowsize=0.6];']
    after = house(rooms)
    in_order = sorted(rooms, key=order_of_building(rooms))
    for folder in sorted(after):
        inside = [room for room in in_order if room.startswith(f"{folder}/")]
        if folder == "main":
            what = "the executable"
        elif folder not in rooms:
            what = ", ".join(room.partition("/")[2] for room in inside)
        else:
            what = purpose(folder)
        colour = ', fillcolor="#e3ecf5"' if folder == "method" else ""
        lines.append(f'  {folder} [label=<<B>{folder}</B><BR ALIGN="LEFT"/>{text(what, 9)}>{colour}];')
    lines += [f"  {folder} -> {other};" for folder, others in reduced(after).items()
              for other in others]
    return "\n".join(lines + ["}"]) + "\n"


def drawing(rooms):
    print(drawing_of(rooms), end="")
    return True


def drawn(rooms):
    wanted = drawing_of(rooms)
    dot, svg = ROOT / "docs" / "rooms.dot", ROOT / "docs" / "rooms.svg"
    faults = []
    if not dot.exists() or dot.read_text() != wanted:
        faults.append("docs/rooms.dot is not the house as it stands: "
                      "tests/style/rooms.py drawing >docs/rooms.dot")
    # Versions of `dot` place boxes differently; which boxes and arrows there are is theirs to keep.
    titles = set(re.findall(r"<title>(.*?)</title>", svg.read_text())) if svg.exists() else set()
    titles = {html.unescape(title) for title in titles} - {"house"}
    after = reduced(house(rooms))
    boxes = set(after) | {f"{mine}->{other}" for mine, others in after.items() for other in others}
    if titles != boxes:
        faults.append("docs/rooms.svg does not show docs/rooms.dot: "
                      "dot -Tsvg docs/rooms.dot -o docs/rooms.svg")
    for fault in faults:
        print(fault)
    return not faults


def main():
    what = sys.argv[1] if len(sys.argv) > 1 else ""
    rooms = read_rooms()
    if what == "walls" and len(sys.argv) == 3:
        return walls(rooms, sys.argv[2])
    checks = {"circles": circles, "lists": lists, "graph": graph, "size": size, "drawing": drawing,
              "drawn": drawn}
    if what not in checks:
        sys.exit(__doc__)
    return checks[what](rooms)


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
