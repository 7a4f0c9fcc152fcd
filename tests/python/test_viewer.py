"""The viewer in a browser: what it shows is what was recorded. Skipped where there is no Chromium."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from pathlib import Path

import chromium
import linkwork as lw
import numpy as np
import pytest
from linkwork.motion.records import rotate
from linkwork.view import view
from linkwork.view.page import Page
from PIL import Image

pytestmark = pytest.mark.skipif(chromium.EXECUTABLE is None, reason="no Chromium: apt-get install chromium")

WIDTH, HEIGHT = 1280, 800


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[chromium.Page]:
    with chromium.browser(tmp_path_factory.mktemp("profile")) as page:
        yield page


@pytest.fixture(scope="module")
def three_balls() -> lw.Result:
    """Bodies thrown apart, each a small ball of its own color; spinning, so that orientations count too."""
    model = lw.Model(gravity=(0, 0, -9.81), name="three balls")
    for name, color, start, velocity in (
        ("red", "#ff0000", (-1, 0, 0), (0, 0.3, 5)),
        ("green", "#00ff00", (0, 1, 0.5), (0.4, 0, 5)),
        ("blue", "#0000ff", (1, 0, 1), (0.2, -0.5, 5)),
    ):
        body = model.body(
            name, mass=1.0, inertia=(0.1, 0.1, 0.1), position=start, velocity=velocity, omega=(1, 2, 0)
        )
        body.shape(lw.Sphere(0.05, position=(0.3, 0, 0), color=color))
    return lw.simulate(model, t_end=1.0, step=1e-2)


@pytest.fixture(scope="module")
def slider_crank() -> lw.Result:
    return lw.simulate(lw.mechanisms.spatial_slider_crank(), t_end=1.0, step=1e-3)


def opened(tab: chromium.Page, page: Page, folder: Path) -> None:
    tab.requests.clear()
    tab.complaints.clear()
    page.save(folder / "page.html")
    tab.open(folder / "page.html", WIDTH, HEIGHT)


def picture(tab: chromium.Page) -> np.ndarray:
    """Red, green, blue (height, width, 3) of the page as it is seen, in -255 .. 255."""
    return np.asarray(Image.open(io.BytesIO(tab.screenshot())).convert("RGB")).astype(int)


def center_of(seen: np.ndarray, color: int) -> np.ndarray:
    """Where a pure color is seen, in pixels (x, y)."""
    others = np.delete(seen, color, axis=2).max(axis=2)
    rows, columns = np.nonzero(seen[..., color] - others > 60)
    assert len(rows) > 20
    return np.array([columns.mean(), rows.mean()])


def canvas(tab: chromium.Page) -> np.ndarray:
    """Left, top, right and bottom of the canvas in pixels of the page."""
    box = tab.evaluate(
        "(() => { const b = document.querySelector('.canvas').getBoundingClientRect();"
        " return [b.left, b.top, b.right, b.bottom] })()"
    )
    return np.round(box).astype(int)


def test_page_opens_without_requests_or_complaints(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    tab.screenshot()
    assert tab.requests == [(tmp_path / "page.html").as_uri()]
    assert tab.complaints == []


def test_bodies_are_seen_where_the_result_says(
    tab: chromium.Page, three_balls: lw.Result, tmp_path: Path
) -> None:
    """Pixels of three colors, at three times, against positions projected by the page's camera."""
    opened(tab, three_balls.view(), tmp_path)
    tab.evaluate("document.querySelector('.overlay').hidden = true")  # its axes are colored, too
    tab.evaluate("Object.assign(linkwork.world.shown, { paths: false, grid: false }).paths")
    for frame in (0, 37, 100):
        tab.evaluate(f"linkwork.player.seek({float(three_balls.t[frame])!r})")
        left, top, right, bottom = canvas(tab)
        seen = picture(tab)[top:bottom, left:right]
        for color, name in enumerate(("red", "green", "blue")):
            body = three_balls.body(name)
            ball = body.position[frame] + rotate(body.orientation[frame], np.array([0.3, 0, 0]))
            expected = tab.evaluate(f"linkwork.world.projected({', '.join(map(repr, map(float, ball)))})")
            apart = center_of(seen, color) - expected
            assert np.abs(apart).max() < 3, (frame, name, apart)


def test_camera_projects_as_a_pinhole(tab: chromium.Page, three_balls: lw.Result, tmp_path: Path) -> None:
    """The projection that the other test relies on, against one computed from the camera's place."""
    opened(tab, three_balls.view(), tmp_path)
    numbers = tab.evaluate(
        "(() => { const w = linkwork.world, c = w.camera, e = w.renderer.domElement;"
        " return [c.position.toArray(), w.controls.target.toArray(), c.up.toArray(),"
        " [c.fov, e.clientWidth, e.clientHeight]] })()"
    )
    eye, target, up = (np.array(vector) for vector in numbers[:3])
    fov, width, height = numbers[3]
    ahead = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(ahead, up) / np.linalg.norm(np.cross(ahead, up))
    np.testing.assert_allclose(up, [0, 0, 1])  # against gravity
    for point in np.random.default_rng(1).uniform(-0.5, 0.5, (5, 3)):
        depth = (point - eye) @ ahead
        scale = height / 2 / np.tan(np.radians(fov) / 2) / depth
        across = np.array([(point - eye) @ right, -(point - eye) @ np.cross(right, ahead)])
        expected = np.array([width, height]) / 2 + scale * across
        found = tab.evaluate(f"linkwork.world.projected({', '.join(map(repr, map(float, point)))})")
        np.testing.assert_allclose(found, expected, atol=0.01)


def test_poses_between_frames_are_on_the_way(
    tab: chromium.Page, three_balls: lw.Result, tmp_path: Path
) -> None:
    opened(tab, three_balls.view(), tmp_path)
    middle = float(three_balls.t[10:12].mean())
    tab.evaluate(f"linkwork.player.seek({middle!r})")
    pose = np.array(tab.evaluate("Array.from(linkwork.runs[0].pose)"))[:21].reshape(3, 7)
    np.testing.assert_allclose(pose[:, :3], three_balls.position[10:12].mean(axis=0), atol=1e-4)
    np.testing.assert_allclose(np.linalg.norm(pose[:, 3:], axis=1), 1, atol=1e-6)


def test_slider_moves_the_bodies(tab: chromium.Page, three_balls: lw.Result, tmp_path: Path) -> None:
    opened(tab, three_balls.view(), tmp_path)
    x0, y0, x1 = tab.evaluate(
        "(() => { const b = document.querySelector('.slider').getBoundingClientRect();"
        " return [b.left, b.top + b.height / 2, b.right] })()"
    )
    tab.click((x0 + x1) / 2, y0)
    time, z = tab.evaluate("[linkwork.player.time, linkwork.runs[0].pose[2]]")
    assert time == pytest.approx(0.5, abs=0.01)
    assert z == pytest.approx(5 * time - 9.81 / 2 * time**2, abs=1e-2)


def test_click_in_a_plot_seeks(tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    left, right, y = tab.evaluate(
        "(() => { const b = linkwork.panels[0].plot.over.getBoundingClientRect();"
        " return [b.left, b.right, b.top + 30] })()"
    )
    tab.click(left + 0.25 * (right - left), y)
    assert tab.evaluate("linkwork.player.time") == pytest.approx(0.25, abs=0.005)
    mark = tab.evaluate("linkwork.panels.map((it) => it.mark.getBoundingClientRect().left)")
    assert mark == pytest.approx([left + 0.25 * (right - left)] * len(mark), abs=2)


def test_keys_step_play_and_jump(tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    tab.press("ArrowRight", 39)
    assert tab.evaluate("linkwork.player.time") == pytest.approx(slider_crank.t[1])
    tab.press("End", 35)
    assert tab.evaluate("linkwork.player.time") == pytest.approx(slider_crank.t[-1])
    tab.press("ArrowLeft", 37)
    assert tab.evaluate("linkwork.player.time") == pytest.approx(slider_crank.t[-2])
    tab.press("Home", 36)
    tab.press(" ", 32, " ")
    tab.wait_for("linkwork.player.time > 0.05")
    tab.press(" ", 32, " ")
    assert tab.evaluate("linkwork.player.playing") is False


@pytest.mark.parametrize("quantity", ["velocity", "force", "energy", "violation", "position"])
def test_plotted_numbers_are_those_of_the_result(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path, quantity: str
) -> None:
    name = {"force": slider_crank.joint_names[1], "velocity": "coupler", "position": "coupler"}.get(quantity)
    expected = {
        "velocity": lambda: slider_crank.body("coupler").velocity,
        "position": lambda: slider_crank.body("coupler").position,
        "force": lambda: slider_crank.reaction(1).force,
        "energy": lambda: np.stack([slider_crank.kinetic_energy, slider_crank.potential_energy], axis=1),
        "violation": lambda: slider_crank.violation,
    }[quantity]()
    opened(tab, slider_crank.view(), tmp_path)
    asked = f"{{id: {json.dumps(quantity)}}}, {json.dumps(name)}"
    lines = tab.evaluate(f"linkwork.runs[0].lines({asked}).map((it) => Array.from(it[1]))")
    assert len(lines) >= expected.shape[1]
    for line, channel in zip(lines, expected.T, strict=False):
        step = (
            np.ptp(channel) / 2**17 if quantity == "position" else 0.0
        )  # poses have 16 bits, series 7 digits
        np.testing.assert_allclose(line, channel, rtol=1e-6, atol=step + 2e-7 * np.abs(channel).max())


def test_second_run_is_seen_beside_the_first(tab: chromium.Page, tmp_path: Path) -> None:
    """Where the runs differ the second appears in its own color, and goes when it is switched off."""
    model = lw.mechanisms.four_bar()
    core = model.compiled()
    fast, slow = (
        lw.simulate(model.with_initial_state(core.q0, factor * core.v0), t_end=1.0, step=1e-3)
        for factor in (1.0, 0.3)
    )
    opened(tab, view([fast, slow], ["fast", "slow"]), tmp_path)
    tab.evaluate(
        "(() => { Object.assign(linkwork.world.shown, { paths: false, grid: false });"
        " linkwork.player.seek(0.6) })()"
    )

    def ghostly() -> int:
        """Reddish pixels of the canvas: the second run's color on the light ground."""
        seen = picture(tab)[60:750, :860]
        return int(np.sum((seen[..., 0] - seen[..., 1] > 60) & (seen[..., 0] - seen[..., 2] > 25)
                          & (np.abs(seen[..., 1] - seen[..., 2]) < 60)))  # fmt: skip

    with_second = ghostly()
    tab.evaluate("document.querySelector('input[data-show=second]').click()")
    assert with_second - ghostly() > 500
    dashed = "linkwork.panels[0].plot.series.filter((it) => it.dash).length"
    assert tab.evaluate(dashed) == 0
    tab.evaluate("document.querySelector('input[data-show=second]').click()")
    assert tab.evaluate(dashed) >= 3


def test_reactions_that_are_not_unique_are_marked(tab: chromium.Page, tmp_path: Path) -> None:
    result = lw.simulate(lw.mechanisms.four_bar(), t_end=0.1, step=1e-3)
    assert not result.unique_reactions.any()
    opened(tab, result.view(), tmp_path)
    tab.evaluate("linkwork.panels[0].choose('force', 'pin 0')")
    assert "not unique" in tab.evaluate("linkwork.panels[0].element.querySelector('.legend').textContent")


def test_narrow_window_puts_plots_below_and_nothing_overflows(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    tab.resize(390, 800)
    tab.drawn()
    scene, plots, page = tab.evaluate(
        "[document.querySelector('.scene').getBoundingClientRect().bottom,"
        " document.querySelector('.side').getBoundingClientRect().top, document.documentElement.scrollWidth]"
    )
    assert plots >= scene
    assert page == 390


def test_names_are_text_and_never_markup(tab: chromium.Page, tmp_path: Path) -> None:
    name = '</script><img src=x onerror="window.broken = 1">'
    model = lw.Model(name=name)
    model.body(name, mass=1.0, inertia=(1, 1, 1))
    opened(tab, lw.simulate(model, t_end=0.1, step=0.01).view(), tmp_path)
    assert tab.evaluate("document.querySelector('h1').textContent") == name
    assert tab.evaluate("window.broken") is None
    assert tab.evaluate("linkwork.runs[0].bodies.names") == [name]


def test_plots_share_the_height_and_follow_the_window(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    heights = "linkwork.panels.map((it) => it.element.getBoundingClientRect().height)"
    for height in (800, 1000, 700, 480):
        tab.resize(WIDTH, height)
        tab.drawn()
        found = tab.evaluate(heights)
        assert len(found) == 3
        assert np.ptp(found) < 1.5
        assert min(found) >= 178
        if height >= 700:
            assert sum(found) < height


def test_meshes_are_drawn_in_their_color(tab: chromium.Page, tmp_path: Path) -> None:
    """A tetrahedron fills a part of the picture, and its center is where the body is."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / 2
    mesh = lw.Mesh(corners, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], color="#00ff00")
    model = lw.Model(gravity=(0, 0, 0))
    model.body("stone", mass=1.0, inertia=(1, 1, 1), velocity=(0, 0.1, 0), shape=mesh)
    opened(tab, lw.simulate(model, t_end=1.0, step=0.1).view(), tmp_path)
    left, top, right, bottom = canvas(tab)
    seen = picture(tab)[top:bottom, left:right]
    expected = tab.evaluate("linkwork.world.projected(0, 0, 0)")
    green = seen[..., 1] - np.maximum(seen[..., 0], seen[..., 2]) > 60
    assert green.mean() > 0.02
    assert green[int(expected[1]), int(expected[0])]
    assert tab.complaints == []


def test_springs_reach_from_point_to_point(tab: chromium.Page, tmp_path: Path) -> None:
    """Ends of the coil in the picture, against the points of the bodies, at three times."""
    model = lw.Model(gravity=(0, 0, -9.81))
    body = model.body("body", mass=1, inertia=(0.1, 0.1, 0.2), position=(0, 0, -1), omega=(3, 1, 2))
    model.spring_damper("ground", body, at=((0.3, 0, 0), (0.1, 0.2, -0.9)), stiffness=50, name="rope")
    result = lw.simulate(model, t_end=1.0, step=1e-2)
    opened(tab, result.view(), tmp_path)
    coil = "linkwork.world.figures[0].parts.find((it) => it.layer === 'force').mesh"
    for frame in (0, 40, 100):
        tab.evaluate(f"linkwork.player.seek({float(result.t[frame])!r})")
        m = np.reshape(tab.evaluate(f"Array.from({coil}.instanceMatrix.array)"), (4, 4)).T
        ends = [m @ (0, 0, z, 1) for z in (-0.5, 0.5)]
        A = lw.rotation.matrix(result.q[frame, 0, 3:])
        expected = result.position[frame, 0] + A @ (0.1, 0.2, 0.1)
        np.testing.assert_allclose(ends[0][:3], (0.3, 0, 0), atol=1e-6)
        np.testing.assert_allclose(ends[1][:3], expected, atol=1e-4)
    tab.evaluate("document.querySelector('input[data-show=forces]').click()")
    assert tab.evaluate(f"{coil}.visible") is False
    assert tab.complaints == []


def test_joint_whose_axes_are_askew_is_colored_by_it(tab: chromium.Page, tmp_path: Path) -> None:
    """1e-3 rad at an arm of 0.5 m counts as 5e-4 m; the legend says so."""
    model = lw.Model(gravity=(0, 0, 0))
    body = model.body("body", mass=1, inertia=(1, 1, 1), position=(0.5, 0, 0))
    model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
    turn = lw.rotation.about((0, 1, 0), 1e-3)
    turned = model.with_initial_state([*(lw.rotation.matrix(turn) @ (0.5, 0, 0)), *turn], np.zeros(6))
    with pytest.warns(lw.LinkworkWarning):
        result = lw.simulate(turned, t_end=1e-2, step=1e-3, stabilization="none", assemble=False)
    opened(tab, result.view(), tmp_path)
    power = tab.evaluate("linkwork.runs[0].violationOf(0)")
    assert 10**power == pytest.approx(5e-4, rel=1e-3)
    tab.evaluate(
        "(() => { const s = document.querySelector('.coloring'); s.value = 'gap';"
        " s.dispatchEvent(new Event('change')) })()"
    )
    assert "angles times 0.5 m" in tab.evaluate("document.querySelector('.gap-key').textContent")
    pin = "linkwork.world.figures[0].parts.find((it) => it.layer === 'joint').mesh.instanceColor.array"
    bright = tab.evaluate(f"Array.from({pin}).slice(0, 3)")
    assert bright[0] > 2 * bright[2]  # yellow to red, not blue
    tab.evaluate("linkwork.panels[0].choose('gap', 'pin')")
    assert "axes askew" in tab.evaluate("linkwork.panels[0].element.querySelector('.legend').textContent")


# --- what lies over the picture, the list of objects, the initial pose -------------------------------------


@pytest.fixture(scope="module")
def broken_door() -> lw.Model:
    model = lw.Model(name="broken door")
    door = model.body("door", mass=1.0, inertia=(1, 1, 1), position=(0.5, 0, 0))
    wheel = model.body("wheel", mass=2.0, inertia=(1, 1, 1), position=(1.5, 0, 0.3))
    model.revolute("ground", door, at=(0, 0, 0), axis=(0, 0, 1), name="hinge")
    points = ((0.5, 0, 0), (-0.5, 0, 0))
    model.revolute(door, wheel, at=points, axis=((0, 0, 1), (0, 0, 1)), frames="body", name="pin")
    return model


def test_initial_pose_shows_what_does_not_hold_and_no_time(
    tab: chromium.Page, broken_door: lw.Model, tmp_path: Path
) -> None:
    opened(tab, broken_door.view(), tmp_path)
    assert tab.evaluate("document.querySelector('.names .loose').textContent") == "pin: 0.3 m apart"
    assert tab.evaluate("document.querySelector('.bar').hidden") is True
    assert tab.evaluate("linkwork.panels.length") == 0
    pins = "linkwork.world.figures[0].parts.find((it) => it.layer === 'joint' && it.index.includes({}))"
    color = f"Array.from({pins}.mesh.instanceColor.array).slice(3 * {pins}.index.indexOf({{}})).slice(0, 3)"
    hinge, pin = (tab.evaluate(color.format(k, k, k)) for k in (0, 1))
    assert pin[0] > 3 * pin[1] and not hinge[0] > 3 * hinge[1]
    assert tab.complaints == []


def test_names_stand_where_their_bodies_are(
    tab: chromium.Page, broken_door: lw.Model, tmp_path: Path
) -> None:
    opened(tab, broken_door.view(), tmp_path)
    for name, position in (("door", (0.5, 0, 0)), ("wheel", (1.5, 0, 0.3))):
        box = tab.evaluate(
            "(() => { const l = [...document.querySelectorAll('.names span')]"
            f".find((it) => it.textContent === '{name}')"
            ".getBoundingClientRect(); return [(l.left + l.right) / 2, (l.top + l.bottom) / 2] })()"
        )
        expected = tab.evaluate(f"linkwork.world.projected({', '.join(map(str, position))})")
        assert np.abs(np.array(box) - canvas(tab)[:2] - expected).max() < 1.5


def test_scale_bar_is_as_long_as_it_says(tab: chromium.Page, broken_door: lw.Model, tmp_path: Path) -> None:
    """Where the camera looks at: a length across the view there."""
    opened(tab, broken_door.view(), tmp_path)
    length = float(tab.evaluate("document.querySelector('.scale span').textContent").removesuffix(" m"))
    pixels = tab.evaluate("document.querySelector('.scale i').getBoundingClientRect().width")
    apart = tab.evaluate(
        "(() => { const w = linkwork.world; const c = w.controls.target;"
        " const r = c.clone().sub(w.camera.position).cross(w.camera.up).normalize().multiplyScalar("
        + str(length)
        + ");"
        " const [a, b] = [w.projected(c.x, c.y, c.z), w.projected(c.x + r.x, c.y + r.y, c.z + r.z)];"
        " return Math.hypot(a[0] - b[0], a[1] - b[1]) })()"
    )
    assert pixels == pytest.approx(apart, rel=0.02)


@pytest.mark.parametrize(("view", "axis", "sign"), [("-y", 1, -1), ("x", 0, 1), ("z", 2, 1)])
def test_views_look_along_the_axes(
    tab: chromium.Page, broken_door: lw.Model, tmp_path: Path, view: str, axis: int, sign: int
) -> None:
    opened(tab, broken_door.view(), tmp_path)
    tab.evaluate(
        f"(() => {{ const s = document.querySelector('.view'); s.value = '{view}';"
        " s.dispatchEvent(new Event('change')) })()"
    )
    from_target = tab.evaluate(
        "linkwork.world.camera.position.clone().sub(linkwork.world.controls.target).normalize().toArray()"
    )
    assert from_target[axis] * sign > 0.9999


def test_what_is_unchecked_is_not_drawn_and_what_is_picked_is_named(
    tab: chromium.Page, three_balls: lw.Result, tmp_path: Path
) -> None:
    opened(tab, three_balls.view(), tmp_path)
    tab.evaluate("document.querySelector('.overlay .triad').style.opacity = 0")
    tab.evaluate("document.querySelector('input[data-show=paths]').click()")
    left, top, right, bottom = canvas(tab)
    center_of(picture(tab)[top:bottom, left:right], 0)
    tab.evaluate("document.querySelector('.objects').open = true; 1")
    tab.evaluate("document.querySelector('.row[data-kind=body] input').click(); 1")  # the first, red
    tab.evaluate(
        "[...document.querySelectorAll('.row .name')].find((it) => it.textContent === 'blue').click(); 1"
    )
    seen = picture(tab)[top:bottom, left:right]
    red = seen[..., 0] - np.delete(seen, 0, axis=2).max(axis=2)
    assert (red > 60).sum() == 0
    assert tab.evaluate("document.querySelector('.names .selected').textContent") == "blue"


def test_objects_are_found_by_name_and_kind(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    tab.evaluate("document.querySelector('.objects').open = true; 1")
    tab.evaluate(
        "(() => { const f = document.querySelector('.filter'); f.value = 'spherical';"
        " f.dispatchEvent(new Event('input')) })()"
    )
    rows = tab.evaluate("[...document.querySelectorAll('.row .name')].map((it) => it.textContent)")
    header = slider_crank.header
    kinds = dict(zip(header.joint_names, header.joint_kinds, strict=True))
    assert rows == [name for name, kind in kinds.items() if kind == "spherical"]


def test_plotted_coordinates_and_accelerations_are_those_of_the_result(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    get = "Array.from(linkwork.runs[0].lines({{ id: '{}' }}, '{}')[{}][1])"
    crank = slider_crank.joint_names[0]
    angle = np.array(tab.evaluate(get.format("coordinate", crank, 0)))
    expected = slider_crank.coordinate(crank)
    assert np.abs(angle - expected.value).max() <= 1e-4 * np.ptp(expected.value)
    rate = np.array(tab.evaluate(get.format("rate", crank, 0)))
    assert np.abs(rate - expected.rate).max() <= 1e-4 * np.ptp(expected.rate)
    name = slider_crank.body_names[-1]
    x = np.array(tab.evaluate(get.format("acceleration", name, 0)))
    assert np.abs(x - slider_crank.body(name).acceleration[:, 0]).max() <= 1e-4 * np.ptp(x)


def test_a_part_of_the_time_is_shown_by_all_plots(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    tab.evaluate("linkwork.panels[0].plot.setScale('x', { min: 0.25, max: 0.5 }); 1")
    tab.drawn()
    parts = tab.evaluate("linkwork.panels.map((it) => [it.plot.scales.x.min, it.plot.scales.x.max])")
    assert parts == [[0.25, 0.5]] * 3


def test_one_tiny_number_does_not_stretch_a_logarithmic_axis(
    tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path
) -> None:
    opened(tab, slider_crank.view(), tmp_path)
    tab.evaluate("linkwork.runs[0].violation[5] = 1e-33; linkwork.panels[1].choose('violation'); 1")
    tab.drawn()
    low, high = tab.evaluate("[linkwork.panels[1].plot.scales.y.min, linkwork.panels[1].plot.scales.y.max]")
    assert low > 1e-25
    assert high >= slider_crank.violation.max()  # and all that is large is seen


def test_roundoff_is_drawn_as_zero(tab: chromium.Page, slider_crank: lw.Result, tmp_path: Path) -> None:
    """The slider moves along x; what is left along z is 1e-19 m and no curve of full height."""
    opened(tab, slider_crank.view(), tmp_path)
    largest = tab.evaluate("linkwork.runs[0].largestOf({ id: 'position' })")
    tab.evaluate("(() => { const { track } = linkwork.runs[0]; track.fill(0); track[2] = 1e-19 })()")
    tab.evaluate("linkwork.panels[2].choose('position'); 1")
    tab.drawn()
    assert tab.evaluate("linkwork.panels[2].plot.scales.y.max") >= 0.9e-9 * largest


def test_screenshot_is_a_picture_of_the_scene(
    tab: chromium.Page, three_balls: lw.Result, tmp_path: Path
) -> None:
    opened(tab, three_balls.view(), tmp_path)
    shot = tab.evaluate(
        "linkwork.world.screenshot().then((it) => it.arrayBuffer())"
        ".then((it) => Array.from(new Uint8Array(it)))"
    )
    seen = np.asarray(Image.open(io.BytesIO(bytes(shot))).convert("RGB")).astype(int)
    left, top, right, bottom = canvas(tab)
    assert seen.shape[:2] == (bottom - top, right - left)
    center_of(seen, 0)


def test_events_that_have_no_mark_are_counted_and_models_named(tab: chromium.Page, tmp_path: Path) -> None:
    model = lw.Model(name="ticking")
    model.body("ball", mass=1.0, inertia=(1, 1, 1))
    sign = lw.Event(lambda t, state: float(np.sin(2 * np.pi * 110 * t)), "passes zero")
    result = lw.simulate(model, t_end=1.0, step=2e-3, rtol=1e-6, events=[sign], progress=False)
    other = lw.simulate(lw.mechanisms.pendulum(), t_end=0.1, step=1e-3, progress=False)
    with pytest.warns(lw.LinkworkWarning, match="different mechanisms"):
        page = result.view(other=other)
    opened(tab, page, tmp_path)
    tab.screenshot()
    said = tab.evaluate("document.querySelector('.left-out').textContent")
    assert f"marks of all events but the last {len(result.events) - 200}" in said
    assert tab.evaluate("document.querySelector('h1').textContent") == "ticking and pendulum"
    assert tab.complaints == []
