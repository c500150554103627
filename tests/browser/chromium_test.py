"""What the browser's watcher would miss, every other test would pass: so each kind of fault is made once."""
import tempfile
import unittest
from pathlib import Path

from chromium import Chromium


class Watcher(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="penumbra-report-")
        cls.addClassCleanup(folder.cleanup)
        cls.file = Path(folder.name) / "page.html"
        cls.browser = cls.enterClassContext(Chromium())

    def problems_of(self, html):
        self.browser.problems.clear()
        self.file.write_text(html)
        with self.browser.open(self.file) as page:
            page.ask("new Promise(done => setTimeout(done, 200))")
        return "\n".join(self.browser.problems)

    def test_sees_console_errors_thrown_errors_and_rejections(self):
        problems = self.problems_of("<script>console.error('said')</script><script>throw new Error('thrown')</script>"
                                    "<script>Promise.reject(new Error('rejected'))</script><script>}</script>")
        for word in ("said", "thrown", "rejected", "SyntaxError"):
            self.assertIn(word, problems)

    def test_sees_what_a_policy_forbids(self):
        policy = "<meta http-equiv='Content-Security-Policy' content=\"default-src 'none'\">"
        self.assertIn("Content Security Policy", self.problems_of(f"{policy}<script src='https://example.invalid/x.js'></script>"))

    def test_sees_nothing_where_nothing_is_wrong(self):
        self.assertEqual(self.problems_of("<p>words</p>"), "")

    def test_presses_types_and_looks(self):
        self.file.write_text("<body style='margin: 0'><button onclick='this.textContent = 1'>0</button>"
                             "<input onkeydown='this.title = event.key'>")
        with self.browser.open(self.file, width=200, height=100, dark=True) as page:
            page.click("button")
            self.assertEqual(page.ask("document.querySelector('button').textContent"), "1")
            page.ask("document.querySelector('input').focus()")
            page.press("ArrowLeft")
            self.assertEqual(page.ask("document.querySelector('input').title"), "ArrowLeft")
            self.assertTrue(page.ask("matchMedia('(prefers-color-scheme: dark)').matches"))
            self.assertTrue(page.screenshot().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
