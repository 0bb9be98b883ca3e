"""The messages of this folder, as src/wording/message_table.h describes them."""
import collections
import pathlib
import re

Message = collections.namedtuple("Message", "place file code one many is_the_same_everywhere comment")
LINE = re.compile(r"(\S+) (?:\[(\w+)\] =|(==?)) (\S(?:.*\S)?)")


def messages(root):
    """Those of the project at `root`, and what is wrong with their files, with file and line."""
    found, wrong = {}, []
    for path in sorted(pathlib.Path(root, "templates/messages").glob("*.messages")):
        file = str(path.relative_to(root))
        above, comment = None, ""
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            if not line or line.startswith("#"):
                comment = line[2:] if line.startswith("# TRANSLATORS:") else ""
                continue
            place = f"{file}:{number}"
            entry = LINE.fullmatch(line)
            code, count, sign, text = entry.groups() if entry else (None, None, None, None)
            if not entry or count and code != above:
                wrong.append(f"{place}: not 'code = text', nor a message above with [count] behind its code")
            elif count:
                found[code] = found[code]._replace(many=text)
            elif code in found:
                wrong.append(f"{place}: '{code}' has two messages: {found[code].place}")
            else:
                found[code] = Message(place, file, code, text, "", sign == "==", comment)
            above, comment = code if sign == "=" else None, ""
    return list(found.values()), wrong
