// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/document/project.h"

#include <memory>
#include <span>

namespace burin {

/// A project that a command changes and saves, all or nothing: unless `save` succeeded, the destructor reverts the
/// changes, and the file stays as it was. Unsaved work of an earlier run is not part of the change: it is saved first.
class ProjectChange {
public:
    /// Errors: as Project::open, Project::save, fileNotWritable (opened for reading only).
    static Result<ProjectChange> open(const std::filesystem::path& file);
    /// A new project. Errors: as Project::create.
    static Result<ProjectChange> create(const std::filesystem::path& file);
    ~ProjectChange();
    ProjectChange(ProjectChange&&) noexcept = default;
    ProjectChange& operator=(ProjectChange&&) = delete;

    Project& operator*() noexcept { return *project_; }
    Project* operator->() noexcept { return project_.get(); }

    /// Saves, and moves `outputs` to their final names with it: all or none. Errors: as Project::save.
    Result<void> save(std::span<StagedFile> outputs = {});

private:
    explicit ProjectChange(Project project) : project_(std::make_unique<Project>(std::move(project))) {}
    std::unique_ptr<Project> project_; ///< null: moved from
};

} // namespace burin
