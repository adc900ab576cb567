// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect.h"
#include "core/nc/dialect_data.h"

#include <functional>

namespace burin {

/// Passes the lines of a program to a sink in the form of a dialect: numbered, with comments limited to the allowed
/// characters and line length, and with values put into blocks.
class BlockWriter {
public:
    BlockWriter(const DialectData& dialect, int lineLength, LineSink& sink)
        : dialect_(dialect), lineLength_(lineLength), sink_(sink) {}

    /// Writes a block, with a number if the dialect numbers its blocks; skips an empty one.
    Result<void> block(std::string_view words);
    /// Writes a comment, on as many lines as it needs.
    Result<void> comment(std::string_view text);

    /// Replaces the words in braces by what `valueOf` returns for them.
    static Result<std::string> filled(std::string_view text,
                                      const std::function<Result<std::string>(std::string_view)>& valueOf);

private:
    std::string commentText(std::string_view text) const;
    char insteadOfComma() const;

    const DialectData& dialect_;
    int lineLength_;
    LineSink& sink_;
    int number_ = 0;
};

} // namespace burin
