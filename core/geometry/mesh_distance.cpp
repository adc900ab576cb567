// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_distance.h"

#include "core/base/parallel.h"
#include "core/geometry/clearance_memory.h"
#include "core/geometry/entry_search.h"
#include "core/geometry/frame_along.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

std::vector<std::uint32_t> finiteTriangles(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> places;
    places.reserve(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        if (isFinite(mesh.vertices[a]) && isFinite(mesh.vertices[b]) && isFinite(mesh.vertices[c])) places.push_back(i);
    }
    return places;
}

/// mm: displacement of corners by storing them as floats, some units in the last place; far from the origin limited to
/// the precision that parts are made to, because other files keep their corners exact there.
double roundingOf(const Box& box) noexcept {
    constexpr double ofReach = 4e-7, most = 1e-3;
    double reach = 0.0;
    for (int axis = 0; axis < 3; ++axis) reach = std::max({reach, std::abs(box.low[axis]), std::abs(box.high[axis])});
    return std::isfinite(reach) ? std::min(most, ofReach * (1.0 + reach)) : 0.0;
}

} // namespace

namespace {

/// Heights of the points of the axis whose depth is evaluated: the pieces' ends and the centres of their roundings.
template <class Visit>
void visitAxis(std::span<const RevolvedPiece> tool, const Visit& visit) {
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tool.size(); ++i)
        for (const double height : {tool[i].bottom, tool[i].bottom + tool[i].cornerRadius, tool[i].top}) {
            if (height <= last) continue; // the same as the previous piece's
            visit(height, i);
            last = height;
        }
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) noexcept {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : otherwise;
}

} // namespace

class MeshDistance::Tree {
public:
    explicit Tree(const TriangleMesh& mesh) : Tree(mesh, Beginning(mesh)) {}

    const Box& bounds() const noexcept { return tree_.bounds(); }
    bool empty() const noexcept { return tree_.empty(); }
    std::span<const Triangle> triangles() const noexcept { return tree_.triangles(); }
    std::optional<TriangleHit> hit(const Ray& ray) const noexcept { return nearestHit(ray, tree_); }
    std::size_t triangleOf(std::size_t slot) const noexcept { return tree_.order()[slot]; }

    /// @param passed  receives a distance: except for the point found, nothing is nearer
    Found nearest(const glm::dvec3& point, double within, double* passed = nullptr) const noexcept {
        Found found;
        double leastSquared = within < 1e150 ? within * within : 1e300;
        NearPoint near(tree_, point);
        near.limit(leastSquared);
        double missed = std::numeric_limits<double>::infinity();
        std::uint64_t work = 0;
        const float nodes = walk(tree_, near, [&](std::size_t slot) noexcept {
            ++work;
            const TrianglePoint candidate = closestOnTriangle(tree_.triangles()[slot], point);
            const glm::dvec3 way = candidate.point - point;
            const double squared = glm::dot(way, way);
            if (!(squared < leastSquared)) {
                missed = std::min(missed, squared);
                return;
            }
            leastSquared = squared;
            near.limit(squared);
            found = {slot, candidate.point, candidate.feature, 0.0, 0, true};
        });
        found.distance = std::sqrt(leastSquared);
        found.work = work;
        if (passed != nullptr) *passed = std::sqrt(std::min(missed, static_cast<double>(nodes) * (1.0 - 4e-6)));
        return found;
    }

    ClosestPoint closest(const glm::dvec3& point, double within) const noexcept {
        if (empty()) within = std::numeric_limits<double>::infinity();
        return answerTo(empty() || !isFinite(point) ? Found{} : nearest(point, within), point, within);
    }

    void trianglesNear(const glm::dvec3& point, double within, std::vector<std::uint32_t>& numbers) const {
        numbers.clear();
        NearPoint near(tree_, point);
        near.limit(within * within);
        std::size_t met = 0;
        walk(tree_, near, [&](std::size_t) noexcept { ++met; });
        numbers.reserve(met); // so that what follows does not throw
        walk(tree_, near, [&](std::size_t slot) noexcept {
            const glm::dvec3 way = closestOnTriangle(tree_.triangles()[slot], point).point - point;
            if (glm::dot(way, way) <= within * within) numbers.push_back(static_cast<std::uint32_t>(slot));
        });
    }

    ClosestPoint closestOf(std::span<const std::uint32_t> numbers, const glm::dvec3& point) const noexcept {
        Found found;
        double leastSquared = std::numeric_limits<double>::infinity();
        for (const std::uint32_t slot : numbers) {
            const TrianglePoint candidate = closestOnTriangle(tree_.triangles()[slot], point);
            const glm::dvec3 way = candidate.point - point;
            const double squared = glm::dot(way, way);
            if (!(squared < leastSquared)) continue;
            leastSquared = squared;
            found = {slot, candidate.point, candidate.feature, 0.0, 0, true};
        }
        found.distance = std::sqrt(leastSquared);
        return signedAnswer(found, point);
    }

    /// @param tie  mm: a mesh has many points that are equally near to a flat; any one of them is sufficient
    /// @param memory  null, or that of a nearby tip
    ToolClearance clearance(std::span<const RevolvedPiece> tool, ToolPose pose, double within,
                            const ClearanceTolerance& tie, ClearanceMemory* memory) const noexcept {
        const ToolClearance free{within, pose.tip, pose.axis, 0, glm::dvec3(0.0)};
        if (empty() || tool.empty() || !isFinite(pose.tip) || !isFinite(pose.axis)) return free;
        pose.axis = unitOr(pose.axis, {0.0, 0.0, 1.0});

        ToolClearance answer = free;
        answer.clearance = 0.0;
        if (memory != nullptr && memory->axisFirst) answer = deeper(answer, tool, pose, tie, memory);
        const bool inside = answer.clearance < 0.0;
        if (!inside) answer.clearance = std::max(within, 0.0);
        const Found found = deepest(tool, pose, answer.clearance, tie, memory);
        if (memory != nullptr) memory->work += found.work;
        if (found.any) {
            const PlacedPiece::Value there = PlacedPiece(tool[found.piece], pose).at(found.point);
            const glm::dvec3 gradient = unitOr(there.gradient, anyAcross(pose.axis));
            answer = {found.distance, found.point, -gradient, found.piece, normalAt(found)};
            if (memory != nullptr) memory->met[found.piece % memory->met.size()] = found;
            // If they are apart, the whole tool is on one side.
            if (found.distance > 0.0 && glm::dot(gradient, answer.outward) <= 0.0) return answer;
        } else if (!inside && reachesOutside(tool, pose)) {
            return free;
        }
        if (!inside) {
            answer.clearance = std::min(answer.clearance, 0.0);
            answer = deeper(answer, tool, pose, tie, memory);
        }
        if (memory != nullptr) memory->axisFirst = answer.outward == glm::dvec3(0.0);
        return answer.clearance < within ? answer : free;
    }

    bool keeps(std::span<const RevolvedPiece> tool, glm::dvec3 axis, const glm::dvec3& from, const glm::dvec3& to,
               double clearance, ClearanceMemory& memory) const noexcept {
        if (empty() || tool.empty() || !isFinite(from) || !isFinite(to) || !isFinite(axis)) return false;
        axis = unitOr(axis, {0.0, 0.0, 1.0});
        for (std::size_t i = 0; i < tool.size(); ++i)
            if (!(memory.insides[i].spheres.leastRadius > -clearance) ||
                !keepsFromMesh(tree_, tool[i], axis, from, to, clearance))
                return false;
        return std::ranges::all_of(memory.insides, [&](PieceInside& inside) {
            return isOutside(0.5 * (from + to) + inside.spheres.height * axis, inside.centre);
        });
    }

    std::vector<std::uint8_t> entered(std::span<const RevolvedPiece> tool, glm::dvec3 axis,
                                      std::span<const glm::dvec3> tips, double depth, const Progress& progress) const {
        if (empty() || tool.empty() || !isFinite(axis)) return std::vector<std::uint8_t>(tips.size());
        axis = unitOr(axis, {0.0, 0.0, 1.0});
        std::vector<std::uint8_t> entered = enteredTips(tree_, tool, axis, tips, depth, progress);
        parallelIntervals(std::size_t{0}, tips.size(), 1024, [&](std::size_t from, std::size_t to) {
            if (progress.cancelled()) return;
            for (std::size_t i = from; i != to; ++i)
                if (entered[i] == 0 && isFinite(tips[i]) && !reachesOutside(tool, {tips[i], axis})) entered[i] = 1;
        });
        return entered;
    }

private:
    /// Parts of the construction that can run at the same time.
    struct Beginning {
        std::optional<TriangleTree> tree;
        std::vector<std::uint32_t> merged;
        explicit Beginning(const TriangleMesh& mesh) {
            parallelFor(0, 2, [&](int part) {
                if (part == 0)
                    tree.emplace(mesh, finiteTriangles(mesh));
                else
                    merged = firstAtSamePlace(mesh);
            });
        }
    };
    Tree(const TriangleMesh& mesh, Beginning beginning)
        : tree_(std::move(*beginning.tree))
        , rounding_(roundingOf(tree_.bounds()))
        , normals_(mesh, beginning.merged, tree_.order(), rounding_) {}

    ClosestPoint answerTo(const Found& found, const glm::dvec3& point, double within) const noexcept {
        return found.any ? signedAnswer(found, point) : ClosestPoint{point, within, within, 0, glm::dvec3(0.0)};
    }

    ClosestPoint signedAnswer(const Found& found, const glm::dvec3& point) const noexcept {
        const glm::dvec3 outward = normalAt(found);
        const bool inside = glm::dot(point - found.point, outward) < 0.0;
        return {found.point, found.distance, inside ? -found.distance : found.distance, triangleOf(found.slot),
                outward};
    }

    glm::dvec3 normalAt(const Found& found) const noexcept {
        if (const auto normal = normals_.at(tree_.triangles(), found.slot, found.feature)) return *normal;
        return gatheredNormal(found.point);
    }

    /// Where the mesh is not an ordinary surface: the normal of all triangles that touch the point, except for thin
    /// ones if there are others: between those a mesh may be folded by as much as its corners were rounded.
    glm::dvec3 gatheredNormal(const glm::dvec3& point) const noexcept {
        const glm::dvec3 trusted = gatheredNormal(point, 2.0 * rounding_, rounding_);
        if (trusted != glm::dvec3(0.0)) return trusted;
        return gatheredNormal(point, 1e-9 * (1.0 + glm::length(tree_.bounds().size())), 0.0);
    }

    glm::dvec3 gatheredNormal(const glm::dvec3& point, double touching, double thin) const noexcept {
        glm::dvec3 sum(0.0);
        NearPoint near(tree_, point);
        near.limit(touching * touching);
        walk(tree_, near, [&](std::size_t slot) noexcept {
            const Triangle& triangle = tree_.triangles()[slot];
            const TrianglePoint candidate = closestOnTriangle(triangle, point);
            const glm::dvec3 way = candidate.point - point;
            if (glm::dot(way, way) > touching * touching || isThin(triangle, thin)) return;
            sum += surroundingAngle(triangle, candidate.feature) * unitNormal(triangle);
        });
        return sum;
    }

    bool isOutside(const glm::dvec3& place, AxisPoint& last) const noexcept {
        if (last.any && last.nearest.signedDistance > glm::length(place - last.place)) return true;
        last.nearest = closest(place, std::numeric_limits<double>::infinity());
        last.place = place;
        last.any = true;
        return last.nearest.signedDistance > 0.0;
    }

    /// The point of the mesh where the signed distance to a piece is least, below `within`.
    Found deepest(std::span<const RevolvedPiece> tool, const ToolPose& pose, double within,
                  const ClearanceTolerance& tie, ClearanceMemory* memory) const noexcept {
        Found found;
        found.distance = within;
        if (memory == nullptr) {
            for (std::size_t i = 0; i < tool.size(); ++i) meet(PlacedPiece(tool[i], pose), i, tie, found);
            return found;
        }
        startFrom(*memory, tool, pose, tie, found);
        const std::size_t first = found.any ? found.piece : 0; // likely to be the nearest
        for (std::size_t n = 0; n < tool.size(); ++n) {
            const std::size_t i = (first + n) % tool.size();
            PieceBound& bound = memory->pieces[i];
            if (bound.atLeast - bound.movedBy(tool[i], pose) >= found.distance) continue;
            bound = {meet(PlacedPiece(tool[i], pose), i, tie, found), pose};
        }
        return found;
    }

    /// @return mm: except for the point found, nothing is nearer to the piece than this
    double meet(const PlacedPiece& piece, std::size_t number, const ClearanceTolerance& tie,
                Found& found) const noexcept {
        const double deepest =
            -std::min(piece.piece().widestRadius(), 0.5 * (piece.piece().top - piece.piece().bottom));
        if (worthwhile(found.distance, tie) <= deepest) return deepest; // no point is deeper in the piece
        double floor = piece.piece().bottom, passed = std::numeric_limits<double>::infinity();
        if (piece.ballEnd() && piece.piece().top >= floor + 2.0 * piece.piece().cornerRadius) {
            floor += piece.piece().cornerRadius;
            passed = meetBall(piece, number, tie, found);
        }
        passed = std::min(passed, PieceSearch(tree_, normals_, piece, number, floor, tie, found).run());
        return found.piece == number ? std::min(passed, found.distance) : passed;
    }

    /// Starts from what was nearest to a nearby tip, and from points near that which are nearer to this one.
    void startFrom(const ClearanceMemory& memory, std::span<const RevolvedPiece> tool, const ToolPose& pose,
                   const ClearanceTolerance& tie, Found& found) const noexcept {
        for (const Found& met : memory.met) {
            if (!met.any) continue;
            const double distance = PlacedPiece(tool[met.piece], pose).at(met.point).distance;
            if (!(distance < found.distance)) continue;
            found.improve(met);
            found.distance = distance;
        }
        if (!found.any) return;
        const PlacedPiece piece(tool[found.piece], pose);
        PieceSearch(tree_, normals_, piece, found.piece, piece.piece().bottom, tie, found).descend();
    }

    /// What lies below a ball's centre has the same distance to the ball as to its centre less the radius, which is
    /// faster to evaluate. What lies above is not nearer to the ball than to the piece: it is left to the search of the
    /// piece.
    double meetBall(const PlacedPiece& piece, std::size_t number, const ClearanceTolerance& tie,
                    Found& found) const noexcept {
        const double radius = piece.piece().cornerRadius;
        const double reach = worthwhile(found.distance, tie) + radius;
        if (!(reach > 0.0)) return -radius;
        double passed = 0.0;
        Found ball = nearest(piece.pose().tip + (piece.piece().bottom + radius) * piece.pose().axis, reach, &passed);
        found.work += ball.work;
        if (!ball.any) return passed - radius;
        ball.distance = piece.at(ball.point).distance;
        ball.piece = number;
        if (ball.distance < worthwhile(found.distance, tie)) found.improve(ball);
        return std::min(passed - radius, ball.distance);
    }

    /// Whether some point of the tool's axis lies outside the mesh's box, or else outside the mesh.
    bool reachesOutside(std::span<const RevolvedPiece> tool, const ToolPose& pose) const noexcept {
        for (const RevolvedPiece& piece : tool)
            for (const double height : {piece.bottom, piece.top})
                if (!bounds().contains(pose.tip + height * pose.axis)) return true;
        return closest(pose.tip + 0.5 * (tool[0].bottom + tool[0].top) * pose.axis, 1e300).signedDistance >= 0.0;
    }

    /// `answer`, or the depth of a point of the tool's axis in the solid where that is greater.
    ToolClearance deeper(ToolClearance answer, std::span<const RevolvedPiece> tool, const ToolPose& pose,
                         const ClearanceTolerance& tie, ClearanceMemory* memory) const noexcept {
        if (memory != nullptr)
            for (AxisPoint& point : memory->axis) {
                const double before = answer.clearance;
                answer = deeper(answer, pose, tie, point, memory->work);
                if (answer.clearance < before) std::swap(point, memory->axis.front()); // likely to be the deepest again
            }
        else
            visitAxis(tool, [&](double height, std::size_t piece) {
                AxisPoint point{height, piece, {}, {}, false};
                std::uint64_t work = 0;
                answer = deeper(answer, pose, tie, point, work);
            });
        return answer;
    }
    ToolClearance deeper(const ToolClearance& answer, const ToolPose& pose, const ClearanceTolerance& tie,
                         AxisPoint& point, std::uint64_t& work) const noexcept {
        const glm::dvec3 place = pose.tip + point.height * pose.axis;
        if (!bounds().contains(place)) return answer;
        if (point.isShallower(place, -worthwhile(answer.clearance, tie))) return answer;
        const double within = point.any ? glm::length(place - point.nearest.point) * (1.0 + 1e-9) + 1e-9 : 1e300;
        const Found found = nearest(place, within);
        work += found.work;
        point.nearest = answerTo(found, place, within);
        point.place = place;
        point.any = true;
        if (point.nearest.signedDistance >= answer.clearance) return answer;
        return {point.nearest.signedDistance, point.nearest.point, unitOr(point.nearest.point - place, answer.away),
                point.piece, glm::dvec3(0.0)};
    }

    TriangleTree tree_;
    double rounding_; ///< mm
    SurfaceNormals normals_;
};

MeshDistance::MeshDistance(const TriangleMesh& mesh) : tree_(std::make_unique<const Tree>(mesh)) {}
MeshDistance::~MeshDistance() = default;
MeshDistance::MeshDistance(MeshDistance&&) noexcept = default;
MeshDistance& MeshDistance::operator=(MeshDistance&&) noexcept = default;

ClosestPoint MeshDistance::closest(const glm::dvec3& point, double within) const {
    return tree_->closest(point, within);
}

ToolClearance MeshDistance::clearance(std::span<const RevolvedPiece> tool, const ToolPose& pose, double within,
                                      double tolerance) const {
    return tree_->clearance(tool, pose, within, {.ordinary = tolerance}, nullptr);
}

std::vector<std::uint8_t> MeshDistance::entered(std::span<const RevolvedPiece> tool, const glm::dvec3& axis,
                                                std::span<const glm::dvec3> tips, double depth,
                                                const Progress& progress) const {
    return tree_->entered(tool, axis, tips, depth, progress);
}

void MeshDistance::trianglesNear(const glm::dvec3& point, double within, std::vector<std::uint32_t>& numbers) const {
    tree_->trianglesNear(point, within, numbers);
}

ClosestPoint MeshDistance::closestOf(std::span<const std::uint32_t> numbers, const glm::dvec3& point) const noexcept {
    return tree_->closestOf(numbers, point);
}

std::optional<TriangleHit> MeshDistance::hit(const Ray& ray) const noexcept {
    return tree_->hit(ray);
}

Box MeshDistance::bounds() const noexcept {
    return tree_->bounds();
}

std::span<const Triangle> MeshDistance::triangles() const noexcept {
    return tree_->triangles();
}

ClearanceAsker::ClearanceAsker(const MeshDistance& part, std::span<const RevolvedPiece> tool, const glm::dvec3& axis)
    : part_(part), tool_(tool), axis_(axis), memory_(std::make_unique<ClearanceMemory>()) {
    visitAxis(tool, [&](double height, std::size_t piece) { memory_->axis.push_back({height, piece, {}, {}, false}); });
    memory_->pieces.resize(tool.size());
    for (const RevolvedPiece& piece : tool) memory_->insides.push_back({endSpheres(piece), {}});
}
ClearanceAsker::~ClearanceAsker() = default;

std::uint64_t ClearanceAsker::work() const noexcept {
    return memory_->work;
}

bool ClearanceAsker::keeps(const glm::dvec3& from, const glm::dvec3& to, double clearance) noexcept {
    return part_.tree_->keeps(tool_, axis_, from, to, clearance, *memory_);
}

ToolClearance ClearanceAsker::ask(const ToolPose& pose, double within, const ClearanceTolerance& tolerance) noexcept {
    return part_.tree_->clearance(tool_, pose, within, tolerance, memory_.get());
}

} // namespace burin
