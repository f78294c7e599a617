// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handhold::reports {

/// The page without its data: HTML made from reports/page/ when the program is built, or reports/page/plain.html in a
/// build without it (HANDHOLD_PAGE=OFF). Places to fill are comments: <!--handhold:title-->, table, results,
/// recordings.
[[nodiscard]] std::string_view page_frame();

}  // namespace handhold::reports
