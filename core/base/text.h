// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Marks text for translation without Qt. Context and text must be literals: lupdate reads them from the source
/// (`-tr-function-alias QT_TRANSLATE_NOOP+=BURIN_TEXT`); the user interface looks the pair up when it shows it.
#define BURIN_TEXT(context, text) (::burin::TextId{context, text})

namespace burin {

/// A text of the user interface that was marked for translation in core. Both pointers refer to literals.
struct TextId {
    const char* context = "";
    const char* text = "";
};

} // namespace burin
