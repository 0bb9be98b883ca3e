#!/usr/bin/env python3
"""Brings the catalogues up to date with what the program says.

usage: update.py TEMPLATE_MESSAGES            merges new messages into every *.po beside this file
       update.py TEMPLATE_MESSAGES --check    changes nothing; fails where one is missing, left
                                              over, unsure or empty, or does not fit its values
       update.py TEMPLATE_MESSAGES --new CODE begins a language: writes CODE.po

TEMPLATE_MESSAGES is the program of that name in the tests' build. Needs gettext's tools.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
sys.path.append(str(root / "templates" / "messages"))
import message_files

unwrapped = ["--no-wrap", "--add-location=file", "--sort-by-file"]


def run(*command, **options):
    return subprocess.run(command, check=True, cwd=root, capture_output=True, text=True, **options).stdout


def extracted(sources, *keywords):
    """The messages of such calls in sources, as a .pot file has them."""
    return run("xgettext", "--language=C++", "--from-code=UTF-8", "--add-comments=TRANSLATORS", "-k",
               *(f"-k{keyword}" for keyword in keywords), *unwrapped, "--output=-", *sources)


def pot_of_messages():
    """Those of templates/messages: a text once, with all files that have it."""
    all_messages, wrong = message_files.messages(root)
    if wrong:
        sys.exit("\n".join(wrong))
    entries = {}
    for message in all_messages:
        if not message.is_the_same_everywhere:
            entries.setdefault(message.one, []).append(message)
    pot = ['msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"']
    for one, same in sorted(entries.items()):
        lines = [f"#. {comment}" for comment in sorted({message.comment for message in same} - {""})]
        lines += [f"#: {file}" for file in sorted({message.file for message in same})]
        many = max(message.many for message in same)
        lines += [f"msgid {quoted(one)}"] + ([f"msgid_plural {quoted(many)}"] if many else [])
        lines += ['msgstr[0] ""', 'msgstr[1] ""'] if many else ['msgstr ""']
        pot.append("\n".join(lines))
    return "\n\n".join(pot) + "\n"


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def with_formats(pot):
    """Values stand in braces; what looks like printf's is a percent sign."""
    entries = []
    for entry in pot.split("\n\n"):
        entry = re.sub(r"^#, .*c-format.*\n", "", entry, flags=re.M)
        says = "".join(re.findall(r'^(?:msgid|msgid_plural)? ?"(.*)"$', entry, flags=re.M))
        # Those of templates are HTML, whose marks the program compares itself.
        if "{" in says and not re.search(r"^#: templates/(?!messages/)", entry, flags=re.M):
            entry = entry.replace("msgid ", "#, python-brace-format\nmsgid ", 1)
        entries.append(entry)
    return "\n\n".join(entries)


def write_template(program, pot):
    sources = sorted(str(path.relative_to(root)) for path in (root / "src").rglob("*.[ch]*")
                     if path.suffix in (".cpp", ".h"))
    parts = [pot_of_messages(), extracted(sources, "tr:1", "tr_count:2,3", "to_translate:1"),
             'msgid ""\nmsgstr "Content-Type: text/plain; charset=UTF-8\\n"\n\n' + run(program)]
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, part in enumerate(parts):
            files.append(f"{folder}/{number}.pot")
            pathlib.Path(files[-1]).write_text(part.replace("charset=CHARSET", "charset=UTF-8"))
        merged = run("msgcat", "--use-first", *unwrapped, *files)
    pathlib.Path(pot).write_text(with_formats(merged))


def check(pot, po):
    wrong = []
    for command in (["msgcmp", str(po), pot],  # missing, unsure, empty
                    ["msgfmt", "--check", "--output-file=/dev/null", str(po)]):
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode != 0:
            wrong.append(result.stderr)
    known = subprocess.run(["msgcmp", "--use-untranslated", pot, str(po)], capture_output=True,
                           text=True)
    if known.returncode != 0:
        wrong.append("nobody says any more:\n" + known.stderr)
    return wrong


def main(program, *options):
    program = str(pathlib.Path(program).resolve())
    with tempfile.TemporaryDirectory() as folder:
        pot = f"{folder}/tribolog.pot"
        write_template(program, pot)
        if options[:1] == ("--new",):
            run("msginit", "--no-translator", f"--locale={options[1]}", f"--input={pot}", "--no-wrap",
                f"--output-file={here / options[1]}.po")
            return 0
        status = 0
        for po in sorted(here.glob("*.po")):
            if options == ("--check",):
                for text in check(pot, po):
                    status = 1
                    print(f"{po.name}:\n{text}")
            else:
                run("msgmerge", "--update", "--backup=none", "--no-fuzzy-matching", "--quiet",
                    *unwrapped, str(po), pot)
                run("msgattrib", "--no-obsolete", *unwrapped, f"--output-file={po}", str(po))
        return status


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
