#!/usr/bin/env python3
"""Texts of a page that are the same in another language.

usage: untranslated.py ENGLISH.html OTHER.html
       untranslated.py ENGLISH_DIR OTHER_DIR      figures as SVG, by their names
Prints each text that a reader sees, or is told, and that stands in both pages unchanged although
it has a word in it. Left out: words that are the same in every language
(words_of_all_languages.txt), code, keys, file names. Exit status 1 if any is left.
"""
import html.parser
import pathlib
import re
import sys

# The paper's title is what it is.
PAPER = "Viscous friction measurement technique in robot joint with the use of surrogate mass"
SPOKEN = {"alt", "aria-label", "title", "aria-valuetext"}
SILENT = {"script", "style", "code", "pre", "math", "svg"}


class Texts(html.parser.HTMLParser):
    """Texts of a page in their order, those of one block as one."""

    INLINE = {"a", "abbr", "b", "bdi", "code", "em", "i", "kbd", "span", "strong", "sub", "sup",
              "var", "math", "mrow", "mi"}

    def __init__(self):
        super().__init__()
        self.texts = []
        self.run = ""
        self.silent = 0

    def end_run(self):
        text = " ".join(self.run.split())
        if text:
            self.texts.append(text)
        self.run = ""

    def handle_starttag(self, tag, attrs):
        if tag not in self.INLINE:
            self.end_run()
        if tag in SILENT:
            self.silent += 1
        for name, value in attrs:
            if name in SPOKEN and value:
                self.texts.append(" ".join(value.split()))

    def handle_endtag(self, tag):
        if tag in SILENT:
            self.silent -= 1
        if tag not in self.INLINE:
            self.end_run()

    def handle_data(self, data):
        if not self.silent:
            self.run += data


def page_texts(path):
    parser = Texts()
    parser.feed(path.read_text(encoding="utf-8"))
    parser.end_run()
    return parser.texts


def drawn_texts(path):
    source = path.read_text(encoding="utf-8")
    found = re.findall(r"<text[^>]*>(.*?)</text>", source, re.S)
    texts = []
    for one in found:
        plain = re.sub(r"<[^>]*>", "", one)
        texts.append(" ".join(plain.replace("&amp;", "&").replace("&lt;", "<").split()))
    return [text for text in texts if text]


def has_word(text, known):
    """Keys (constant_speed), file names, versions and hashes are no words."""
    plain = [one for one in text.split() if not re.search(r"[_/\\0-9]|[.][a-z]", one)]
    words = re.findall(r"[A-Za-z]{3,}", " ".join(plain))
    return any(word.lower() not in known for word in words)


def main():
    known = {line.split("#")[0].strip().lower()
             for line in (pathlib.Path(__file__).parent / "words_of_all_languages.txt")
             .read_text(encoding="utf-8").splitlines()}
    english, other = (pathlib.Path(name) for name in sys.argv[1:3])
    pairs = ([(page, other / page.name) for page in sorted(english.glob("*.svg"))]
             if english.is_dir() else [(english, other)])
    left = {}
    for one, two in pairs:
        read = drawn_texts if one.suffix == ".svg" else page_texts
        there = set(read(two))
        for text in read(one):
            if text in there and has_word(text, known):
                left.setdefault(text, one.name)
    left.pop(PAPER, None)
    for text in left:
        print(text)
    return 1 if left else 0


sys.exit(main())
