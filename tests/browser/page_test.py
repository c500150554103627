"""The report as a whole: it loads nothing, names cannot harm it, its words stand out, its parts are in order."""
import unittest

from report_case import ReportCase

# The colour, ground, size and weight of every element with words of its own, with the contrast of WCAG 2.2.
CONTRASTS = r"""(() => {
  const numbers = colour => {
    const context = new OffscreenCanvas(1, 1).getContext('2d');
    context.fillStyle = colour; context.fillRect(0, 0, 1, 1);
    return [...context.getImageData(0, 0, 1, 1).data];
  };
  const luminance = ([r, g, b]) => [r, g, b].map(v => v / 255)
    .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const groundOf = element => {
    for (let at = element; at; at = at.parentElement) {
      const ground = at.ownerSVGElement === null && at.tagName === 'svg' ? getComputedStyle(at.querySelector('rect')).fill
        : getComputedStyle(at).backgroundColor;
      const colour = numbers(ground);
      if (colour[3] > 180) return colour;
    }
    return numbers(getComputedStyle(document.body).backgroundColor);
  };
  const bad = [];
  for (const element of document.querySelectorAll('body *:not(script):not(option)')) {
    const words = [...element.childNodes].filter(n => n.nodeType === 3 && n.data.trim() !== '');
    if (words.length === 0 || element.getClientRects().length === 0) continue;
    const style = getComputedStyle(element);
    const ink = numbers(element instanceof SVGElement ? style.fill : style.color);
    const [a, b] = [luminance(ink), luminance(groundOf(element))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) bad.push(`${element.tagName}.${element.className} "${words[0].data.trim().slice(0, 30)}" ${contrast.toFixed(2)}`);
  }
  return bad;
})()"""


class Page(ReportCase):
    def test_words_stand_out_in_both_schemes(self):
        page = self.open()
        page.click(".unfold")
        page.ask("document.querySelector('.about').focus()")
        for dark in (False, True):
            page.set_dark(dark)
            self.assertEqual(page.ask(CONTRASTS), [], "dark" if dark else "light")

    def test_evil_names_run_nothing(self):
        page = self.open(kind="evil")
        page.wait("document.querySelector('.tag.right').textContent.includes('<script>')")
        self.assertEqual(page.ask("document.querySelectorAll('img').length"), 0)
        page.hover(".about")
        self.assertIn("<script>", page.ask("document.getElementById('tooltip').textContent"))
        page.hover("#cost .point .reach")
        self.assertIn("<script>", page.ask("document.getElementById('tooltip').textContent"))
        for row, rows in ((2, "8 rows"), (1, "16 rows")):
            page.ask(f"document.querySelector('#filters [name=scene]').selectedIndex = {row}")
            page.ask("document.getElementById('filters').dispatchEvent(new Event('input'))")
            self.assertEqual(page.ask("document.querySelector('#filters output').textContent"), rows)
        page.click("#cost .point .reach")
        page.wait("document.querySelector('#filters [name=technique]').value.includes('<script>')")
        page.click("tbody[data-light='2']:not([hidden]) .to-pictures")
        page.wait("location.hash.startsWith('#picture-')")
        self.assertEqual(page.ask("document.querySelectorAll('img').length"), 0)

    def test_nothing_is_asked_of_a_network(self):
        page = self.open()
        self.assertEqual(page.ask("performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:')).length"),
                         0)

    def test_every_button_may_be_pressed(self):
        page = self.open()
        page.ask("for (const button of document.querySelectorAll('button')) { button.click(); button.click(); }")
        page.ask("new Promise(done => setTimeout(done, 100))")

    def test_headings_are_in_order(self):
        page = self.open()
        levels = page.ask("[...document.querySelectorAll('h1, h2, h3, h4')].map(e => Number(e.tagName[1]))")
        self.assertEqual(levels.count(1), 1)
        self.assertTrue(all(b <= a + 1 or b == 4 for a, b in zip(levels, levels[1:])), levels)

    def test_every_control_has_a_name(self):
        page = self.open()
        nameless = page.ask("""[...document.querySelectorAll('button, select, input, [role=slider], [role=img], a')]
            .filter(e => !(e.textContent.trim() || e.getAttribute('aria-label') || e.closest('label')?.textContent.trim()))
            .map(e => e.outerHTML)""")
        self.assertEqual(nameless, [])

    def test_focus_is_seen(self):
        page = self.open()
        for selector in ("nav a", ".figures thead button", ".about", ".unfold", ".divider", ".techniques button"):
            page.ask(f"document.querySelector({selector!r}).focus()")
            page.press("Tab")  # it tells the browser that a keyboard is used
            page.ask(f"document.querySelector({selector!r}).focus()")
            seen = page.ask("""[document.activeElement, ...document.activeElement.children].some(e =>
                getComputedStyle(e).outlineStyle !== 'none' && parseFloat(getComputedStyle(e).outlineWidth) >= 2)""")
            self.assertTrue(seen, selector)

    def test_without_pictures_it_says_how_to_get_them(self):
        page = self.open(kind="figures")
        self.assertIn("--output report", page.ask("document.getElementById('pictures').textContent"))
        self.assertEqual(page.ask("document.querySelectorAll('.to-pictures').length"), 0)

    def test_findings_stand_above_everything(self):
        page = self.open(kind="findings")
        self.assertIn("3 results are NaN, infinite or outside [0, 1]", page.ask("document.querySelector('header .finding').textContent"))

    def test_no_page_is_wider_than_its_window(self):
        for kind in ("whole", "figures", "evil"):
            for width in (1440, 1024, 390, 320):
                page = self.open(kind=kind, width=width)
                self.assertLessEqual(page.ask("document.scrollingElement.scrollWidth"), width, f"{kind} at {width}")


if __name__ == "__main__":
    unittest.main(failfast=True)  # a hang costs its limit of time once
