// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// What the window does with a project between opening and closing it, by the same calls: change, save, and save under
// another name. Arguments: FILE, or FILE and the other name. The exit status is that of a command.
#include "core/document/project.h"

#include <iostream>

namespace {

int fail(const burin::Error& error) {
    std::cerr << error.subject << ": " << error.detail << "\n";
    return static_cast<int>(burin::errorClass(error.code));
}

int work(const char* file, const char* other) {
    burin::Result<burin::Project> project = burin::Project::open(file);
    if (!project) return fail(project.error());
    if (const auto done = project->setProgramDraft("G0 X1"); !done) return fail(done.error());
    if (const auto noted = project->setLeftAt("{}"); !noted) return fail(noted.error());
    const burin::Result<void> saved = other != nullptr ? project->saveAs(other) : project->save();
    return saved ? 0 : fail(saved.error());
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    return work(argv[1], argc > 2 ? argv[2] : nullptr);
}
