// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/setup_id.h"
#include "core/document/database.h"

#include <optional>
#include <string>

namespace burin {

/// Identifies the states of a file and its working copy, and which of them is newer. Table `document`, one row.
struct DocumentState {
    /// Random name of the save on which this content is based; empty: never saved.
    std::string saveId;
    /// In a working copy while a save is in progress: the name that the file will have. Otherwise empty.
    std::string nextSaveId;
    std::int64_t revision = 0;     ///< saves so far, for display
    std::int64_t changes = 0;      ///< transactions since the project was created
    std::int64_t savedChanges = 0; ///< the value of `changes` that the file holds
    /// `contentDigest` of a saved file; empty: not checked.
    std::optional<std::int64_t> digest;

    bool unsaved() const noexcept { return changes != savedChanges; }
};

/// Errors: fileDamaged.
Result<DocumentState> documentState(Database& database);
Result<void> setDocumentState(Database& database, const DocumentState& state);
/// Must be part of every transaction that changes the project.
Result<void> countChange(Database& database);

/// 16 random bytes.
std::string newSaveId();

/// Returns a value that changes with any bit of any table's content, except `document`. SQLite itself stores no
/// checksums, so that a flipped bit could go unnoticed in a number.
Result<std::int64_t> contentDigest(Database& database);

/// The same for only part and materials, and for a setup with its fixtures and limits, its machine's travel, recordings
/// and paths, which a program is made of and checked against. Tools are excluded, as a project may hold some that no
/// recording uses.
Result<std::int64_t> jobDigest(Database& database, SetupId setup);

} // namespace burin
