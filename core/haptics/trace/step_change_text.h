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

/// Writes changes of a step as one JSON object each, without a line end. Numbers are read back exactly, to the bit. The
/// keys are listed in README.md. A guide refers to its curve by a number; a separate object before it gives the points
/// of the curve with that number.
class StepChangeWriter {
public:
    /// Appends one object per line, each preceded by `before` and followed by a line end: first the curves that were
    /// not written yet, then the change. Numbers that are not finite, which no active guide has, are written as 0; a
    /// scale or a rotation that is not finite, which no workspace uses, is omitted.
    void append(std::string& text, std::string_view before, const StepChange& change);

private:
    int numberOf(const GuideCurve* curve, std::string& text, std::string_view before);

    std::vector<const GuideCurve*> curves_; ///< in the order of their numbers
};

/// Reads the output of StepChangeWriter.
class StepChangeReader {
public:
    /// Returns an empty optional for a curve. Errors: resourceInvalid (place: the key), argumentInvalid (an invalid
    /// guide or curve).
    Result<std::optional<StepChange>> read(std::string_view text, const std::string& origin);
    /// The curves that the guides refer to.
    std::vector<std::unique_ptr<const GuideCurve>> takeCurves() noexcept { return std::move(curves_); }

private:
    Result<GuideSettings> readGuides(JsonObject& object) const;
    Result<void> readCurve(JsonObject& object, std::size_t longest);

    std::vector<std::unique_ptr<const GuideCurve>> curves_;
};

} // namespace burin
