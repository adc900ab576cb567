// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/path/added_turns.h"
#include "core/path/apply.h"
#include "core/path/curve_deviation.h"
#include "core/path/shape_corners.h"
#include "core/path/shape_course.h"
#include "core/path/shape_fit.h"
#include "core/path/shape_tube.h"

#include <algorithm>

namespace burin {
namespace {

/// Distance between knots: this fraction of the cut-off wavelength, or this multiple of the tolerance.
constexpr double knotsInWavelength = 40.0, knotsInTolerance = 4.0;
/// Steps back of less than the first share of the wavelength, and deviations from chords of less than the second, do
/// not belong to the shape.
constexpr double slackShare = 0.5, chordShare = 0.1;
/// Bends within this share of the tolerance do not count.
constexpr double bendShare = 0.1;
/// How often the curve is split at the sharpest corner near by where it cannot follow.
constexpr int cornerRounds = 6;
constexpr double corner = 20.0 * pi / 180.0, cornerLeg = 0.05; // rad; share of the wavelength
/// No curve of this wavelength follows such a sharp turn without swinging before and behind it. Shorter legs are those
/// of a hesitating hand.
constexpr double sharpCorner = 50.0 * pi / 180.0, sharpCornerLeg = 0.15; // rad; share of the wavelength

/// The recorded points' own tips, mm.
std::vector<glm::dvec3> tipsOf(std::span<const StrokePoint> points) {
    std::vector<glm::dvec3> tips;
    for (const StrokePoint& point : points) tips.push_back(point.pose.tip);
    return tips;
}

/// Smooths a stroke in pieces: a curve for each interval between two corners, through both of them.
class StrokeSmoother {
public:
    StrokeSmoother(const PathStroke& stroke, const SmoothShape& edit, const Progress& progress)
        : points_(stroke.points)
        , recorded_(tipsOf(points_))
        , wavelength_(edit.wavelength)
        , tolerance_(edit.tolerance)
        // Knots are dense enough to follow corners where the tube requires it.
        , gap_(std::min(edit.wavelength / knotsInWavelength, knotsInTolerance * edit.tolerance))
        , progress_(progress) {}

    /// The tips, mm, point by point; empty if the stroke is too short to have a shape, or the work was cancelled.
    std::vector<glm::dvec3> smoothed() {
        if (!findCourse()) return {};
        const AddedTurns added(recorded_, course_, {wavelength_, bendShare * tolerance_}, progress_);
        const ShapeCorners shape(points_, course_, {tolerance_, 2.0 * gap_, wavelength_}, progress_);
        std::vector<std::size_t> corners = shape.sharperThan({sharpCorner, sharpCornerLeg * wavelength_});
        fitBetween(corners, {});
        if (corners.empty()) fitPieces({{0, points_.size() - 1, true, true}});
        for (int round = 0; round < cornerRounds && !progress_.cancelled(); ++round) {
            std::vector<bool> marked = added.in(smoothed_, progress_);
            for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = marked[i] || outside_[i];
            const std::vector<std::size_t> more =
                shape.withCornersAt(marked, {corner, cornerLeg * wavelength_}, corners);
            if (more.size() == corners.size()) break;
            fitBetween(more, corners);
            corners = more;
        }
        added.undo(smoothed_, progress_);
        ShapeTube(recorded_, tolerance_, wavelength_).restoreOutside(smoothed_, progress_);
        return progress_.cancelled() ? std::vector<glm::dvec3>() : smoothed_;
    }
    std::span<const glm::dvec3> recorded() const noexcept { return recorded_; }

private:
    double shortest() const noexcept { return 4.0 * gap_; } // mm: a shorter stroke has no shape

    /// Computes the progress of the stroke along its own shape at each point. @return false if it has no shape
    bool findCourse() {
        course_ = shapeCourse(points_, chordShare * wavelength_, slackShare * wavelength_, progress_);
        if (progress_.cancelled() || tolerance_ <= 0.0 || course_.empty() || course_.back() < shortest()) return false;
        ShapeFit coarse(points_, course_, wavelength_, gap_);
        coarse.fit();
        course_ = courseAlong(coarse, points_);
        smoothed_ = recorded_;
        outside_.assign(points_.size(), false);
        return course_.back() >= shortest();
    }

    /// Fits the pieces that a new corner begins or ends.
    void fitBetween(const std::vector<std::size_t>& corners, const std::vector<std::size_t>& before) {
        const std::size_t last = points_.size() - 1;
        const auto isEnd = [&](std::size_t point) { return point == 0 || point == last; };
        const auto stood = [&](std::size_t point) { return isEnd(point) || std::ranges::binary_search(before, point); };
        std::vector<Piece> pieces;
        for (std::size_t k = 0; k <= corners.size(); ++k) {
            const std::size_t from = k == 0 ? 0 : corners[k - 1], to = k == corners.size() ? last : corners[k];
            if (!stood(from) || !stood(to)) pieces.push_back({from, to, isEnd(from), isEnd(to)});
        }
        fitPieces(pieces);
    }

    struct Piece {
        std::size_t first = 0, last = 0;
        bool freeStart = true, freeEnd = true; ///< whether the curve may end elsewhere than the piece does
    };
    struct Fitted {
        std::vector<glm::dvec3> tips; ///< mm
        std::vector<bool> outside;
    };

    /// Neighbours share a point, so what was found is put in place afterwards.
    void fitPieces(const std::vector<Piece>& pieces) {
        std::vector<Fitted> fitted(pieces.size());
        parallelFor(std::size_t{0}, pieces.size(), [&](std::size_t i) { fitted[i] = fitTo(pieces[i]); });
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const std::size_t first = pieces[k].first;
            std::ranges::copy(fitted[k].tips, smoothed_.begin() + static_cast<std::ptrdiff_t>(first));
            for (std::size_t i = 0; i < fitted[k].outside.size(); ++i) outside_[first + i] = fitted[k].outside[i];
        }
    }
    Fitted fitTo(const Piece& piece) const {
        const std::size_t first = piece.first, count = piece.last - first + 1;
        const auto points = std::span(points_).subspan(first, count);
        std::vector<glm::dvec3> tips(recorded_.begin() + static_cast<std::ptrdiff_t>(first),
                                     recorded_.begin() + static_cast<std::ptrdiff_t>(piece.last) + 1);
        std::vector<double> course(count);
        for (std::size_t i = 0; i < count; ++i) course[i] = course_[first + i] - course_[first];
        ShapeFit fit(points, course, wavelength_, gap_);
        if (!piece.freeStart) fit.pin(0);
        if (!piece.freeEnd) fit.pin(count - 1);
        const ShapeTube tube(tips, tolerance_, wavelength_);
        Fitted fitted{tube.drawIn(fit, progress_), {}};
        if (!piece.freeStart) fitted.tips.front() = tips.front();
        if (!piece.freeEnd) fitted.tips.back() = tips.back();
        fitted.outside = tube.outside(fitted.tips);
        tube.restoreOutside(fitted.tips, progress_);
        return fitted;
    }

    const std::vector<StrokePoint>& points_;
    const std::vector<glm::dvec3> recorded_;    // mm
    const double wavelength_, tolerance_, gap_; // mm
    const Progress& progress_;
    std::vector<double> course_;       // mm, of each point
    std::vector<glm::dvec3> smoothed_; // mm
    std::vector<bool> outside_;        // points that could not be pulled into the tube
};

Deviation smooth(PathStroke& stroke, const SmoothShape& edit, const Progress& progress) {
    StrokeSmoother smoother(stroke, edit, progress);
    const std::vector<glm::dvec3> smoothed = smoother.smoothed();
    if (smoothed.empty()) return {};
    const Deviation deviation = curveDeviation(smoother.recorded(), smoothed, edit.wavelength);
    for (std::size_t i = 0; i < smoothed.size(); ++i) stroke.points[i].pose.tip = smoothed[i];
    return deviation;
}

} // namespace

Result<Deviation> apply(const SmoothShape& edit, PathUnderEdit& state, const PathContext&, Progress& progress) {
    return changeEach(state, progress, [&](PathStroke& stroke) { return smooth(stroke, edit, progress); });
}

} // namespace burin
