// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/setup_id.h"
#include "core/document/database.h"

#include <optional>
#include <string>

namespace burin {

/// What tells a file and its working copy apart, and which of them knows more. Table `document`, one row.
struct DocumentState {
    /// Random name of the save that this content stands on; empty: never saved.
    std::string saveId;
    /// In a working copy while a save is under way: the name that the file will have. Empty otherwise.
    std::string nextSaveId;
    std::int64_t revision = 0;     ///< saves so far, for people
    std::int64_t changes = 0;      ///< transactions since the project was made
    std::int64_t savedChanges = 0; ///< of which the file holds so many
    /// `contentDigest` of a saved file; nothing: not checked.
    std::optional<std::int64_t> digest;

    bool unsaved() const noexcept { return changes != savedChanges; }
};

/// Errors: fileDamaged.
Result<DocumentState> documentState(Database& database);
Result<void> setDocumentState(Database& database, const DocumentState& state);
/// To be part of every transaction that changes the project.
Result<void> countChange(Database& database);

/// 16 random bytes.
std::string newSaveId();

/// A value that changes with any bit of any table's content, apart from `document`. SQLite itself has no checksums in
/// a file at rest, so that a flipped bit could pass for a number.
Result<std::int64_t> contentDigest(Database& database);

/// The same of part and materials, and of a setup with what stands around its stock, its machine's travel, recordings
/// and paths alone, which a program is made of and judged by. Tools are not in it: a project holds some that no
/// recording uses.
Result<std::int64_t> jobDigest(Database& database, SetupId setup);

} // namespace burin
