// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/promised_path.h"

#include "core/geometry/arc.h"
#include "core/path/polyline.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <unordered_map>

namespace burin {

namespace {

constexpr double onPath = 0.02;      // mm: rounding, arcs and fits of a post deviate from a path by less
constexpr double nearestPath = 3.0;  // mm: a path farther away is not compared
constexpr double pathNearPart = 1.0; // mm
constexpr double betweenLooks = 1.0; // mm along a move
constexpr double pathChord = 0.001;  // mm
constexpr ClearanceTolerance pathAnswers{1e-3, 0.0, 1e-6};

struct PathSegment {
    glm::dvec3 from{0.0}, to{0.0};
};

/// The feed moves of one tool's paths, indexed by position.
class SegmentCells {
public:
    void add(const Path& path) {
        std::vector<glm::dvec3> ends;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const PathPoint& point = path.points[i];
            if (point.kind == MoveKind::rapid) continue;
            glm::dvec3 at = path.points[i - 1].pose.tip;
            ends = {point.pose.tip};
            if (point.arc)
                flatten(Arc{at, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise}, pathChord,
                        ends);
            for (const glm::dvec3& end : ends) {
                add({at, end});
                at = end;
            }
        }
    }
    bool empty() const noexcept { return segments_.empty(); }

    /// The nearest point on a path, no farther than `within` mm (at most a cell).
    std::optional<glm::dvec3> nearest(const glm::dvec3& place, double within) const {
        std::optional<glm::dvec3> best;
        double least = within;
        const glm::ivec3 cell = cellOf(place);
        for (const int dx : {0, -1, 1}) // the most frequent case first
            for (const int dy : {0, -1, 1})
                for (const int dz : {0, -1, 1}) {
                    const auto found = cells_.find(keyOf(cell + glm::ivec3(dx, dy, dz)));
                    if (found == cells_.end()) continue;
                    for (const std::uint32_t number : found->second) {
                        const PathSegment& segment = segments_[number];
                        const glm::dvec3 on = nearestOnSegment(place, segment.from, segment.to);
                        const double distance = glm::distance(on, place);
                        if (distance > least) continue;
                        least = distance;
                        best = on;
                        if (distance < 0.25 * onPath) return best; // a nearer one would not matter
                    }
                }
        return best;
    }

private:
    static glm::ivec3 cellOf(const glm::dvec3& place) noexcept { return glm::ivec3(glm::floor(place / nearestPath)); }
    static std::uint64_t keyOf(const glm::ivec3& cell) noexcept {
        const auto part = [](int value) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)) & 0x1FFFFFU;
        };
        return part(cell.x) << 42U | part(cell.y) << 21U | part(cell.z);
    }
    void add(const PathSegment& segment) {
        const auto number = static_cast<std::uint32_t>(segments_.size());
        segments_.push_back(segment);
        const auto steps = static_cast<int>(glm::distance(segment.from, segment.to) / (0.5 * nearestPath)) + 1;
        std::uint64_t last = 0;
        for (int i = 0; i <= steps; ++i) {
            const std::uint64_t key = keyOf(cellOf(glm::mix(segment.from, segment.to, static_cast<double>(i) / steps)));
            if (i > 0 && key == last) continue;
            last = key;
            cells_[key].push_back(number);
        }
    }

    std::vector<PathSegment> segments_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

class Comparer {
public:
    Comparer(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request,
             Findings& findings)
        : moves_(moves), request_(request), findings_(findings), paths_(tools.size()) {
        for (std::size_t i = 0; i < tools.size(); ++i) {
            for (const Path& path : *request.promised)
                if (path.toolId == tools[i].id) paths_[i].add(path);
            stacks_.push_back(pieces(tools[i].cutter));
        }
        for (const auto& stack : stacks_) parts_.push_back(std::make_unique<ClearanceAsker>(*request.part, stack));
    }

    Result<PathComparison> run(const Progress& progress) {
        PathComparison comparison;
        comparison.ends.assign(request_.program->motions.size(), PathSide::unknown);
        for (std::size_t i = 0; i < moves_.size(); ++i) {
            if (i % 1024 == 0 && progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
            const ToolMove& move = moves_[i];
            if (move.rapid || !move.endKnown || paths_[move.tool].empty()) continue;
            const auto steps = static_cast<int>(glm::distance(move.begin().tip, move.to.tip) / betweenLooks) + 1;
            bool off = false;
            for (int k = 1; k <= steps; ++k) off = look(move, move.poseAt(static_cast<double>(k) / steps));
            comparison.ends[move.motion] = off ? PathSide::off : PathSide::on;
        }
        return comparison;
    }

private:
    /// Whether a move descends to its path or leaves it: the tool need not be on a path meanwhile.
    static bool isAlongAxis(const ToolMove& move) noexcept {
        constexpr double steepest = 0.1; // sideways over along
        const glm::dvec3 way = move.to.tip - move.begin().tip;
        return std::hypot(way.x, way.y) < steepest * std::abs(way.z);
    }
    /// @return whether the tip is off the paths
    bool look(const ToolMove& move, const ToolPose& pose) {
        const glm::dvec3& tip = pose.tip;
        const SegmentCells& paths = paths_[move.tool];
        const std::optional<glm::dvec3> nearest = paths.nearest(tip, nearestPath);
        if (!nearest) return true;
        const double away = glm::distance(*nearest, tip);
        const double tolerance = request_.excessTolerance;
        if (tolerance > 0.0 && away > tolerance && !isAlongAxis(move)) {
            ClearanceAsker& part = *parts_[move.tool];
            const ToolClearance promised = part.ask(ToolPose{*nearest, pose.axis}, pathNearPart, pathAnswers);
            if (promised.clearance < pathNearPart) {
                const ToolClearance left = part.ask(pose, pathNearPart + nearestPath, pathAnswers);
                const double difference = std::abs(left.clearance - promised.clearance);
                if (difference > tolerance && left.clearance >= -request_.gougeTolerance) // otherwise it is a gouge
                    findings_.add({FindingKind::allowanceDiffers, move.line, promised.meshPoint,
                                   std::max(0.0, left.clearance), std::max(0.0, promised.clearance)});
            }
        }
        return away > onPath;
    }

    const std::vector<ToolMove>& moves_;
    const VerifyRequest& request_;
    Findings& findings_;
    std::vector<SegmentCells> paths_;                    ///< by tool
    std::vector<std::vector<RevolvedPiece>> stacks_;     ///< the same
    std::vector<std::unique_ptr<ClearanceAsker>> parts_; ///< the same
};

} // namespace

Result<PathComparison> comparePaths(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    const VerifyRequest& request, Findings& findings, const Progress& progress) {
    if (request.promised == nullptr || request.promised->empty()) return PathComparison{};
    return Comparer(moves, tools, request, findings).run(progress);
}

} // namespace burin
