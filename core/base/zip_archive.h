// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The content of the file in a ZIP archive in memory whose name has this ending, case-insensitive; empty if there is
/// none, the archive is damaged, or the file is larger. @param most bytes: the only limit for the size of unpacked
/// data, unless the process has a memory limit of its own, like the import program
std::optional<std::string> unzippedFile(std::string_view archive, std::string_view ending,
                                        std::size_t most = std::numeric_limits<std::size_t>::max());
/// Whether the content is a ZIP archive that lists such a file.
bool isArchiveWith(std::string_view content, std::string_view ending);
/// An archive of one file; empty if there is not enough memory for it.
std::optional<std::string> zippedFile(const std::string& name, std::string_view content);

} // namespace burin
