"""For sphinx-gallery: the pictures of a script are the PNG files that it writes."""

from pathlib import Path
from typing import Any

from sphinx_gallery.scrapers import figure_rst


def scraper(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
    """Move the pictures that a script has written into its page."""
    written, names = Path(block_vars["src_file"]).parent, []
    for picture, name in zip(sorted(written.glob("*.png")), block_vars["image_path_iterator"], strict=False):
        picture.replace(name)
        names.append(name)
    return figure_rst(names, gallery_conf["src_dir"])


def _get_sg_image_scraper() -> Any:
    return scraper
