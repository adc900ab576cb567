// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin::architecture {

/// Cells of a table's row, without the blanks around them.
using PageRow = std::vector<std::string>;

/// The rows of all tables of a Markdown page whose first column is called `firstHeading`, without the headings and the
/// lines of dashes; empty if there is no such table.
std::vector<PageRow> tableOf(const std::filesystem::path& page, std::string_view firstHeading);

/// The parts of a text that are in backticks, in order.
std::vector<std::string> quotedIn(std::string_view text);

} // namespace burin::architecture
