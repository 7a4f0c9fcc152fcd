"""How the documentation is built: `./dev docs`. Nothing comes from a network, while it is built or read."""

from __future__ import annotations

import sys
from importlib import resources
from pathlib import Path

from sphinx.application import Sphinx

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_ext"))

import linkwork  # noqa: E402
from gallery import ORDER, Shown  # noqa: E402

project = "linkwork"
author = copyright = "the linkwork developers"
version = release = linkwork.__version__

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx_gallery.gen_gallery",
    "sphinx_design",
    "sphinx_copybutton",
    "myst_parser",
    "house_docstrings",
    "executed",
    "gallery",
    "reference",
    "included",
    "validation",
]
exclude_patterns = ["examples/**", "_ext/**", "README.md"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
show_warning_types = True
smartquotes_action = "D"  # dashes; quotes stay as they are, as in code

# --- Markdown and mathematics ---
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist", "attrs_inline"]
myst_heading_anchors = 3
myst_dmath_double_inline = True
mathjax_path = "mathjax.js"  # put there by `setup` from the package that brings it
mathjax3_config = {"tex": {"macros": {"T": r"^{\mathsf T}", "d": r"\dot", "b": [r"\boldsymbol{#1}", 1]}},
                   "options": {"enableMenu": False}}  # fmt: skip

# --- the reference ---
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_type_aliases = {  # told in words by reference/index.md
    name: name
    for name in (
        "ArrayLike",
        "BodiesLike",
        "BodyLike",
        "Entry",
        "Floats",
        "Number",
        "VectorLike",
        "Frames",
        "Indices",
        "Named",
        "NDArray",
        "ProgressOption",
        "PythonStep",
        "ShapesLike",
        "ShowOption",
        "TimeFunctionLike",
    )
}
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
add_module_names = False
toc_object_entries_show_parents = "hide"
nitpick_ignore_regex = [
    # of other packages, whose documentation is elsewhere, and what only types are called
    (
        r"py:.*",
        r"(numpy|np|collections|concurrent|contextlib|typing|os|pathlib|matplotlib|pandas|xarray|ctypes|scipy)\b.*",
    ),
    (
        r"py:.*",
        r"(Any|ArrayLike|Callable|Iterable|Iterator|Mapping|Sequence|NDArray|Path|Figure|Literal|Unpack)",
    ),
    (r"py:.*", r"(Cases|Floats|Indices|NoReturn|Number|Real|Runner|Sparse|VectorLike|optional)"),
    (
        r"py:.*",
        r"linkwork\.(_core|arrays|cli|plots|analyses\.equations|motion\.header|importers\.building|accuracy\.measures|comparison\.runs\.Curves)\b.*",
    ),
    (
        r"py:.*",
        r"(linkwork\.options\.types\.)?Options|Integrator|IntegratorName|PythonStep|Named"
        r"|(linkwork\.modeling\.handles\.)?Handle|(linkwork\.motion\.records\.)?(Checkpoint|Resume)|StoredCheckpoint|StateNames|abc\.ABC"
        r"|linkwork\.(constraints\.equations\.Equations|functions\.calls\.Calls|view\.local_server\.Answer)",
    ),
    (
        r"py:.*",
        r"(linkwork\.[\w.]*\.)?_?([A-Z]\w*)?(Like|Option|Methods|Builder|Entry|Policy|Frame|Frames|Level|Header)",
    ),
]

# --- the gallery ---
suppress_warnings = ["config.cache"]  # the gallery's order and pictures are objects
sphinx_gallery_conf = {
    "examples_dirs": "examples",
    "gallery_dirs": "gallery",
    "filename_pattern": r"/\w+\.py",
    "ignore_pattern": r"__init__\.py",
    "subsection_order": ORDER,
    "within_subsection_order": "FileNameSortKey",
    "image_scrapers": (Shown(),),
    "capture_repr": (),
    "reset_modules": (),
    "remove_config_comments": True,
    "download_all_examples": False,
    "thumbnail_size": (400, 280),
    "show_signature": False,
    "show_memory": False,
    "write_computation_times": False,
    "min_reported_time": 1e9,
    "plot_gallery": "True",
    "abort_on_example_error": False,
    "only_warn_on_example_error": False,
    "copyfile_regex": r".*\.(urdf|yaml)",
    "nested_sections": True,
}

# --- pages ---
html_theme = "pydata_sphinx_theme"
html_title = "linkwork"
html_static_path = ["_static"]
html_css_files = ["linkwork.css"]
html_show_sourcelink = False
html_copy_source = False
html_show_search_summary = False  # it would be fetched, which pages on a disk may not
html_last_updated_fmt = None
html_theme_options = {
    "logo": {"text": "linkwork"},
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "show_prev_next": True,
    "show_toc_level": 2,
    "navigation_depth": 3,
    "footer_start": ["copyright"],
    "footer_end": [],
    "secondary_sidebar_items": ["page-toc"],
    "pygments_light_style": "tango",
    "pygments_dark_style": "github-dark",
    "back_to_top_button": True,
    "header_links_before_dropdown": 7,
}
html_sidebars = {"index": [], "validation/**": [], "gallery/index": []}
html_context = {"default_mode": "auto"}


def _mathjax(app: Sphinx) -> None:
    """One file: MathJax with its letters as outlines."""
    bundled = resources.files("mathjax").joinpath("static", "mathjax", "es5", "tex-svg-full.js")
    target = Path(app.outdir) / "_static"
    target.mkdir(parents=True, exist_ok=True)
    (target / "mathjax.js").write_bytes(bundled.read_bytes())


def setup(app: Sphinx) -> None:
    app.connect("builder-inited", _mathjax)
