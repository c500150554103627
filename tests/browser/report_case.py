"""The base of the report's tests: it has the made-up reports as files and one browser, and pages say nothing wrong."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from chromium import Chromium

PROGRAM = os.environ.get("PENUMBRA_SYNTHETIC_REPORT", "")


class ReportCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="penumbra-report-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.browser = cls.enterClassContext(Chromium())

    def setUp(self):
        self.browser.problems.clear()
        self.addCleanup(lambda: self.assertEqual(self.browser.problems, [], "the page's own errors"))

    def report(self, kind):
        file = self.folder / f"{kind}.html"
        if not file.exists():
            file.write_bytes(subprocess.run([PROGRAM, kind], check=True, stdout=subprocess.PIPE).stdout)
        return file

    def open(self, kind="whole", **view):
        page = self.enterContext(self.browser.open(self.report(kind), **view))
        if kind != "figures":
            page.wait("document.querySelector('.legend .to').textContent !== ''")  # the viewer has drawn
        return page
