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
    /// The range that is drawn: that of all values, from 0, except for the height. Of the deviation, values from the
    /// least one, or 0, to 5 mm at most: greater ones are drawn as 5 mm.
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
    /// Provides the curves of `reference` as if it had begun together with `take`; none if either is 0 or not recorded.
    void setReference(std::int64_t take, std::int64_t reference);
    bool hasReference() const noexcept { return reference_ != 0; }
    const Range& range(TrackCurve curve) const noexcept { return ranges_[static_cast<std::size_t>(curve)]; }
    /// The maximum in each column, of the deviation the minimum; NaN where there is no value.
    const std::vector<double>& columns(TrackCurve curve, const Window& window);
    /// The same for the reference, up to the end of the take.
    const std::vector<double>& referenceColumns(TrackCurve curve, const Window& window);

private:
    using Columns = std::array<std::vector<double>, trackCurves>; ///< empty until requested
    void follow(const Window& window);
    std::vector<double> extremes(TrackCurve curve) const;
    std::vector<double> extremesOfReference(TrackCurve curve) const;
    /// @param start, end s, of the drawn part of the track
    void add(std::vector<double>& extremes, const TakeTrack& track, TrackCurve curve, double start, double end) const;

    std::shared_ptr<const RecordedTime> recorded_;
    std::array<Range, trackCurves> ranges_{};
    std::int64_t take_ = 0, reference_ = 0; ///< 0: no reference
    Window window_;                         ///< that the cached columns belong to
    Columns columns_, referenceColumns_;
};

} // namespace burin
