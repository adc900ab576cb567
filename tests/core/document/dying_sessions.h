// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/document/working_copy.h"
#include "tests/core/document/processes.h"
#include "tests/core/document/sample_project.h"

#include <QDir>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>
#include <string>

/// Projects whose sessions ended by a kill.
namespace burin::fixture {

inline std::string nameInFile(const std::filesystem::path& file) {
    Result<Project> project = Project::open(file);
    return project ? nameIn(*project) : std::string("not opened");
}

inline bool saveAs(const std::filesystem::path& file, const std::string& name) {
    Result<Project> project = Project::create(file);
    return project && project->setModel(modelNamed(name)) && project->save();
}

/// A session that opens `file`, changes the model to `name` and dies.
inline bool dieWith(const std::filesystem::path& file, const std::string& name) {
    return inAnotherProcess([&] {
               Result<Project> project = Project::open(file);
               ::_exit(project && project->setModel(modelNamed(name)) ? 0 : 1);
               return 1;
           }) == 0;
}

/// A session that opens `file` and dies without a change.
inline bool dieIdle(const std::filesystem::path& file) {
    return inAnotherProcess([&] {
               const Result<Project> project = Project::open(file);
               ::_exit(project ? 0 : 1);
               return 1;
           }) == 0 &&
           std::filesystem::exists(WorkingCopy::pathBeside(file));
}

inline std::filesystem::path fileIn(const QTemporaryDir& folder, const char* name = "p.burin") {
    return folder.filePath(name).toStdString();
}

inline QStringList namesIn(const QTemporaryDir& folder) {
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

inline void write(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

} // namespace burin::fixture
