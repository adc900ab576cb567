// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_time.h"
#include "ui/theme/length_unit.h"
#include "ui/theme/theme.h"

#include <QString>

#include <array>
#include <memory>
#include <vector>

namespace burin {

/// The translated name of a curve: "Force", …
QString curveName(TrackCurve curve);
/// A value with its unit, for display.
QString curveText(TrackCurve curve, double value, LengthUnit unit);
ColourRole curveColour(TrackCurve curve);

/// The curves of recordings, resampled to pixel columns. The last requested ones are cached, so that moving the cursor
/// over them costs nothing.
class TimelineCurves {
public:
    /// The range of all values; it starts at 0, except for the height.
    struct Range {
        double low = 0.0, high = 0.0;
    };
    /// An interval of time, s, and its number of pixel columns.
    struct Window {
        double begin = 0.0, length = 0.0;
        int columns = 0;
        friend bool operator==(const Window&, const Window&) = default;
    };

    /// @param recorded null: none
    void setRecorded(std::shared_ptr<const RecordedTime> recorded);
    const Range& range(TrackCurve curve) const noexcept { return ranges_[static_cast<std::size_t>(curve)]; }
    /// The maximum in each column; NaN where there is no value.
    const std::vector<double>& columns(TrackCurve curve, const Window& window);

private:
    std::vector<double> greatest(TrackCurve curve, const Window& window) const;

    std::shared_ptr<const RecordedTime> recorded_;
    std::array<Range, trackCurves> ranges_{};
    Window window_;                                        ///< of the cached columns
    std::array<std::vector<double>, trackCurves> columns_; ///< empty: not requested yet
};

} // namespace burin
