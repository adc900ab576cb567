// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <string>

namespace burin {

// What the import recorded in English, in the language of the user interface.

/// Also of a note that a project has kept. A text that Burin does not know stays as it is.
QString importNoteText(const std::string& note);
/// A name that the file gives stays as it is; "Body 2" stands for none.
QString bodyName(const std::string& name);

} // namespace burin
