// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project_change.h"

namespace burin {

Result<ProjectChange> ProjectChange::open(const std::filesystem::path& file) {
    Result<Project> project = Project::open(file);
    if (!project) return std::move(project).error();
    if (project->readOnly())
        return Error{ErrorCode::fileNotWritable, project->file().string(), {}, "its folder is protected"};
    if (project->recovered())
        if (Result<void> saved = project->save(); !saved) return std::move(saved).error();
    return ProjectChange(std::move(*project));
}

Result<ProjectChange> ProjectChange::create(const std::filesystem::path& file) {
    Result<Project> project = Project::create(file);
    if (!project) return std::move(project).error();
    return ProjectChange(std::move(*project));
}

ProjectChange::~ProjectChange() {
    // A successful change is completely in the file, and nothing of an unsuccessful one is to stay: neither needs the
    // working copy.
    if (project_) project_->abandonChanges();
}

Result<void> ProjectChange::save(std::span<StagedFile> outputs) {
    return project_->save(outputs);
}

} // namespace burin
