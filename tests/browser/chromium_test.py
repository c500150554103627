"""A fault that the browser's watcher missed would pass every other test, so each kind of fault is made once."""
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

    def open(self, html):
        self.browser.problems.clear()
        self.file.write_text(html)
        return self.browser.open(self.file)

    def expect_problems(self, html, *words):
        """Waits for the faults: a busy machine's browser may report some of them long after the page stands."""
        with self.open(html) as page:
            page.wait_until(lambda: all(word in "\n".join(self.browser.problems) for word in words), f"reported: {words}")

    def test_sees_console_errors_thrown_errors_and_rejections(self):
        self.expect_problems("<script>console.error('said')</script><script>throw new Error('thrown')</script>"
                             "<script>Promise.reject(new Error('rejected'))</script><script>}</script>",
                             "said", "thrown", "rejected", "SyntaxError")

    def test_sees_what_a_policy_forbids(self):
        policy = "<meta http-equiv='Content-Security-Policy' content=\"default-src 'none'\">"
        self.expect_problems(f"{policy}<script src='https://example.invalid/x.js'></script>", "Content Security Policy")

    def test_sees_nothing_where_nothing_is_wrong(self):
        with self.open("<p>words</p>") as page:
            page.ask("console.error('the last')")
            page.wait_until(lambda: self.browser.problems, "reported")
        self.assertEqual(self.browser.problems, ["the last"])

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
    unittest.main(failfast=True)  # a hang costs its limit of time once
