"""Makes docs/motion.gif, the page of a run as it plays, by Chromium."""

from __future__ import annotations

import io
import sys
import tempfile
from pathlib import Path

import linkwork as lw
import numpy as np
from PIL import Image

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tests/python"))

#: Pixels of the page and of the picture, pictures, and milliseconds for each.
PAGE, SIZE, FRAMES, EACH = (1000, 520), (840, 437), 60, 50

#: Colors of a GIF.
COLORS = 256


def main() -> None:
    from chromium import browser

    period = 2 * np.pi / 3
    result = lw.simulate(lw.mechanisms.stewart_platform(), t_end=period, step=1e-3, on_inaccurate="pass")
    with tempfile.TemporaryDirectory() as folder, browser(Path(folder)) as tab:
        page = Path(folder) / "page.html"
        result.view(page)
        tab.open(page, *PAGE)
        tab.evaluate("linkwork.panels[0].choose('force', 'foot 1')")
        tab.evaluate("linkwork.panels[1].choose('coordinate', 'guide 1')")
        pictures = []
        for time in period * np.arange(FRAMES) / FRAMES:
            tab.evaluate(f"linkwork.player.seek({float(time)!r})")
            pictures.append(
                Image.open(io.BytesIO(tab.screenshot())).convert("RGB").resize(SIZE, Image.Resampling.LANCZOS)
            )
    save(pictures, ROOT / "docs/motion.gif")


def save(pictures: list[Image.Image], path: Path) -> None:
    """With the same colors in all pictures, of which only what changes is stored."""
    sample = pictures[len(pictures) // 3]
    vivid = Image.fromarray(_vivid(np.asarray(sample)))
    palette = vivid.quantize(COLORS)
    frames = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=EACH, loop=0, optimize=True)
    print(f"{path}: {path.stat().st_size / 1e6:.2f} MB")


def _vivid(picture: np.ndarray) -> np.ndarray:
    """Its pixels of strong colors many times, the others once: or shades of gray take all of the palette."""
    pixels = picture.reshape(-1, 3)
    strong = np.ptp(pixels.astype(int), axis=1) > 40
    many = np.concatenate([pixels, *12 * [pixels[strong]]])
    return many[: len(many) // 100 * 100].reshape(-1, 100, 3)


if __name__ == "__main__":
    main()
