// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/document_state.h"
#include "core/document/opening.h"
#include "core/document/project.h"
#include "core/document/project_step.h"
#include "core/document/working_copy.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace burin {

/// The data of an open project. The connection is closed before the working copy is destroyed.
class Project::Impl {
public:
    Impl(std::filesystem::path userFile, OpenedCopy opened)
        : file(std::move(userFile))
        , copy(std::move(opened.copy))
        , lock(std::move(opened.lock))
        , database(std::move(opened.database))
        , recovered(opened.recovered)
        , keptAside(std::move(opened.keptAside)) {}
    /// If the note of a save in the working copy failed, for example because the disk was full by then, the file is
    /// saved all the same, so the copy is abandoned.
    ~Impl() {
        if (!copy || copy.use_count() > 1 || !savedChanges) return;
        if (const Result<DocumentState> state = documentState(database); state && state->changes == *savedChanges)
            copy->abandon();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// Runs `work` as one transaction that counts as a change.
    template <class Work>
    auto change(Work work) -> decltype(work(std::declval<Database&>())) {
        Result<Transaction> whole = Transaction::begin(database, Transaction::Kind::write);
        if (!whole) return std::move(whole).error();
        auto result = work(database);
        if (!result) return result;
        if (Result<void> counted = countChange(database); !counted) return std::move(counted).error();
        if (Result<void> committed = whole->commit(); !committed) return std::move(committed).error();
        return result;
    }
    /// Runs `work` as one transaction that does not count as a change to be saved.
    template <class Work>
    auto note(Work work) -> decltype(work(std::declval<Database&>())) {
        Result<Transaction> whole = Transaction::begin(database, Transaction::Kind::write);
        if (!whole) return std::move(whole).error();
        auto result = work(database);
        if (!result) return result;
        if (Result<void> committed = whole->commit(); !committed) return std::move(committed).error();
        return result;
    }
    /// Runs `work` on one consistent state of the project, even while a recorder writes.
    template <class Work>
    auto read(Work work) -> decltype(work(std::declval<Database&>())) {
        Result<Transaction> whole = Transaction::begin(database, Transaction::Kind::read);
        if (!whole) return std::move(whole).error();
        return work(database);
    }

    /// Returns the setup that `id` denotes.
    SetupId meant(SetupId id) const noexcept { return id == setupInUse ? used : id; }

    std::filesystem::path file;
    SetupId used = firstSetup;
    std::shared_ptr<WorkingCopy> copy; ///< null: open for reading only
    std::shared_ptr<WorkingCopy> lock; ///< of a project that is open for reading only, if it could be locked
    Database database;
    std::optional<StepRecorder> step; ///< under way; ends before the connection
    bool recovered = false;
    std::optional<std::int64_t> savedChanges; ///< `changes` of the file after the last save by this object
    std::filesystem::path keptAside;
    std::filesystem::path keptEarlier; ///< set by the last save
};

} // namespace burin
