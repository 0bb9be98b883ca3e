// The document as an independent parser sees it.

#include <gtest/gtest.h>

#include "run_python.h"
#include "sample_calibration.h"

namespace tribolog::test {
namespace {

const char* const checks = R"py(
import base64, hashlib, html.parser, re, sys
text = open(sys.argv[1], encoding='utf-8').read()
VOID = {'meta', 'link', 'img', 'br', 'hr', 'input', 'mspace', 'path', 'circle'}
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
if "default-src 'none'" not in policy: faults.append('policy is open: ' + policy)
for f in faults: print(f)
sys.exit(1 if faults else 0)
)py";

void expect_sound(const Calibration& c) {
  if (!has_python_module("html.parser")) GTEST_SKIP() << "python3 is not installed";
  EXPECT_TRUE(run_python(checks, report_of(c)));
}

TEST(HtmlDocument, IsSoundWhenComplete) { expect_sound(complete_calibration()); }

TEST(HtmlDocument, IsSoundWhenHalfIsMissing) { expect_sound(sweep_only()); }

TEST(HtmlDocument, IsSoundWhenEmpty) { expect_sound(Calibration{}); }

}  // namespace
}  // namespace tribolog::test
