// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect.h"
#include "core/nc/dialect_data.h"

#include <functional>

namespace burin {

/// Hands a program's lines to a sink as a dialect wants them: numbered, comments within what may stand in them and
/// within the line's length, values put into blocks.
class BlockWriter {
public:
    BlockWriter(const DialectData& dialect, int lineLength, LineSink& sink)
        : dialect_(dialect), lineLength_(lineLength), sink_(sink) {}

    /// A block with its number, where blocks have one; an empty one is left out.
    Result<void> block(std::string_view words);
    /// One comment, on as many lines as it needs.
    Result<void> comment(std::string_view text);

    /// Words in braces become what `valueOf` says.
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
