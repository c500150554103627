"""The report's charts: points that say what they are, in the page's own colours."""
import unittest

from report_case import ReportCase

LIT = "[...document.querySelectorAll('.point.lit')].map(e => e.dataset.technique)"
TEXT = "document.getElementById('tooltip').textContent"


class Charts(ReportCase):
    def test_a_point_says_its_figures_and_shows_its_technique_everywhere(self):
        page = self.open()
        page.hover("#cost .panel .point[data-technique='tent-5x5'] .reach")
        page.wait("!document.getElementById('tooltip').hidden")
        for word in ("Title of tent-5x5", "penumbra RMSE", "fetches per pixel", "mean of 2 scenes"):
            self.assertIn(word, page.ask(TEXT))
        self.assertEqual(page.ask(LIT), ["tent-5x5"] * 4, "two charts, two lights")
        page.mouse("mouseMoved", 2, 2)
        page.wait("document.getElementById('tooltip').hidden")
        self.assertEqual(page.ask(LIT), [])

    def test_arrow_keys_go_from_point_to_point(self):
        page = self.open()
        self.assertEqual(page.ask("document.querySelectorAll('.panel:first-child .point[tabindex=\"0\"]').length"), 2,
                         "one stop for each panel")
        page.ask("document.querySelector('#cost .point').focus()")
        self.assertIn("bilinear", page.ask(TEXT))
        page.press("ArrowRight")
        self.assertIn("tent-5x5", page.ask(TEXT))
        page.press("ArrowLeft")
        page.press("ArrowLeft")
        self.assertIn("pcss-64-64", page.ask(TEXT))

    def test_a_click_shows_the_techniques_rows(self):
        page = self.open()
        page.click("#cost .point[data-technique='pcss-24-16'] .reach")
        page.wait("document.querySelector('#filters output').textContent === '2 rows'")
        self.assertEqual(page.ask("location.hash"), "#figures")

    def test_the_label_of_each_axis_is_whole_and_inside(self):
        for width in (1440, 390):
            page = self.open(width=width, height=900)
            cut = page.ask("""[...document.querySelectorAll('.panel svg')].flatMap(svg =>
                [...svg.querySelectorAll('text')].filter(e => {
                  const [own, all] = [e.getBoundingClientRect(), svg.getBoundingClientRect()];
                  return own.left < all.left || own.right > all.right || own.bottom > all.bottom;
                }).map(e => e.textContent))""")
            self.assertEqual(cut, [], width)

    def test_charts_follow_the_scheme(self):
        page = self.open()
        ground = "getComputedStyle(document.querySelector('.panel svg rect')).fill"
        light = page.ask(ground)
        page.set_dark(True)
        dark = page.ask(ground)
        self.assertEqual((light, dark), ("rgb(255, 255, 255)", "rgb(28, 31, 36)"))

    def test_words_of_charts_are_readable_at_390(self):
        page = self.open(width=390, height=844)
        size = page.ask("""Math.min(...[...document.querySelectorAll('.panel svg text')].map(e =>
            parseFloat(getComputedStyle(e).fontSize) * Math.hypot(e.getScreenCTM().a, e.getScreenCTM().b)))""")
        self.assertGreaterEqual(size, 10.0)
        self.assertTrue(page.ask("[...document.querySelectorAll('.panel')].every(e => e.getBoundingClientRect().right < 390)"))


if __name__ == "__main__":
    unittest.main(failfast=True)  # a hang costs its limit of time once
