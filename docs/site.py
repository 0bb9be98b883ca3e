#!/usr/bin/env python3
"""Makes one self-contained HTML page of README.md and docs/: for a screen, a phone, or to print.

  python3 docs/site.py -o FILE.html      needs python3-markdown

Links between pages lead to places within it; pictures are embedded; there is no script and nothing to
load. Files of the source that a page links to are named, not linked."""

import argparse
import base64
import html
import pathlib
import re
import sys

try:
    import markdown
except ImportError:
    sys.exit("docs/site.py: needs python3-markdown")

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ["README.md"] + [f"docs/{name}.md" for name in (
    "tutorial", "recording", "manifest", "formats", "commands", "verdicts", "report", "exports", "archive",
    "library", "faq", "limits", "method", "model", "glossary", "simulation", "performance", "real_logs",
    "raw_logs", "cases", "architecture")] + ["CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"]
INDEX = "docs/README.md"  # the table of contents stands in its place
TYPES = {".png": "image/png", ".svg": "image/svg+xml"}

STYLE = """
:root{color-scheme:light dark;--ink:#1b1f24;--paper:#fff;--soft:#f4f5f7;--line:#d5d9de;--link:#0b5a94}
@media(prefers-color-scheme:dark){:root{--ink:#e4e7ea;--paper:#14171a;--soft:#1e2328;--line:#3a424a;--link:#7dbdf0}}
*{box-sizing:border-box}
html{scroll-padding-top:1rem}
body{margin:0;color:var(--ink);background:var(--paper);font:16px/1.55 system-ui,sans-serif;overflow-wrap:break-word}
a{color:var(--link)}
nav{padding:1rem;font-size:.9rem;background:var(--soft)}
nav ul{list-style:none;margin:0;padding:0}
nav li{margin:.15rem 0}
nav li li{padding-left:1.4rem;font-size:.92em}
nav a{text-decoration:none;display:inline-block;padding:.1rem 0}
nav p{font-weight:600;margin:0 0 .4rem}
nav summary{cursor:pointer}nav li.short{padding-left:1.05rem}
main{max-width:56rem;padding:0 1rem 4rem;margin:auto}
section{border-top:1px solid var(--line);padding-top:1rem;margin-top:3rem}
section:first-child{border:0;margin-top:0}
h1{font-size:1.8rem;line-height:1.2}h2{font-size:1.35rem;margin-top:2.2rem}h3{font-size:1.1rem;margin-top:1.8rem}
img{max-width:100%;height:auto;background:#fff;border:1px solid var(--line)}
code{font:.88em/1.45 ui-monospace,"DejaVu Sans Mono",monospace;background:var(--soft);padding:.1em .25em;border-radius:3px}
pre{background:var(--soft);padding:.8rem 1rem;overflow-x:auto;border-radius:4px}
pre code{padding:0;background:none}
.wide{overflow-x:auto}
table{border-collapse:collapse;font-size:.92rem;margin:1rem 0}
th,td{border:1px solid var(--line);padding:.35rem .6rem;text-align:left;vertical-align:top;min-width:4rem}
th{background:var(--soft)}
thead:not(:has(th:not(:empty))){display:none}
@media(max-width:40rem){table{font-size:.82rem}th,td{padding:.25rem .4rem;min-width:3rem}}
@media(min-width:70rem){
 nav{position:fixed;top:0;left:0;bottom:0;width:17rem;overflow-y:auto}
 main{margin-left:19rem}
}
@media print{
 :root{--ink:#000;--paper:#fff;--soft:#f4f4f4;--line:#bbb;--link:#000}
 body{font-size:10pt}nav{background:none}nav summary{list-style:none}nav li.short{padding-left:0}
 main{max-width:none;padding:0}section{break-before:page;border:0}
 h1,h2,h3{break-after:avoid}tr,img{break-inside:avoid}img{max-height:15cm;width:auto}
 pre{white-space:pre-wrap;overflow-wrap:anywhere}.wide{overflow:visible}table{font-size:8pt}th,td{min-width:0}
 a{text-decoration:none}
}
"""


def slug(heading):
    """As GitHub makes the anchor of a heading."""
    text = re.sub(r"<[^>]*>", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", html.unescape(text)).replace(" ", "-")


def page_id(page):
    return pathlib.Path(page).stem.lower()


def place(page, anchor):
    return f"{page_id(page)}--{anchor}" if anchor else page_id(page)


def with_heading_ids(text, page, headings):
    """Gives each heading an anchor, and notes those of the first two levels."""
    seen = {}

    def heading(match):
        level, content = int(match[1]), match[2]
        anchor = slug(content)
        count = seen.get(anchor, 0)
        seen[anchor] = count + 1
        where = place(page, f"{anchor}-{count}" if count else anchor)
        headings.append((level, where, content))
        return f'<h{level} id="{where}">{content}</h{level}>'

    return re.sub(r"<h([1-6])>(.*?)</h\1>", heading, text, flags=re.DOTALL)


def with_links(text, page, pages):
    """Links between pages lead within the file."""
    base = (ROOT / page).parent

    def link(match):
        target, words = html.unescape(match[1]), match[2]
        if re.match(r"[a-z]+:", target):
            return match[0]
        path, _, anchor = target.partition("#")
        file = (base / path).resolve() if path else ROOT / page
        name = str(file.relative_to(ROOT))
        if name == INDEX:
            return f'<a href="#contents">{words}</a>'
        if name in pages:
            return f'<a href="#{place(name, anchor)}">{words}</a>'
        return words

    return re.sub(r'<a href="([^"]*)">(.*?)</a>', link, text, flags=re.DOTALL)


def with_pictures(text, page):
    base = (ROOT / page).parent

    def picture(match):
        file = base / html.unescape(match[1])
        data = base64.b64encode(file.read_bytes()).decode()
        return f'src="data:{TYPES[file.suffix]};base64,{data}"'

    return re.sub(r'src="([^":]*)"', picture, text)


def section_of(page, pages, headings):
    text = (ROOT / page).read_text(encoding="utf-8")
    text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.DOTALL)
    body = markdown.markdown(text, extensions=["tables", "fenced_code", "sane_lists"])
    body = with_heading_ids(body, page, headings)
    body = with_pictures(with_links(body, page, pages), page)
    body = body.replace("<table>", '<div class="wide"><table>').replace("</table>", "</table></div>")
    return f'<section id="{page_id(page)}">\n{body}\n</section>\n'


def contents(of_pages):
    """Of each page its title, with its second-level headings folded."""
    items = []
    for page, headings in of_pages:
        title = next(content for level, _, content in headings if level == 1)
        inner = "".join(f'<li><a href="#{where}">{content}</a></li>'
                        for level, where, content in headings if level == 2)
        link = f'<a href="#{page_id(page)}">{title}</a>'
        is_long = inner and page != "CHANGELOG.md"
        items.append(f"<li><details><summary>{link}</summary><ul>{inner}</ul></details></li>" if is_long
                     else f"<li class=\"short\">{link}</li>")
    return f'<nav id="contents"><p>Contents</p><ul>{"".join(items)}</ul></nav>'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path)
    output = parser.parse_args().output
    pages = [page for page in PAGES if (ROOT / page).exists()]
    forgotten = {str(p.relative_to(ROOT)) for p in (ROOT / "docs").glob("*.md")} - set(pages) - {INDEX}
    if forgotten:
        sys.exit(f"not on the page: {', '.join(sorted(forgotten))}")
    of_pages, sections = [], []
    for page in pages:
        headings = []
        sections.append(section_of(page, pages, headings))
        of_pages.append((page, headings))
    text = ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width,initial-scale=1"><title>tribolog</title>'
            f"<style>{STYLE}</style></head>\n<body>\n{contents(of_pages)}\n<main>\n{''.join(sections)}</main>\n"
            "</body></html>\n")
    anchors = set(re.findall(r' id="([^"]*)"', text))
    broken = sorted(set(re.findall(r'href="#([^"]*)"', text)) - anchors)
    if broken:
        sys.exit(f"links without a place: {', '.join(broken)}")
    output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
