// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/revolution_envelope.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace burin {

namespace {

constexpr double sameHeight = 1e-9; // mm
constexpr int fewestSlices = 512;   // smallest number of slices over the mesh's height

struct MeshEdge {
    glm::dvec3 low{0.0}, high{0.0}; ///< mm, low.z < high.z
    /// Returns the distance from the axis, mm: a convex function of the height.
    double radiusAt(double height) const noexcept {
        const double part = (height - low.z) / (high.z - low.z);
        return std::hypot(low.x + part * (high.x - low.x), low.y + part * (high.y - low.y));
    }
};

/// An interval of heights in which no edge begins or ends, with the largest radius at its ends.
struct Slice {
    double low = 0.0, high = 0.0;               ///< mm
    double lowRadius = -1.0, highRadius = -1.0; ///< mm; below 0: empty
    double middle = -1.0;                       ///< mm, largest radius halfway
};

/// Returns the edges that are not horizontal. The section of a triangle with a plane perpendicular to the axis is a
/// line segment, farthest from the axis at one of its ends: edges are sufficient.
std::vector<MeshEdge> risingEdges(const TriangleMesh& mesh) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto& [a, b, c] : mesh.triangles)
        for (const auto& [one, other] : {std::pair{a, b}, {b, c}, {c, a}}) pairs.insert(std::minmax(one, other));
    std::vector<MeshEdge> edges;
    for (const auto& [one, other] : pairs) {
        MeshEdge edge{mesh.vertices[one], mesh.vertices[other]};
        if (edge.low.z > edge.high.z) std::swap(edge.low, edge.high);
        if (edge.high.z - edge.low.z > sameHeight) edges.push_back(edge);
    }
    return edges;
}

std::vector<Slice> emptySlices(const TriangleMesh& mesh) {
    std::vector<double> heights;
    double top = 0.0;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) {
            heights.push_back(mesh.vertices[vertex].z);
            top = std::max(top, heights.back());
        }
    for (int i = 0; i <= fewestSlices; ++i) heights.push_back(top * i / fewestSlices);
    std::ranges::sort(heights);
    std::vector<Slice> result;
    double low = heights.front();
    for (const double height : heights)
        if (height - low > sameHeight) {
            result.push_back({low, height});
            low = height;
        }
    return result;
}

std::vector<Slice> slicesOf(const TriangleMesh& mesh) {
    std::vector<Slice> result = emptySlices(mesh);
    for (const MeshEdge& edge : risingEdges(mesh)) {
        auto slice = std::ranges::lower_bound(result, edge.low.z - sameHeight, {}, &Slice::low);
        for (; slice != result.end() && slice->high <= edge.high.z + sameHeight; ++slice) {
            slice->lowRadius = std::max(slice->lowRadius, edge.radiusAt(slice->low));
            slice->highRadius = std::max(slice->highRadius, edge.radiusAt(slice->high));
            slice->middle = std::max(slice->middle, edge.radiusAt(0.5 * (slice->low + slice->high)));
        }
    }
    return result;
}

/// Fits lines around slices, from below.
class OuterLines {
public:
    OuterLines(const std::vector<Slice>& slices, double tolerance) : slices_(slices), tolerance_(tolerance) {}

    RevolutionEnvelope draw() {
        std::size_t first = 0;
        for (std::size_t i = 1; i <= slices_.size(); ++i) {
            // A line always ends where the radius jumps, regardless of the tolerance.
            if (i < slices_.size() && std::abs(slices_[i].lowRadius - slices_[i - 1].highRadius) <= 0.1 * tolerance_)
                continue;
            cover(first, i);
            first = i;
        }
        return std::move(result_);
    }

private:
    /// Largest distances, mm, by which a line from the low end of a slice to the high end of another lies inside and
    /// outside of the slices that it has to enclose.
    struct Fit {
        double inside = 0.0, outside = 0.0;
        std::size_t worst = 0;
    };
    Fit fit(std::size_t first, std::size_t end) const {
        const Slice &from = slices_[first], &to = slices_[end - 1];
        Fit fit;
        double worst = 0.0;
        const auto look = [&](double height, double radius, std::size_t cut) {
            const double part = (height - from.low) / (to.high - from.low);
            const double off = from.lowRadius + part * (to.highRadius - from.lowRadius) - radius;
            fit.inside = std::max(fit.inside, -off);
            fit.outside = std::max(fit.outside, off);
            if (cut > first && cut < end && std::abs(off) > worst) {
                worst = std::abs(off);
                fit.worst = cut;
            }
        };
        for (std::size_t i = first; i < end; ++i) {
            look(slices_[i].low, slices_[i].lowRadius, i);
            look(slices_[i].high, slices_[i].highRadius, i + 1);
        }
        return fit;
    }
    void cover(std::size_t first, std::size_t end) {
        const Fit found = fit(first, end);
        if (found.worst != 0 && found.inside + found.outside > tolerance_) {
            cover(first, found.worst);
            cover(found.worst, end);
            return;
        }
        const Slice &from = slices_[first], &to = slices_[end - 1];
        lineTo(from.lowRadius + found.inside, from.low);
        lineTo(to.highRadius + found.inside, to.high);
        // Within a slice the radius is convex: the largest error of its chord is at most twice that in the middle.
        double within = 0.0;
        for (std::size_t i = first; i < end; ++i)
            within = std::max(within, slices_[i].lowRadius + slices_[i].highRadius - 2.0 * slices_[i].middle);
        result_.excess = std::max(result_.excess, found.inside + found.outside + within);
    }
    void lineTo(double radius, double height) {
        const ProfileElement before = result_.profile.empty() ? ProfileElement{} : result_.profile.back();
        if (before.radius == radius && before.height == height) return;
        result_.profile.push_back({radius, height, 0.0, false});
        result_.widest = std::max(result_.widest, radius);
    }

    const std::vector<Slice>& slices_;
    double tolerance_;
    RevolutionEnvelope result_;
};

} // namespace

Result<RevolutionEnvelope> revolutionEnvelope(const TriangleMesh& mesh, double tolerance) {
    std::vector<Slice> slices = mesh.empty() ? std::vector<Slice>{} : slicesOf(mesh);
    if (slices.empty() || std::abs(slices.front().low) > sameHeight)
        return Error{ErrorCode::argumentInvalid, "flutes", formatShortest(slices.empty() ? 0.0 : slices.front().low),
                     "a body whose lowest point is at height 0"};
    slices.front().low = 0.0;
    for (const Slice& slice : slices)
        if (slice.lowRadius < 0.0)
            return Error{ErrorCode::argumentInvalid, "flutes", formatShortest(slice.low) + " mm",
                         "a body without a gap between two heights"};
    return OuterLines(slices, tolerance).draw();
}

} // namespace burin
