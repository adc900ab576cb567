// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <optional>
#include <string>

namespace burin {

/// "TAKE:SECONDS" as a moment of a project's recordings, rounded to a sample; "TAKE" alone is the end of the take.
/// Errors: argumentInvalid (wrong form, or beyond the take's end), nameUnknown (the take).
Result<TakeMoment> momentOf(const Project& project, const std::string& text);

/// An interval of a take. @param from, to s since its start; empty: its start, its end
/// Errors: nameUnknown, argumentInvalid (the interval is empty).
Result<SampleRange> intervalOf(const Project& project, std::int64_t take, std::optional<double> from,
                               std::optional<double> to);

} // namespace burin
