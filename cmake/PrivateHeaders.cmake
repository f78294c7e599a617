# SPDX-License-Identifier: GPL-3.0-or-later
# Headers that show a package (Simbody, CGAL, json, ...). They serve the sources of their own folder, are not installed, and no
# public header includes them: tests/check_layering.cmake keeps it so. A regular expression of paths from the repository's root.
set(private_headers
  "^(reference/(rigid/)?simbody_[a-z_]+|cases/geometry/cgal_[a-z_]+|cases/input/(json_input|scene/toml_section|trace/json_readers|mesh/gltf_document)|reports/(cli/option_checks|data/stored_json)|realtime/c_support|compare/(peers/[a-z_]+|engine/stepped))\\.hpp$")
