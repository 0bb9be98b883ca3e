"""The figures of a report: each picture as it stands in the page, and the data behind it."""

import base64
import html.parser
import urllib.parse


class ReportFigures(html.parser.HTMLParser):
    """`found`: (id, PNG bytes, CSV text) of every figure that has both; drawings have no data."""

    def __init__(self, page):
        super().__init__()
        self.found = []
        self.name = None
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag == "figure":
            self.name, self.png, self.csv = attrs.get("id"), None, None
        elif self.name and tag == "img" and attrs.get("src", "").startswith("data:image/png"):
            self.png = data_of(attrs["src"])
        elif self.name and tag == "a" and attrs.get("href", "").startswith("data:text/csv"):
            self.csv = data_of(attrs["href"]).decode("utf-8")

    def handle_endtag(self, tag):
        if tag != "figure" or not self.name:
            return
        if self.png and self.csv:
            self.found.append((self.name, self.png, self.csv))
        self.name = None


def data_of(uri):
    head, body = uri.split(",", 1)
    return base64.b64decode(body) if head.endswith(";base64") else urllib.parse.unquote_to_bytes(body)
