// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <optional>
#include <string>

namespace burin {

/// "TAKE:SECONDS" as a moment of a project's recordings, to a sample; "TAKE" alone is its end.
/// Errors: argumentInvalid (of another form, or beyond the take's end), nameUnknown (the take).
Result<TakeMoment> momentOf(const Project& project, const std::string& text);

/// A stretch of a take. @param from, to s since its start; nothing: its start, its end
/// Errors: nameUnknown, argumentInvalid (nothing lies between them).
Result<SampleRange> stretchOf(const Project& project, std::int64_t take, std::optional<double> from,
                              std::optional<double> to);

} // namespace burin
