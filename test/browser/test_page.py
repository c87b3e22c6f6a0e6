"""The page of quality_mesh (-o mesh.html) in a browser, clicked through as people do: by pointer, keys and fingers.

Numbers are compared with those of the files of Triangle that the same run writes, measured by other formulas. Colors of
pixels are compared with what the triangles there have to have. Where triangles are on the screen is found from the
coordinates that the page tells under the pointer.
"""

import math
import os
import re
import tempfile
import unittest

import browser
from meshes import Mesh

ANGLE_COLORS = ['67001f', 'b2182b', 'd6604d', 'f4a582', 'fdcc8a', 'fee8a0', 'd9ef8b', 'a6d96a', '7fc97f', '66c2a5',
                '5aaec4', '4393c3']
REGION_COLORS = ['a6cee3', 'fdbf6f', 'b2df8a', 'fb9a99', 'cab2d6', 'ffff99', '8dd3c7', 'f4cae4', 'd9d9d9', '80b1d3',
                 'e6d8ad', 'ccebc5']
SIZE_COLORS = ['2f5597', '3f8fb5', '6fc0b5', 'bfe0b0', 'f7f3c6']
NO_REGION, INK, UNMET, QUADTREE = 'e8f1f8', '12263a', 'd6006c', '9c3fb0'
UNITED_STATES = 'us_states_10m.poly.gz'


def rgb(color):
    return tuple(int(color[i:i + 2], 16) for i in (0, 2, 4))


def distance(a, b):
    return max(abs(i - j) for i, j in zip(a, b))


def digits(text):
    """Of a number with gaps between thousands."""
    return re.sub(r'[^0-9]', '', text)


def angle_color(mesh):
    """What a triangle's color has to be by its least angle; at a multiple of five degrees, that from there on."""
    return lambda t: rgb(ANGLE_COLORS[min(11, int(mesh.angles(t)[0] / 5 + 1e-6))])


class Screen:
    """Where places of the plane are on the page, from what the page says at two places of the pointer."""

    def __init__(self, window, corners=((60, 120), (860, 720))):
        said = []
        for corner in corners:
            window.move(*corner)
            said.append([float(c) for c in window.text('#place').split()])
        (px0, py0), (px1, py1) = corners
        self.scale = [(said[1][0] - said[0][0]) / (px1 - px0), (said[1][1] - said[0][1]) / (py1 - py0)]
        self.origin = [said[0][0] - px0 * self.scale[0], said[0][1] - py0 * self.scale[1]]

    def at(self, place):
        return tuple((c - o) / s for c, o, s in zip(place, self.origin, self.scale))

    def pixels(self, length):
        return length / self.scale[0]


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if browser.find_browser() is None:
            if 'QUADTREE_MESH_REQUIRE_BROWSER' in os.environ:
                raise RuntimeError('no Chromium (Debian: chromium-headless-shell)')
            raise unittest.SkipTest('no Chromium')
        cls.window = browser.Browser()
        cls.addClassCleanup(cls.window.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='quadtree_mesh_2_')
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def tearDown(self):
        """A page asks for nothing from anywhere, and nothing in it goes wrong."""
        self.assertEqual(self.window.complaints, [])
        self.assertEqual([url for url in self.window.requests if not url.startswith(('file:///', 'data:'))], [])
        self.assertLessEqual(sum(url.startswith('file:') for url in self.window.requests), 1)

    def mesh(self, *arguments, **more):
        return Mesh(self.folder, *arguments, **more)

    def tip(self):
        """What the page tells of the triangle under the pointer: its number, and its measures by name."""
        if self.window.text('#tip') is None:
            return None
        values = self.window.evaluate('Object.fromEntries([...document.querySelectorAll("#tip dd")]'
                                      '.map(e => [e.dataset.of, e.textContent]))')
        vertices = self.window.evaluate('[...document.querySelectorAll("#tip tr")].slice(1)'
                                        '.map(row => [...row.children].map(cell => cell.textContent))')
        return int(digits(self.window.text('#tip h2').split('unmet')[0])), values, vertices

    def check_tip(self, mesh, t):
        number, values, vertices = self.tip()
        self.assertEqual(number, t + mesh.first)
        least, largest = mesh.angles(t)
        self.assertAlmostEqual(float(values['least'].rstrip('\u00b0')), least, delta=6e-5)
        self.assertAlmostEqual(float(values['largest'].rstrip('\u00b0')), largest, delta=6e-5)
        self.assertAlmostEqual(float(values['longest']) / mesh.sides(t)[2], 1, delta=1e-5)
        self.assertAlmostEqual(float(values['area']) / mesh.area(t), 1, delta=1e-5)
        told = {int(digits(v)) - mesh.first: (float(x), float(y)) for v, x, y in vertices}
        self.assertEqual(told, {v: mesh.points[v] for v in mesh.triangles[t]})  # bit for bit

    def check_colors(self, mesh, screen, color_of, triangles, slack=2):
        """Middles of triangles have their colors, where these are not within a hair of the next one."""
        self.window.move(2, 798)  # where there is nothing to tell
        picture = self.window.picture()
        for t in triangles:
            x, y = screen.at(mesh.centroid(t))
            with self.subTest(triangle=t, place=(x, y)):
                self.assertLessEqual(distance(picture.getpixel((int(x), int(y))), color_of(t)), slack)

    def large_triangles(self, mesh, screen, n=200):
        """Those with room for a pixel, and not under the panel."""
        return [t for t in mesh.widest(n) if screen.pixels(mesh.inner_radius(t)) > 6 and
                screen.at(mesh.centroid(t))[0] < 900]

    # --- numbers ---

    def test_counts_and_histogram(self):
        mesh = self.mesh(UNITED_STATES)
        self.window.open(mesh.page)
        self.assertEqual(self.window.evaluate('document.title'), UNITED_STATES)
        counts = self.window.text('#counts')
        least, largest = zip(*map(mesh.angles, range(len(mesh.triangles))))
        self.assertEqual([digits(part) for part in re.split('triangle|vertices', counts)[:2]],
                         [str(len(mesh.triangles)), str(len({v for t in mesh.triangles for v in t}))])
        self.assertIn(f'least angle {min(least):.2f}\u00b0', counts)
        self.assertIn(f'largest angle {max(largest):.2f}\u00b0', counts)
        self.assertNotIn('unmet', counts)
        expected = [0] * 60
        for angle in least:
            expected[min(59, int(angle))] += 1
        told = [int(n) for n in self.window.evaluate('document.getElementById("legend").dataset.counts').split()]
        # Single precision may put an angle of a whole number of degrees into the bin beside it.
        self.assertEqual(sum(told), len(mesh.triangles))
        self.assertLessEqual(sum(abs(a - b) for a, b in zip(told, expected)), 4)

    def test_numbers_under_the_pointer(self):
        mesh = self.mesh(UNITED_STATES)
        self.window.open(mesh.page)
        screen = Screen(self.window)
        triangles = self.large_triangles(mesh, screen)
        self.assertGreater(len(triangles), 20)
        for t in triangles[:20]:
            self.window.move(*screen.at(mesh.centroid(t)))
            self.check_tip(mesh, t)
        self.window.move(2, 400)  # outside
        self.assertIsNone(self.tip())

    def test_the_extreme_triangle_is_shown_by_a_click(self):
        mesh = self.mesh(UNITED_STATES)
        self.window.open(mesh.page)
        self.window.click('#counts button')
        t = min(range(len(mesh.triangles)), key=lambda t: mesh.angles(t)[0])
        self.check_tip(mesh, t)
        screen = Screen(self.window)
        self.assertGreater(screen.pixels(mesh.sides(t)[2]), 60)
        self.window.move(*screen.at(mesh.centroid(t)))
        self.check_tip(mesh, t)

    def test_degrees_are_told_and_angles_are_those_on_the_ground(self):
        mesh = self.mesh('island.geojson', '--project', 'mercator', '--renumber')
        self.window.open(mesh.page)
        number, values, vertices = 0, {}, []
        for x in range(100, 800, 60):
            self.window.move(x, 400)
            if not self.tip():
                continue
            number, values, vertices = self.tip()
            told = {int(digits(v)) - mesh.first: (float(x), float(y)) for v, x, y in vertices}
            self.assertEqual(told, {v: mesh.points[v] for v in mesh.triangles[number - mesh.first]})
            places = [(math.radians(x), math.asinh(math.tan(math.radians(y)))) for x, y in told.values()]
            a, b, c = sorted((math.dist(places[i], places[j]) for i, j in ((0, 1), (1, 2), (2, 0))))
            least = math.degrees(math.acos((b * b + c * c - a * a) / (2 * b * c)))
            self.assertAlmostEqual(float(values['least'].rstrip('\u00b0')), least, delta=1e-4)
            # Under the pointer is a place of this triangle, in degrees.
            place = [float(c) for c in self.window.text('#place').split()]
            for i in (0, 1):
                self.assertGreaterEqual(place[i], min(p[i] for p in told.values()) - 1e-6)
                self.assertLessEqual(place[i], max(p[i] for p in told.values()) + 1e-6)
        self.assertTrue(vertices)

    # --- colors ---

    def test_colors_stand_for_what_the_menu_says(self):
        mesh = self.mesh('island.geojson', '--project', 'none', '--region-property', 'depth', '--color', 'region')
        self.window.open(mesh.page)
        screen = Screen(self.window)
        triangles = self.large_triangles(mesh, screen)
        self.assertGreater(len(triangles), 20)
        picture, of_region = self.window.picture(), {}
        for t in triangles:
            self.window.move(*screen.at(mesh.centroid(t)))
            name = self.tip()[1]['region']
            color = rgb(NO_REGION if name == 'none' else REGION_COLORS[int(name.split()[0])])
            of_region.setdefault(name, color)
            x, y = screen.at(mesh.centroid(t))
            self.assertLessEqual(distance(picture.getpixel((int(x), int(y))), color), 2)
        self.assertEqual(set(of_region), {'0 (2.5)', '1 (4)', '2 (-1)', '3 (4)', 'none'})
        self.window.choose('#color', 'least_angle')
        self.check_colors(mesh, screen, angle_color(mesh), triangles)
        self.window.choose('#color', 'largest_angle')
        self.check_colors(mesh, screen, lambda t: rgb(ANGLE_COLORS[max(0, int((120 - mesh.angles(t)[1]) / 5 + 1e-6))]),
                          triangles)
        self.window.choose('#color', 'none')
        self.check_colors(mesh, screen, lambda t: rgb(NO_REGION), triangles)
        self.window.choose('#color', 'size')
        sizes = [math.log10(mesh.sides(t)[2]) for t in range(len(mesh.triangles))]

        def color_of_size(t):
            place = (sizes[t] - min(sizes)) / (max(sizes) - min(sizes)) * 4
            i = min(3, int(place))
            return [a + (place - i) * (b - a) for a, b in zip(rgb(SIZE_COLORS[i]), rgb(SIZE_COLORS[i + 1]))]
        self.check_colors(mesh, screen, color_of_size, triangles)
        self.window.key('c')  # the next one is that by region again
        self.assertEqual(self.window.evaluate('document.getElementById("color").value'), 'region')

    def test_edges_and_segments_are_shown_and_hidden(self):
        mesh = self.mesh('syn_square.poly', '--max-edge', '0.3')
        self.window.open(mesh.page)
        screen = Screen(self.window)
        on_segments = {frozenset(edge) for edge in mesh.segments}
        middles = {True: [], False: []}
        for t in mesh.triangles:
            for k in range(3):
                edge = frozenset((t[k], t[(k + 1) % 3]))
                middles[edge in on_segments].append(tuple(sum(c) / 2 for c in zip(*(mesh.points[v] for v in edge))))

        def darkest(places):
            """Of the pixels around each place, the darkest: their mean brightness."""
            picture, total = self.window.picture(), 0
            for place in places:
                x, y = map(int, screen.at(place))
                total += min(sum(picture.getpixel((x + i, y + j))) for i in (-1, 0, 1) for j in (-1, 0, 1))
            return total / len(places) / 3
        both = {kind: darkest(places) for kind, places in middles.items()}
        self.window.click('#show-edges')
        self.assertGreater(darkest(middles[False]), both[False] + 40)
        self.assertLess(darkest(middles[True]), 80)
        self.window.key('s')
        self.assertGreater(darkest(middles[True]), both[True] + 80)
        self.window.key('s')
        self.window.key('e')
        self.assertEqual({kind: darkest(places) for kind, places in middles.items()}, both)

    def test_the_quadtree_is_shown_on_request(self):
        self.window.open(self.mesh('syn_square.poly').page)
        self.assertIsNone(self.window.text('#row-quadtree'))
        # A square with two vertices near its upper left corner, where squares of the tree have to be small.
        graph = os.path.join(self.folder, 'corner.poly')
        with open(graph, 'w', encoding='ascii') as file:
            file.write('6 2 0 0\n0 0 0\n1 64 0\n2 64 64\n3 0 64\n4 3 61\n5 6 58\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n')
        self.window.open(self.mesh(graph, '--show-quadtree', '--color', 'none').page)
        self.assertIsNotNone(self.window.text('#row-quadtree'))
        root = self.window.evaluate('JSON.parse(document.getElementById("head").textContent).quadtree')
        self.assertEqual(root, {'x': -64, 'y': -64, 'side': 256})
        self.window.key('-')
        screen = Screen(self.window)
        self.window.move(2, 798)
        shown = self.window.picture()
        self.window.key('q')
        hidden = self.window.picture()

        def lines(low, high):
            """The number of pixels in a box of the plane that are of lines of the tree."""
            (x0, y1), (x1, y0) = ([round(c) for c in screen.at(corner)] for corner in (low, high))
            return sum(distance(shown.getpixel((x, y)), hidden.getpixel((x, y))) > 30
                       for x in range(x0, x1) for y in range(y0, y1))
        # Vertices at two corners of the square are in one square of the tree only if that is not split, as it is.
        for share in (0.1, 0.3, 0.7, 0.9):
            self.assertGreater(lines((31, 64 * share - 1), (33, 64 * share + 1)), 3)
            self.assertGreater(lines((64 * share - 1, 31), (64 * share + 1, 33)), 3)
        self.assertGreater(lines((1, 49), (15, 63)), 100)
        for low in ((49, 1), (1, 1), (49, 49)):
            self.assertEqual(lines(low, [c + 14 for c in low]), 0)

    def test_unmet_triangles_are_marked(self):
        mesh = self.mesh('syn_square.poly', '--max-area', '0.02', '--max-vertices', '40', statuses=(1,))
        unmet = [t for t in range(len(mesh.triangles)) if mesh.area(t) > 0.02]
        self.assertGreater(len(unmet), 3)
        self.window.open(mesh.page)
        self.assertEqual(digits(self.window.text('#number-unmet')), str(len(unmet)))
        self.assertIn(f'{len(unmet)} unmet', self.window.text('#counts'))
        screen = Screen(self.window)

        def is_ringed(picture, t):
            x, y = screen.at(mesh.centroid(t))
            return all(distance(picture.getpixel((int(x + i), int(y + j))), rgb(UNMET)) < 60
                       for i, j in ((9, 0), (-9, 0), (0, 9), (0, -9)))
        picture = self.window.picture()
        self.assertEqual([t for t in range(len(mesh.triangles)) if is_ringed(picture, t)], unmet)
        self.window.key('u')
        picture = self.window.picture()
        self.assertFalse(any(is_ringed(picture, t) for t in unmet))
        for t in unmet[:3]:
            self.window.click('#next')
            self.check_tip(mesh, t)
            self.assertIn('unmet', self.window.text('#tip h2'))

    # --- the view ---

    def test_wheel_keys_buttons_and_the_mouse_move_the_view(self):
        mesh = self.mesh('island.geojson', '--project', 'none', '--max-edge', '0.6')
        self.window.open(mesh.page)
        first = Screen(self.window)

        def check_scale(before, factor):
            now = Screen(self.window)
            self.assertAlmostEqual(before.scale[0] / now.scale[0], factor, delta=0.01 * factor)
            self.assertAlmostEqual(-now.scale[1] / now.scale[0], 1, delta=0.01)
            return now
        place = mesh.centroid(mesh.widest(1)[0])
        x, y = first.at(place)
        self.window.wheel(x, y, -400)
        now = check_scale(first, math.exp(0.6))
        for a, b in zip(now.at(place), (x, y)):
            self.assertAlmostEqual(a, b, delta=1)
        self.window.key('+')
        now = check_scale(now, 1.5)
        self.window.click('#zoom-out')
        now = check_scale(now, 1 / 1.5)
        x, y = now.at(place)
        self.window.drag((500, 400), (380, 470))
        moved = check_scale(now, 1)
        for a, b in zip(moved.at(place), (x - 120, y + 70)):
            self.assertAlmostEqual(a, b, delta=1)
        self.window.key('ArrowLeft')
        now = Screen(self.window)
        for a, b in zip(now.at(place), (x - 40, y + 70)):
            self.assertAlmostEqual(a, b, delta=1)
        inside = [t for t in self.large_triangles(mesh, now, 400)
                  if all(120 < c < 700 for c in now.at(mesh.centroid(t)))]
        self.assertGreater(len(inside), 5)
        self.check_colors(mesh, now, angle_color(mesh), inside)
        for fit in (lambda: self.window.key('0'), lambda: self.window.click('#fit')):
            self.window.key('-')
            fit()
            now = check_scale(first, 1)
            for a, b in zip(now.at(place), first.at(place)):
                self.assertAlmostEqual(a, b, delta=1)

    def test_fingers_on_a_narrow_screen(self):
        mesh = self.mesh('island.geojson', '--project', 'none')
        self.window.open(mesh.page, size=(400, 700), is_mobile=True)
        self.assertIsNone(self.window.text('#legend'))  # the panel is closed
        screen = Screen(self.window, ((60, 250), (340, 600)))
        t = mesh.widest(1)[0]
        x, y = screen.at(mesh.centroid(t))
        self.window.touch('Start', (x, y))
        self.window.touch('End')
        self.check_tip(mesh, t)
        self.window.touch('Start', (150, 300), (250, 300))
        for reach in (60, 75, 100):
            self.window.touch('Move', (200 - reach, 300), (200 + reach, 300))
        self.window.touch('End')
        now = Screen(self.window, ((60, 250), (340, 600)))
        self.assertAlmostEqual(screen.scale[0] / now.scale[0], 2, delta=0.05)
        for a, b in zip(now.at([o + s * c for o, s, c in zip(screen.origin, screen.scale, (200, 300))]), (200, 300)):
            self.assertAlmostEqual(a, b, delta=3)

    def test_coordinates_of_any_size_and_nearness(self):
        cases = [('hard_points_2e-58_apart.xy', '--mode', 'points'), ('unit_quad_at_3e6.poly',)]
        for side in ('1e300', '1e-302'):
            path = os.path.join(self.folder, side + '.poly')
            with open(path, 'w', encoding='ascii') as file:
                file.write(f'4 2 0 0\n1 0 0\n2 {side} 0\n3 {side} {side}\n4 0 {side}\n'
                           '4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n')  # numbered from 1
            cases.append((path,))
        for name, *arguments in cases:
            with self.subTest(name):
                mesh = self.mesh(name, *arguments)
                self.window.open(mesh.page)
                self.window.click('#counts button')
                number, _, vertices = self.tip()
                told = {int(digits(v)) - mesh.first: (float(x), float(y)) for v, x, y in vertices}
                self.assertEqual(told, {v: mesh.points[v] for v in mesh.triangles[number - mesh.first]})

    # --- by WebGL ---

    def test_webgl_draws_the_same(self):
        mesh = self.mesh('island.geojson', '--project', 'none', '--show-quadtree', '--color', 'angle')
        self.window.open(mesh.page, '#canvas')
        self.assertEqual(self.window.evaluate('document.documentElement.dataset.renderer'), 'canvas')
        by_page = self.window.picture()
        self.window.open(mesh.page, '#webgl')
        self.assertEqual(self.window.evaluate('document.documentElement.dataset.renderer'), 'webgl')
        by_card = self.window.picture()
        self.window.key('q')
        screen = Screen(self.window)
        self.check_colors(mesh, screen, angle_color(mesh), self.large_triangles(mesh, screen))
        differences = [distance(a, b) for a, b in zip(by_page.getdata(), by_card.getdata())]
        self.assertLess(sum(d > 48 for d in differences) / len(differences), 0.002)

    def test_webgl_shows_the_smallest_things(self):
        """Twelve orders of magnitude below the extent, floats are renewed around what is shown."""
        mesh = self.mesh('hard_near_pair_2e-40.poly')
        self.window.open(mesh.page, '#webgl')
        t = min(range(len(mesh.triangles)), key=lambda t: mesh.sides(t)[2])
        x0, x1 = (f(p[0] for p in mesh.points) for f in (min, max))
        self.assertLess(mesh.sides(t)[2] / (x1 - x0), 1e-11)
        screen = Screen(self.window)
        for _ in range(40):
            if screen.pixels(mesh.inner_radius(t)) > 30:
                break
            x, y = (round(c) for c in screen.at(mesh.centroid(t)))
            self.window.wheel(x, y, -1000)
            screen = Screen(self.window)
        x, y = screen.at(mesh.centroid(t))
        self.window.move(x, y)
        self.check_tip(mesh, t)
        self.check_colors(mesh, screen, angle_color(mesh), [t])

    # --- a million ---

    def test_many_triangles(self):
        is_full = 'QUADTREE_MESH_FULL_TESTS' in os.environ
        mesh = self.mesh('gshhg_norway_f.poly.gz', '--max-edge', '700') if is_full else self.mesh(UNITED_STATES)
        seconds = self.window.open(mesh.page)
        print(f'{len(mesh.triangles)} triangles, {os.path.getsize(mesh.page)} bytes: {seconds:.1f} s', end=' ... ')
        self.assertEqual(digits(self.window.text('#counts').split('triangles')[0]), str(len(mesh.triangles)))
        screen = Screen(self.window)
        t = mesh.widest(1)[0]
        x, y = screen.at(mesh.centroid(t))
        for _ in range(30):
            if screen.pixels(mesh.inner_radius(t)) > 8:
                break
            self.window.wheel(x, y, -1000)
            screen = Screen(self.window)
            x, y = screen.at(mesh.centroid(t))
        self.window.move(x, y)
        self.check_tip(mesh, t)
        self.check_colors(mesh, screen, angle_color(mesh), [t])


if __name__ == '__main__':
    unittest.main()
