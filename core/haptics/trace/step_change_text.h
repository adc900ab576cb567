// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/haptics/step_change.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

class JsonObject;

/// Changes of a step as one JSON object each, without a line end. Numbers come back to the bit. README.md has the keys.
/// A guide names its curve by a number, under which an object of its own gave its points before.
class StepChangeWriter {
public:
    /// One object a line, each with `before` in front of it and a line end behind it: curves that were not named
    /// yet, then the change. Numbers that are not finite, which no guide that is on has, are written as 0; a scale or a
    /// rotation that is not, which no workspace follows, is left out.
    void append(std::string& text, std::string_view before, const StepChange& change);

private:
    int numberOf(const GuideCurve* curve, std::string& text, std::string_view before);

    std::vector<const GuideCurve*> curves_; ///< by their numbers
};

/// Reads what StepChangeWriter wrote.
class StepChangeReader {
public:
    /// Nothing: it was a curve. Errors: resourceInvalid (place: the key), argumentInvalid (a guide or a curve that does
    /// not do).
    Result<std::optional<StepChange>> read(std::string_view text, const std::string& origin);
    /// The curves that guides point to.
    std::vector<std::unique_ptr<const GuideCurve>> takeCurves() noexcept { return std::move(curves_); }

private:
    Result<GuideSettings> readGuides(JsonObject& object) const;
    Result<void> readCurve(JsonObject& object, std::size_t longest);

    std::vector<std::unique_ptr<const GuideCurve>> curves_;
};

} // namespace burin
