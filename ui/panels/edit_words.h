// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin {

// What panels say of the parameters of edits, English texts of the context "EditParameterTexts", to be translated. What
// a parameter may be, core knows.

struct EditWords {
    const char* label;
    const char* toolTip;
};

/// @param edit id of the kind. Null: there are none
const EditWords* editWordsOf(std::string_view edit, std::string_view key);
/// Of one of a parameter's names. Null: there are none
const char* editChoiceWords(std::string_view choice);

} // namespace burin
