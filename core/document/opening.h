// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/working_copy.h"

#include <filesystem>
#include <memory>

namespace burin {

/// A connection to a project's working copy, and how it was opened.
struct OpenedCopy {
    std::shared_ptr<WorkingCopy> copy; ///< null: opened for reading only
    Database database;
    bool recovered = false;
    std::filesystem::path keptAside;
    std::shared_ptr<WorkingCopy> lock = nullptr; ///< of a project opened for reading only, if it could be locked
};

/// @param file absolute, here and below. Errors: as Project::create.
Result<OpenedCopy> createWorkingCopy(const std::filesystem::path& file);
/// Errors: as Project::open.
Result<OpenedCopy> openWorkingCopy(const std::filesystem::path& file);
/// As Project::openForReading.
Result<OpenedCopy> openForReading(const std::filesystem::path& file);
/// Saves the content of `from` as `file` and opens that. Errors: as Project::saveAs.
Result<OpenedCopy> saveUnderAnotherName(Database& from, const std::filesystem::path& file);

} // namespace burin
