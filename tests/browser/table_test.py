"""The report's table: sorted, filtered, unfolded, and whole on the screen. The made-up study has two scenes, four
techniques and two lights: 16 rows, and 8 of means over both scenes, which show first."""
import unittest

from report_case import ReportCase

HEAD = "[...document.querySelectorAll('.figures thead th')]"
SHOWN = "[...document.querySelectorAll('.figures tbody')].filter(e => !e.hidden)"


class Table(ReportCase):
    def column(self, page, title):
        return page.ask(f"{HEAD}.findIndex(e => e.textContent.startsWith('{title}')) + 1")

    def values(self, page, title):
        column = self.column(page, title)
        return page.ask(f"{SHOWN}.map(e => e.rows[0].cells[{column - 1}].dataset.value)")

    def each_scene(self):
        page = self.open()
        page.choose("#filters [name=scene]", "")
        return page

    def sort(self, page, title):
        page.click(f".figures thead th:nth-child({self.column(page, title)}) button")

    def test_sorts_by_exact_figures_with_absent_ones_last(self):
        page = self.each_scene()
        for turn, falling in (("ascending", False), ("descending", True)):
            self.sort(page, "RMSE of all")
            values = self.values(page, "RMSE of all")
            self.assertEqual(values[-1], "")
            figures = [float(value) for value in values[:-1]]
            self.assertEqual(len(figures), 15)
            self.assertEqual(figures, sorted(figures, reverse=falling))
            self.assertEqual(page.ask(f"{HEAD}.map(e => e.getAttribute('aria-sort')).filter(e => e)"), [turn])

    def test_sorts_by_every_head_and_by_keyboard(self):
        page = self.each_scene()
        for title in page.ask(f"{HEAD}.filter(e => e.querySelector('button')).map(e => e.textContent)"):
            before = sorted(self.values(page, title[:6]))
            page.ask(f"{HEAD}.find(e => e.textContent === {title!r}).querySelector('button').focus()")
            page.press("Enter")
            values = self.values(page, title[:6])
            self.assertEqual(sorted(values), before, title)
            self.assertEqual(page.ask(f"{HEAD}.find(e => e.textContent === {title!r}).getAttribute('aria-sort')"),
                             "ascending")
        self.assertEqual(self.values(page, "Penumbra"), ["9000"] * 16)

    def test_details_go_with_their_row(self):
        page = self.each_scene()
        page.click(".figures tbody:not([hidden]) .unfold")
        mine = page.ask("document.querySelector('.figures tbody:not([hidden])').dataset.technique")
        self.sort(page, "Fetches")
        self.sort(page, "Fetches")
        self.assertEqual(page.ask("document.querySelectorAll('.detail.open').length"), 1)
        self.assertEqual(page.ask("document.querySelector('.detail.open').closest('tbody').dataset.technique"), mine)

    def test_filters_by_technique_scene_and_light(self):
        page = self.open()
        count = "document.querySelector('#filters output').textContent"
        self.assertEqual(page.ask(count), "8 rows")
        self.assertEqual(set(page.ask(f"{SHOWN}.map(e => e.rows[0].cells[1].textContent)")), {"mean of 2"})
        page.choose("#filters [name=technique]", "tent-5x5")
        self.assertEqual(page.ask(count), "2 rows")
        page.choose("#filters [name=scene]", "")
        self.assertEqual(page.ask(count), "4 rows")
        page.choose("#filters [name=scene]", "scene fence")
        page.choose("#filters [name=light]", "2")
        self.assertEqual(page.ask(f"{SHOWN}.map(e => [e.dataset.technique, e.dataset.scene, e.dataset.light])"),
                         [["tent-5x5", "scene fence", "2"]])
        page.click("#filters [type=reset]")
        page.wait(f"{count} === '8 rows'")

    def test_techniques_stand_by_title_and_are_found_by_title_or_name(self):
        page = self.open()
        cell = f"{SHOWN}.map(e => e.rows[0].cells[0].querySelector('.label'))"
        self.assertEqual(page.ask(f"{cell}.map(e => [e.textContent, e.title])[2]"), ["Title of tent-5x5", "tent-5x5"])
        self.assertEqual(page.ask("document.querySelector('#filters [name=technique]').options[2].text"),
                         "Title of tent-5x5")
        find = "(text => { const find = document.querySelector('#filters [name=find]'); find.value = text;" \
               " find.dispatchEvent(new Event('input', { bubbles: true })); })"
        for text, rows in (("title TENT", 2), ("of pcss-24", 2), ("pcss-64-64", 2), ("title", 8), ("nothing", 0)):
            page.ask(f"{find}({text!r})")
            self.assertEqual(len(page.ask(f"{SHOWN}.map(e => e.dataset.technique)")), rows, text)

    def test_every_error_has_its_interval(self):
        page = self.each_scene()
        column = self.column(page, "RMSE in penumbra")
        cell = f"document.querySelector('.figures tbody:not([hidden]) td:nth-child({column})').innerText"
        self.assertEqual(page.ask(cell).split(), ["0.255", "±", "0.004"])
        page.click(".figures tbody:not([hidden]) .unfold")
        self.assertIn("0.2523 to 0.2593", page.ask("document.querySelector('.detail.open').textContent"))

    def test_no_column_is_off_the_screen_at_1440(self):
        page = self.open(width=1440)
        page.choose("#filters [name=scene]", "")
        self.assertEqual(page.ask("document.scrollingElement.scrollWidth"), 1440)
        self.assertEqual(page.ask("(e => e.scrollWidth - e.clientWidth)(document.querySelector('#figures .scroll'))"), 0)
        right = page.ask("Math.max(...[...document.querySelectorAll('.figures tr.record > *')]"
                         ".map(e => e.getBoundingClientRect().right))")
        self.assertLessEqual(right, 1440)

    def test_the_first_two_columns_stay_when_the_others_move(self):
        page = self.open(width=800)
        places = ("['.technique', '.scene', '.figure:nth-of-type(3)'].map(e =>"
                  " document.querySelector('.figures tbody:not([hidden]) ' + e).getBoundingClientRect().left)")
        before = page.ask(places)
        page.ask("document.querySelector('#figures .scroll').scrollLeft = 150")
        after = page.ask(places)
        self.assertEqual(after[:2], before[:2])
        self.assertEqual(after[2], before[2] - 150)

    def test_heads_stay_when_rows_move(self):
        page = self.open()
        page.ask("document.querySelector('#figures .scroll').style.maxHeight = '300px'")
        page.choose("#filters [name=scene]", "")
        top = "document.querySelector('.figures thead th').getBoundingClientRect().top"
        before = page.ask(top)
        page.ask("document.querySelector('#figures .scroll').scrollTop = 200")
        self.assertEqual(page.ask(top), before)

    def test_at_390_the_page_stays_and_the_table_moves(self):
        page = self.open(width=390, height=844, touch=True)
        self.assertEqual(page.ask("document.scrollingElement.scrollWidth"), 390)
        self.assertTrue(page.ask("(e => e.scrollWidth > e.clientWidth)(document.querySelector('#figures .scroll'))"))
        name = page.ask("document.querySelector('.figures tr.record .technique').getBoundingClientRect().right")
        self.assertLess(name, 180, "most of the width is the figures'")

    def test_parameters_show_on_hover_on_focus_and_go_on_escape(self):
        page = self.open()
        hidden = "document.getElementById('tooltip').hidden"
        text = "document.getElementById('tooltip').textContent"
        page.hover(".figures tbody[data-technique=tent-5x5] .about")
        page.wait(f"!{hidden}")
        for word in ("Title of tent-5x5", "samples", "4 0.5", "2048 texels wide, D32, 4 cascades", "normal bias", "soft quality"):
            self.assertIn(word, page.ask(text))
        page.hover("#tooltip")
        page.ask("new Promise(done => setTimeout(done, 300))")
        self.assertFalse(page.ask(hidden), "it stays while the pointer is on it")
        page.press("Escape")
        self.assertTrue(page.ask(hidden))
        page.ask("document.querySelector('.figures tbody[data-technique=pcss-24-16] .about').focus()")
        self.assertIn("Title of pcss-24-16", page.ask(text))
        self.assertEqual(page.ask("document.activeElement.getAttribute('aria-describedby')"), "tooltip")
        box = page.ask("(b => [b.left, b.top, b.right, b.bottom])"
                       "(document.getElementById('tooltip').getBoundingClientRect())")
        self.assertTrue(box[0] >= 0 and box[1] >= 0 and box[2] <= 1440 and box[3] <= 900, box)

    def test_a_row_leads_to_its_pictures(self):
        page = self.open()
        page.choose("#filters [name=scene]", "")
        row = "tbody[data-technique='pcss-24-16'][data-scene='scene fence'][data-light='2']"
        page.click(f"{row} .to-pictures")
        page.wait("document.querySelector('.stage canvas').getAttribute('aria-label') ==="
                  " 'fence, 2 degree light: Ray traced and Title of pcss-24-16'")
        self.assertEqual(page.ask("document.activeElement.className"), "stage")
        self.assertEqual(page.ask("document.querySelectorAll('.figures tbody .to-pictures').length"), 4,
                         "only rows with pictures")

    def test_tables_say_what_their_heads_are(self):
        page = self.open()
        self.assertEqual(page.ask("[...document.querySelectorAll('thead th')].filter(e => e.scope !== 'col').length"), 0)
        self.assertEqual(page.ask("[...document.querySelectorAll('tr.record')]"
                                  ".filter(e => e.querySelector('th').scope !== 'row').length"), 0)


if __name__ == "__main__":
    unittest.main(failfast=True)  # a hang costs its limit of time once
