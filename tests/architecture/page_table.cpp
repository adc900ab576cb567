// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/page_table.h"

#include <fstream>
#include <optional>

namespace burin::architecture {

namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

/// Empty for a line that is no row of a table.
std::optional<PageRow> rowOf(std::string_view line) {
    if (!line.starts_with('|')) return std::nullopt;
    line.remove_prefix(1);
    PageRow cells;
    for (std::size_t bar = line.find('|'); bar != std::string_view::npos; bar = line.find('|')) {
        cells.push_back(trimmed(line.substr(0, bar)));
        line.remove_prefix(bar + 1);
    }
    return cells;
}

} // namespace

std::vector<PageRow> tableOf(const std::filesystem::path& page, std::string_view firstHeading) {
    std::vector<PageRow> rows;
    std::ifstream stream(page);
    int read = 0; // lines of a table read so far: its heading, and the dashes below it
    for (std::string line; std::getline(stream, line);) {
        std::optional<PageRow> row = rowOf(line);
        if (!row) {
            read = 0;
        } else if (read > 0 || (!row->empty() && row->front() == firstHeading)) {
            if (++read > 2) rows.push_back(std::move(*row));
        }
    }
    return rows;
}

std::vector<std::string> quotedIn(std::string_view text) {
    std::vector<std::string> quoted;
    for (;;) {
        const std::size_t first = text.find('`');
        const std::size_t end = first == std::string_view::npos ? first : text.find('`', first + 1);
        if (end == std::string_view::npos) return quoted;
        quoted.emplace_back(text.substr(first + 1, end - first - 1));
        text.remove_prefix(end + 1);
    }
}

} // namespace burin::architecture
