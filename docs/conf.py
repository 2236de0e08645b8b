# The documentation as one site: `make docs` builds it without a warning, or fails.
project = "snug"
author = "The snug authors"
html_title = "snug"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
html_theme = "furo"
html_static_path = []
html_extra_path = ["../build/docs/reference"]  # the C++ reference, by Doxygen
exclude_patterns = ["pictures/*.md"]
myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_typehints = "description"
# Links into the repository, which is not part of the site.
suppress_warnings = ["myst.xref_missing"]
