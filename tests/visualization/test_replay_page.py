"""The replay in a real browser: from the disk, without a network, by mouse and by keys."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.browser import PHONE, WIDE, chromium, nameless, opened
from worlds.filled import filled
from worlds.recorded import Brief, record

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.visualization.replay_page.page import replay_page

STEPS, PARTING = 24, 9
SMALL = (24, 32)

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Pages:
    """A page of one run, and one of two of which the second stops at `PARTING`."""

    one: Path
    two: Path
    recording: Recording


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as found:
        yield found


@pytest.fixture(scope="module")
def pages(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Pages:
    folder, spec = tmp_path_factory.mktemp("replay"), AgentSpec("uniteam-plus", "truth")
    recordings = []
    for steps in (STEPS, PARTING):
        path = folder / f"{steps}.zip"
        record(path, Brief(spec.make(None), steps), spec)
        recordings.append(read_recording(path))
    for name, shown in (("one", recordings[:1]), ("two", recordings)):
        (folder / f"{name}.html").write_text(replay_page(shown))
    return Pages(folder / "one.html", folder / "two.html", recordings[0])


def step(page: Any) -> int:
    return int(page.inner_text("#step"))


def at(page: Any, number: int) -> None:
    """Wait until a step is shown."""
    page.wait_for_selector(f"#step:text-is('{number}')", timeout=30_000)


def picture(page: Any, name: str, run: int = 0) -> NDArray[np.float64]:
    """Return what a canvas shows, made small."""
    pixels = page.locator(f"[data-picture={name}] canvas").nth(run).evaluate(
        """(canvas, [width, height]) => {
            const small = new OffscreenCanvas(width, height).getContext("2d");
            small.drawImage(canvas, 0, 0, width, height);
            return [...small.getImageData(0, 0, width, height).data];
        }""",
        list(SMALL),
    )  # fmt: skip
    return np.array(pixels, np.float64).reshape(SMALL[1], SMALL[0], 4)[..., :3]


def test_it_opens_from_the_disk_in_two_seconds_without_a_network_or_an_error(browser: Any, pages: Pages) -> None:
    seconds = []
    for file in filled((pages.two, pages.one, pages.two)):
        with opened(browser, file) as tab:
            seconds.append(tab.seconds)
            assert tab.page.inner_text("#task") == str(pages.recording.episode.instruction)
    assert min(seconds) < 2.0  # the least, since others keep the machine busy


def test_each_step_shows_its_own_picture_wherever_one_comes_from(browser: Any, pages: Pages) -> None:
    frames = [cv2.resize(f.rgb, SMALL, interpolation=cv2.INTER_AREA).astype(float) for f in pages.recording.frames()]
    with opened(browser, pages.one) as tab:
        for wanted in filled((11, 4, 5, 24, 3, 20, 0, 12, 6)):
            tab.page.evaluate(f"location.hash = '#step={wanted}'")
            at(tab.page, wanted)
            seen = picture(tab.page, "camera")
            errors = [float(np.abs(seen - frame).mean()) for frame in frames]
            assert errors[wanted] < 8.0
            assert errors[wanted] == min(errors)


def test_the_map_is_the_same_whichever_way_one_comes(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.one) as tab:
        maps = {}
        for number in range(0, STEPS + 1, 6):
            tab.page.evaluate(f"location.hash = '#step={number}'")
            at(tab.page, number)
            maps[number] = picture(tab.page, "map")
        assert np.abs(maps[0] - maps[12]).max() > 30.0
        for number in filled(reversed(maps)):
            tab.page.evaluate(f"location.hash = '#step={number}'")
            at(tab.page, number)
            assert np.array_equal(picture(tab.page, "map"), maps[number])


def test_it_says_what_was_decided_and_why(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.one) as tab:
        for number in filled((0, 7, 23)):
            tab.page.evaluate(f"location.hash = '#step={number}'")
            at(tab.page, number)
            decision = pages.recording.steps[number].decision
            assert tab.page.inner_text(".reason") == decision.reason
            assert tab.page.inner_text(".state").lower() == decision.state.replace("_", " ").lower()
        assert tab.page.inner_text(".news >> nth=0").startswith("0")


def test_the_mouse_scrubs_and_a_line_of_the_story_leads_to_its_step(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.one) as tab:
        box = tab.page.locator("#timeline").bounding_box()
        x, y = box["x"] + 10, box["y"] + 30
        tab.page.mouse.move(x, y)
        tab.page.mouse.down()
        tab.page.mouse.move(x + (box["width"] - 20) * 0.4, y, steps=4)
        at(tab.page, round(0.4 * (STEPS + 1)))
        tab.page.mouse.move(x + box["width"], y, steps=4)
        tab.page.mouse.up()
        at(tab.page, STEPS + 1)
        assert "step" in tab.page.inner_text(".tip")
        tab.page.click(".news >> nth=0")
        at(tab.page, 0)


def test_it_plays_faster_where_that_is_asked_for_and_stops_at_the_end(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.one) as tab:
        tab.page.check("input[value='16']")
        tab.page.click("#play")
        at(tab.page, STEPS + 1)
        assert tab.page.get_attribute("#play", "aria-label") == "Play"
        tab.page.check("input[value='0.5']")
        tab.page.click("#play")
        tab.page.wait_for_timeout(900)
        tab.page.click("#play")
        assert 0 <= step(tab.page) <= 7


def test_keys_alone_do_it_all(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.two) as tab:
        press = tab.page.keyboard.press
        for key, expected in filled(
            (("ArrowRight", 1), ("Shift+ArrowRight", 11), ("ArrowLeft", 10), ("d", PARTING), ("End", STEPS + 1),
             ("p", STEPS), ("Home", 0))
        ):  # fmt: skip
            press(key)
            at(tab.page, expected)
        press("+")
        assert tab.page.is_checked("input[value='2']")
        press(" ")
        assert tab.page.get_attribute("#play", "aria-label") == "Pause"
        press(" ")
        press("t")
        assert tab.page.is_checked("#truth")
        press("4")
        assert tab.page.locator("[data-picture=map]").nth(1).bounding_box()["width"] > 600
        press("Escape")
        assert tab.page.locator("[data-picture=map]").nth(1).bounding_box()["width"] < 300
        press("?")
        assert tab.page.locator("#keys").is_visible()
        press("Escape")
        assert not tab.page.locator("#keys").is_visible()
        visited = set()
        for _ in range(30):
            press("Tab")
            visited.add(tab.page.evaluate("document.activeElement.id || document.activeElement.name"))
        assert {"theme", "help", "parting", "timeline", "play", "speed", "truth"} <= visited


def test_two_runs_stand_side_by_side_and_it_says_where_they_part(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.two) as tab:
        assert f"step {PARTING}" in tab.page.inner_text("#parting")
        tab.page.click("#parting")
        at(tab.page, PARTING)
        assert tab.page.locator(".reason").all_inner_texts()[1] == "Enough."
        assert np.abs(picture(tab.page, "camera", 0) - picture(tab.page, "camera", 1)).max() < 12.0
        tab.page.keyboard.press("End")
        at(tab.page, STEPS + 1)
        assert "the episode is over" in tab.page.locator(".action").all_inner_texts()[1]


@pytest.mark.parametrize("name", ["one", "two"])
@pytest.mark.parametrize("viewport", [WIDE, PHONE], ids=["wide", "phone"])
def test_it_fits_a_laptop_and_a_phone(browser: Any, pages: Pages, name: str, viewport: dict[str, int]) -> None:
    with opened(browser, getattr(pages, name), viewport) as tab:
        assert tab.page.evaluate("document.documentElement.scrollWidth") <= viewport["width"]
        controls = tab.page.locator(".controls").bounding_box()
        assert controls["y"] + controls["height"] <= viewport["height"] + 1
        for figure in filled(tab.page.locator("figure").all()[:4]):
            box = figure.bounding_box()
            assert box["width"] > 120
            assert box["x"] + box["width"] <= viewport["width"]
        if viewport is WIDE:
            last = tab.page.locator("figure").last.bounding_box()
            assert last["y"] + last["height"] < controls["y"]


def test_it_is_light_or_dark_as_the_system_and_then_as_the_switch_says(browser: Any, pages: Pages) -> None:
    def brightness(page: Any) -> float:
        numbers = page.evaluate("getComputedStyle(document.body).backgroundColor").strip("rgb()").split(",")
        return float(np.mean([float(number) for number in numbers]))

    with opened(browser, pages.one, theme="dark") as tab:
        assert brightness(tab.page) < 40.0
        before = picture(tab.page, "map")
        tab.page.click("#theme")
        assert brightness(tab.page) > 215.0
        assert np.abs(picture(tab.page, "map") - before).max() > 60.0
        tab.page.keyboard.press("l")
        assert brightness(tab.page) < 40.0
    with opened(browser, pages.one, theme="light") as tab:
        assert brightness(tab.page) > 215.0


def test_everything_has_a_name_that_can_be_read_aloud(browser: Any, pages: Pages) -> None:
    with opened(browser, pages.two) as tab:
        assert nameless(tab.page) == []
        tab.page.keyboard.press("ArrowRight")
        at(tab.page, 1)
        assert tab.page.get_attribute("#timeline", "aria-valuetext").startswith(f"step 1 of {STEPS + 1}: Look around")
