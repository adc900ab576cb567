// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_map.h"

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

using DeviationColour = std::array<std::uint8_t, 3>; ///< red, green, blue, sRGB

/// The colours of the deviation map, from too deep (red) over the nominal surface (nearly white) to stock that is left
/// (blue). Lightness falls to both sides, so that the sides differ for a colour-blind eye and in grey, too. The same in
/// every theme, in files and on the screen, as a colour stands for a value. Colours after ColorBrewer's RdBu (C.
/// Brewer, M. Harrower, 2003).
///
/// Both sides go in bands of 1, 2, 5, 10 and 20 times their tolerance, all of the same length on the scale: the first
/// one is within tolerance. With an allowance everything between the part and the allowance is nominal. For stock that
/// is still milled two darker bands lead on to 100 times the tolerance.
class DeviationScale {
public:
    enum class Reach { result, milling };
    explicit DeviationScale(const DeviationTolerance& tolerance, Reach reach = Reach::result);

    /// Where two bands meet.
    struct Mark {
        double deviation = 0.0;   ///< mm, as `deviationOf`
        bool ofTolerance = false; ///< what lies outside is out of tolerance
        DeviationColour colour{};
    };
    /// At least three, from the deepest gouge to the most stock. Mark i stands at i / (count - 1) of the scale.
    const std::vector<Mark>& marks() const noexcept { return marks_; }
    /// Where a deviation, mm, stands on the scale, 0 … 1; what lies beyond an end stands at the end.
    double positionOf(double deviation) const noexcept;
    DeviationColour colourAt(double position) const noexcept;
    DeviationColour colourOf(double deviation) const noexcept { return colourAt(positionOf(deviation)); }

private:
    std::vector<Mark> marks_;
};

/// Where there is no value, or one that no tool of the program could better: a grey that the scale does not have. It is
/// hatched where it is a surface.
inline constexpr DeviationColour unmeasuredColour{128, 128, 122};

/// The colour of a sample: that of its deviation, or `unmeasuredColour` where too much is left out of the tools' reach.
DeviationColour colourOf(const DeviationSample& sample, const DeviationScale& scale,
                         const DeviationTolerance& tolerance) noexcept;

} // namespace burin
