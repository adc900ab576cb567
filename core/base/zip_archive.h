// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// A file of a ZIP archive in memory whose name ends so, whatever its letters' case; nothing: the archive has none, is
/// damaged, or the file is larger. @param most bytes: what a few packed ones unpack to has no other bound, unless the
/// process has a limit of memory of its own, as the import program has
std::optional<std::string> unzippedFile(std::string_view archive, std::string_view ending,
                                        std::size_t most = std::numeric_limits<std::size_t>::max());
/// Whether the content is a ZIP archive that names such a file.
bool isArchiveWith(std::string_view content, std::string_view ending);
/// An archive of one file; nothing: there is not enough memory for it.
std::optional<std::string> zippedFile(const std::string& name, std::string_view content);

} // namespace burin
