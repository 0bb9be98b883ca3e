#pragma once
// What every page is held against by an independent parser (Python), and what strangers may write.

#include <string>

namespace tribolog::test {

/// Text of strangers: markup, scripts, template markers, control and direction characters, bytes
/// that are no UTF-8.
inline const std::string hostile =
    "\"'><script>alert(1)</script><img src=x onerror=alert(1)></title></style></table>"
    "<!-- {{TITLE}} {{#FACTS}} ]]> &lt; javascript:alert(1) \x1b[31m \u202E \xff\xc3 \u2028";

/// Tags and attribute names in order; the values of attributes that carry no text of strangers.
inline const char* const skeleton = R"py(
import html.parser, re, sys, urllib.parse
DATA = 'data:text/csv;charset=utf-8,'
def shown(name, value):
    if name in ('alt', 'content'): return name
    if name == 'href' and value.startswith(DATA):
        safe = re.fullmatch(r'(?:[A-Za-z0-9.,_-]|%[0-9A-F]{2})*', value[len(DATA):])
        hidden = re.search('[\u202a-\u202e\ufffd\x1b]', urllib.parse.unquote(value))
        return 'href=table' if safe and not hidden else 'href=unsafe'
    return '%s=%s' % (name, value)
class Reader(html.parser.HTMLParser):
    def handle_starttag(self, tag, attributes):
        print(tag, *[shown(n, v) for n, v in attributes if n != 'src'])
    def handle_endtag(self, tag): print('/' + tag)
    def handle_comment(self, data): print('comment')
reader = Reader(); reader.feed(open(sys.argv[1], encoding='utf-8').read()); reader.close()
)py";

/// Prints every fault of a page: balance, identifiers, targets, the policy of its style and script.
inline const char* const checks = R"py(
import base64, hashlib, html.parser, re, sys
text = open(sys.argv[1], encoding='utf-8').read()
VOID = {'meta', 'link', 'img', 'br', 'hr', 'input', 'mspace', 'path', 'circle', 'rect'}
faults, ids, targets, stack = [], [], [], []
class Reader(html.parser.HTMLParser):
    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        if len(a) != len(attributes): faults.append('attribute twice in ' + tag)
        if 'id' in a: ids.append(a['id'])
        if a.get('href', '').startswith('#'): targets.append(a['href'][1:])
        for name in ('aria-labelledby',):
            if name in a: targets.extend(a[name].split())
        if tag == 'img':
            for name in ('alt', 'width', 'height', 'loading', 'decoding'):
                if not a.get(name): faults.append('img without ' + name)
        if tag == 'th' and 'scope' not in a: faults.append('th without scope')
        if tag == 'table': stack.append('table'); self.caption = False; return
        if tag == 'caption': self.caption = True
        if tag not in VOID: stack.append(tag)
    def handle_startendtag(self, tag, attributes):
        if tag not in VOID: faults.append('closed at once: ' + tag)
    def handle_endtag(self, tag):
        if tag == 'table' and not self.caption: faults.append('table without caption')
        if not stack or stack.pop() != tag: faults.append('not balanced at </%s>' % tag)
reader = Reader(); reader.feed(text); reader.close()
if stack: faults.append('left open: %s' % stack)
for i in sorted(set(ids)):
    if ids.count(i) > 1: faults.append('id twice: ' + i)
for t in targets:
    if t not in ids: faults.append('no target: ' + t)
if not text.lstrip().startswith('<!DOCTYPE html>'): faults.append('no doctype')
style = re.search(r'<style>(.*?)</style>', text, re.S).group(1)
digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
policy = html.unescape(re.search(r'Content-Security-Policy" content="([^"]*)"', text).group(1))
if "style-src 'sha256-%s'" % digest not in policy: faults.append('policy does not name the style: ' + policy)
scripts = re.findall(r'<script>(.*?)</script>', text, re.S)
allowed = ["'sha256-%s'" % base64.b64encode(hashlib.sha256(s.encode()).digest()).decode() for s in scripts]
rules = dict(rule.split(None, 1) for rule in policy.split('; '))
if rules.get('script-src', '').split() != allowed: faults.append('policy does not name the script: ' + policy)
if set(rules) - {'default-src', 'img-src', 'style-src', 'script-src', 'base-uri', 'form-action'}: faults.append('policy allows more: ' + policy)
if "default-src 'none'" not in policy: faults.append('policy is open: ' + policy)
for f in faults: print(f)
sys.exit(1 if faults else 0)
)py";

}  // namespace tribolog::test
