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
/// (blue). Lightness decreases to both sides, so that the sides differ for colour-blind viewers and in greyscale, too.
/// The colours are the same in every theme, in files and on the screen, because a colour stands for a value. They
/// follow ColorBrewer's RdBu (C. Brewer, M. Harrower, 2003).
///
/// Both sides have bands up to 1, 2, 5, 10 and 20 times their tolerance, all of the same length on the scale; the first
/// band is within tolerance. With an allowance, everything between the part and the allowance is nominal. For stock
/// during milling, two darker bands extend the scale to 100 times the tolerance.
class DeviationScale {
public:
    enum class Reach { result, milling };
    explicit DeviationScale(const DeviationTolerance& tolerance, Reach reach = Reach::result);

    /// A boundary between two bands.
    struct Mark {
        double deviation = 0.0;   ///< mm, as `deviationOf`
        bool ofTolerance = false; ///< beyond it is out of tolerance
        DeviationColour colour{};
    };
    /// At least three, from the deepest gouge to the most stock. Mark i is at i / (count - 1) of the scale.
    const std::vector<Mark>& marks() const noexcept { return marks_; }
    /// Position of a deviation, mm, on the scale, 0 … 1; values beyond an end are at that end.
    double positionOf(double deviation) const noexcept;
    DeviationColour colourAt(double position) const noexcept;
    DeviationColour colourOf(double deviation) const noexcept { return colourAt(positionOf(deviation)); }

private:
    std::vector<Mark> marks_;
};

/// For points without a value, or with one that no tool of the program could improve: a grey that the scale does not
/// contain. Surfaces of this colour are hatched.
inline constexpr DeviationColour unmeasuredColour{128, 128, 122};

/// The colour of a sample: that of its deviation, or `unmeasuredColour` where too much stock is left out of reach of
/// the tools.
DeviationColour colourOf(const DeviationSample& sample, const DeviationScale& scale,
                         const DeviationTolerance& tolerance) noexcept;

} // namespace burin
