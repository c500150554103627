"""The report's picture viewer: slider, blinking, zoom and error scale, asked for the pixels that they show.

The made-up pictures are 48 x 24: no surface in the first four rows, below it ray-traced visibility from 0 at column
16 to 1 at column 32, and the technique's from 0 at column 20 to 1 at column 28 (pcss-24-16) or 24 (bilinear).
"""
import unittest

from report_case import ReportCase

SKY = [168, 180, 196]


class ViewerCase(ReportCase):
    def viewer(self, **view):
        page = self.open(**view)
        page.click("#viewer .techniques button:nth-child(2)")
        page.wait("document.querySelector('.tag.right').textContent === 'Title of pcss-24-16'")
        return page

    def samples(self, page, area):
        """The pixels of an area of the stage's canvas, [x, y, width, height] in JavaScript: red, green, blue and alpha in
        turn. They are read from a copy: a browser that sees a canvas read often keeps it elsewhere."""
        return page.ask(f"""(c => {{
            const copy = new OffscreenCanvas(c.width, c.height).getContext('2d', {{ willReadFrequently: true }});
            copy.drawImage(c, 0, 0);
            return [...copy.getImageData(...{area}).data];
        }})(document.querySelector('.stage canvas'))""")

    def pixel(self, page, column, row):
        """The colour that the stage shows in the middle of a pixel of the picture at zoom 1."""
        at = f"[Math.floor(({column} + 0.5) * c.width / 48), Math.floor(({row} + 0.5) * c.height / 24), 1, 1]"
        return self.samples(page, at)[:3]

    def grey(self, value):
        return [round(255 * value)] * 3

    def side(self, page, value):
        """Moves the border to one end, so that the left or the right picture is alone."""
        page.ask("document.querySelector('.divider').focus()")
        page.press({"left": "End", "right": "Home"}[value])


class Comparison(ViewerCase):
    def test_shows_the_exact_numbers_of_both_pictures(self):
        page = self.viewer()
        self.side(page, "left")
        for column in (4, 20, 24, 31, 40):
            self.assertEqual(self.pixel(page, column, 12), self.grey(min(max((column - 16) / 16, 0), 1)), column)
        self.assertEqual(self.pixel(page, 24, 1), SKY)
        self.side(page, "right")
        for column in (4, 20, 24, 27, 40):
            self.assertEqual(self.pixel(page, column, 12), self.grey(min(max((column - 20) / 8, 0), 1)), column)
        self.assertEqual(self.pixel(page, 24, 1), SKY)

    def test_the_slider_moves_by_pointer_and_by_keyboard(self):
        page = self.viewer()
        now = "Number(document.querySelector('.divider').getAttribute('aria-valuenow'))"
        traced, result = self.grey(2 / 16), self.grey(0)
        self.assertEqual(page.ask(now), 50)
        self.assertEqual(self.pixel(page, 18, 12), traced)
        page.drag(".stage", (0.5, 0.6), (0.25, 0.6))
        self.assertEqual(page.ask(now), 25)
        self.assertEqual(self.pixel(page, 18, 12), result, "now right of the border")
        page.drag(".divider", (0.5, 0.7), (6.0, 0.7))
        self.assertGreater(page.ask(now), 40)
        self.assertEqual(self.pixel(page, 18, 12), traced)
        page.ask("document.querySelector('.divider').focus()")
        page.press("Home")
        self.assertEqual(page.ask(now), 0)
        for _ in range(5):
            page.press("ArrowRight")
        self.assertEqual(page.ask(now), 10)
        page.press("End")
        self.assertEqual(page.ask(now), 100)

    def test_blinking_shows_one_picture_after_the_other(self):
        page = self.viewer()
        traced, result = self.grey(2 / 16), self.grey(0)
        page.click("#viewer [value=blink] + span")
        seen = set()
        while len(seen) < 2:
            seen.add(tuple(self.pixel(page, 18, 12)))
        self.assertEqual(seen, {tuple(result), tuple(traced)})
        self.assertTrue(page.ask("document.querySelector('.divider').hidden"))
        page.ask("document.querySelector('.stage').focus()")
        page.press("b")
        self.assertFalse(page.ask("document.querySelector('.divider').hidden"))
        self.assertEqual(page.ask("document.querySelector('#viewer [value=slider]').checked"), True)

    def test_swaps_sides(self):
        page = self.viewer()
        page.ask("document.querySelector('.stage').focus()")
        page.press("x")
        page.wait("document.querySelector('.tag.left').textContent === 'Title of pcss-24-16'")
        self.assertEqual(self.pixel(page, 18, 12), self.grey(0))

    def test_takes_the_next_technique_and_compares_two(self):
        page = self.viewer()
        page.ask("document.querySelector('.stage').focus()")
        page.press("n")
        page.wait("document.querySelector('.tag.right').textContent === 'Title of bilinear'")
        self.side(page, "right")
        self.assertEqual(self.pixel(page, 25, 12), self.grey(1))
        page.choose("#viewer [name=left]", "item-pcss-24-16")
        page.wait("document.querySelector('.tag.left').textContent === 'Title of pcss-24-16'")
        self.side(page, "left")
        self.assertEqual(self.pixel(page, 25, 12), self.grey(5 / 8))


class Errors(ViewerCase):
    def test_the_error_is_computed_in_the_colours_of_the_picture_files(self):
        page = self.viewer()
        page.click("#viewer [value=error] + span")
        page.wait("document.querySelector('.tag.right').textContent === 'Title of pcss-24-16: error'")
        self.side(page, "right")
        ramp = page.ask("[...atob(JSON.parse(document.getElementById('picture-index').textContent).ramps.error)]"
                        ".map(c => c.charCodeAt(0))")
        for column in (4, 18, 22, 26, 30):
            traced = round(255 * min(max((column - 16) / 16, 0), 1))
            result = round(255 * min(max((column - 20) / 8, 0), 1))
            place = 3 * int(((result - traced) / 255 / 0.5 + 1) / 2 * 255 + 0.5)
            self.assertEqual(self.pixel(page, column, 12), ramp[place:place + 3], column)
        self.assertEqual(self.pixel(page, 24, 1), SKY)

    def test_the_reader_sets_how_strong_an_error_shows(self):
        page = self.viewer()
        page.click("#viewer [value=error] + span")
        page.wait("document.querySelector('.tag.right').textContent === 'Title of pcss-24-16: error'")
        self.side(page, "right")
        before = self.pixel(page, 18, 12)
        page.choose("#viewer [name=scale]", 0)
        page.wait("document.querySelector('.legend .to').textContent === '+0.01 too bright'")
        self.assertNotEqual(self.pixel(page, 18, 12), before)
        self.assertEqual(page.ask("document.querySelector('.scale output').textContent"), "0.01")
        ramp = page.ask("[...atob(JSON.parse(document.getElementById('picture-index').textContent).ramps.error)]"
                        ".map(c => c.charCodeAt(0))")
        self.assertEqual(self.pixel(page, 18, 12), ramp[:3], "as dark as the scale goes")

    def test_reads_numbers_under_the_pointer(self):
        page = self.viewer()
        for column, row, words in (
                (24, 12, "Pixel 24, 12: ray traced 0.502, Title of pcss-24-16 0.502, error 0.000, 40 fetches"),
                (18, 12, "Pixel 18, 12: ray traced 0.125, Title of pcss-24-16 0.000, error −0.125, 40 fetches"),
                (18, 1, "Pixel 18, 1: no surface")):
            page.hover(".stage canvas", ((column + 0.5) / 48, (row + 0.5) / 24))
            page.wait(f"document.querySelector('.readout').textContent === {words!r}")

    def test_results_that_are_no_visibility_stand_out(self):
        page = self.open(kind="findings")
        page.click("#viewer .techniques button:nth-child(2)")
        page.wait("document.querySelector('.tag.right').textContent === 'Title of pcss-24-16'")
        self.side(page, "right")
        self.assertEqual(self.pixel(page, 1, 20), [255, 0, 255])
        self.assertEqual(self.pixel(page, 5, 20), [0, 0, 0])


class Zoom(ViewerCase):
    def shown_column(self, page):
        """The picture's column in the middle of the stage, by the readout."""
        page.ask("document.querySelector('.readout').textContent = ''")
        page.hover(".stage canvas", (0.5, 0.8))
        page.wait("document.querySelector('.readout').textContent !== ''")
        return int(page.ask("document.querySelector('.readout').textContent").split()[1].rstrip(","))

    def test_enlarges_pixels_as_squares_and_moves(self):
        page = self.viewer()
        fit = page.ask("document.querySelector('.zoom output').textContent")
        for _ in range(3):
            page.click(".zoom [name=in]")
        self.assertNotEqual(page.ask("document.querySelector('.zoom output').textContent"), fit)
        self.assertIn(self.shown_column(page), (23, 24))
        # Six pixels of the picture fill the stage: only their colours are there, none in between.
        self.side(page, "left")
        line = self.samples(page, "[0, Math.floor(c.height / 2), c.width, 1]")
        self.assertLessEqual(len(set(line[::4])), 7)
        page.ask("document.querySelector('.stage').focus()")
        page.press("ArrowRight")
        page.press("ArrowRight")
        page.press("ArrowRight")
        self.assertGreater(self.shown_column(page), 24)
        page.drag(".stage", (0.3, 0.5), (0.9, 0.5))
        self.assertLess(self.shown_column(page), 24)
        page.press("0")
        self.assertEqual(page.ask("document.querySelector('.zoom output').textContent"), fit)

    def test_the_wheel_zooms_with_ctrl_alone(self):
        page = self.viewer()
        fit = page.ask("document.querySelector('.zoom output').textContent")
        x, y = page.middle(".stage", (0.5, 0.5))
        page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-200)
        self.assertEqual(page.ask("document.querySelector('.zoom output').textContent"), fit)
        x, y = page.middle(".stage", (0.5, 0.5))
        page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-200, modifiers=2)
        page.wait(f"document.querySelector('.zoom output').textContent !== {fit!r}")

    def test_fits_390(self):
        page = self.viewer(width=390, height=844)
        box = page.ask("(b => [b.left, b.right])(document.querySelector('.stage').getBoundingClientRect())")
        self.assertTrue(0 <= box[0] and box[1] <= 390, box)
        self.side(page, "left")
        self.assertEqual(self.pixel(page, 24, 12), self.grey(0.5))


class Choices(ViewerCase):
    def test_every_picture_decodes_and_names_its_stage(self):
        page = self.open()
        ids = page.ask("[...document.querySelectorAll('script[id^=png-]')].length")
        self.assertEqual(ids, 12)
        self.assertTrue(page.ask(f"""Promise.all([...Array({ids}).keys()].map(id => new Promise((yes, no) => {{
            const image = new Image(); image.onload = () => yes(image.naturalWidth); image.onerror = no;
            image.src = 'data:image/png;base64,' + document.getElementById('png-' + id).textContent;
        }}))).then(all => all.every(width => width === 48))"""))

    def test_another_scene_keeps_the_technique(self):
        page = self.viewer()
        page.choose("#viewer [name=scene]", "fence")
        page.wait("document.querySelector('.stage canvas').getAttribute('aria-label').startsWith('fence')")
        self.assertEqual(page.ask("document.querySelector('.tag.right').textContent"), "Title of pcss-24-16")

    def test_an_address_opens_its_picture(self):
        page = self.open(fragment="#picture-2")
        page.wait("document.querySelector('.tag.right').textContent === 'Title of bilinear'")
        self.assertEqual(page.ask("document.querySelector('#viewer [name=scene]').value"), "fence")

    def test_what_a_technique_lacks_is_not_offered(self):
        page = self.open()
        self.assertTrue(page.ask("document.querySelector('#viewer [value=mask]').disabled"))
        self.assertFalse(page.ask("document.querySelector('#viewer [value=fetches]').disabled"))


if __name__ == "__main__":
    unittest.main(failfast=True)  # a hang costs its limit of time once
