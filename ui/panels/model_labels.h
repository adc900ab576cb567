// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <string>

namespace burin {

// Translates what the import recorded in English into the language of the user interface.

/// Also for notes stored in a project. Unknown texts are returned unchanged.
QString importNoteText(const std::string& note);
/// Of a body or an assembly. A name given by the file is returned unchanged, with its path; if there is none, "Body 2"
/// is used.
QString bodyName(const std::string& name);

} // namespace burin
