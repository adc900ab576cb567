// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/stud_thread_pass.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/upright_holes.h"
#include "core/passes/hole_order.h"
#include "core/passes/thread_size.h"
#include "core/passes/thread_stroke.h"
#include "core/passes/thread_tooth.h"
#include "core/passes/tip_drop.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>

namespace burin {

namespace {

constexpr double sameStud = 0.02;     // mm between the diameters of a stud and of the thread's root
constexpr double besideCrests = 0.5;  // mm between the crests and the tool where it comes down
constexpr double aboveShoulder = 0.1; // mm between the tool and what the part has around a stud
constexpr double aboveStock = 1.0;    // mm above the standing stock where a stroke begins
constexpr double unmilled = 0.15;     // mm: less stock around a stud is ignored, as at the bottom of a hole
constexpr double contact = 1e-3;      // mm
constexpr double mostPitches = 4.0;   // of a stated top above its stud, at most
constexpr double rounding = 0.01;     // mm: the limits of the top are stated in hundredths
constexpr int lookAngles = 24;        // round a stud
// Of the diameter of the stud in the stock, compared to the thread's: wider, narrower (of the pitch), and what the
// squares of the stock hide (of their edge).
constexpr double mostWider = 0.1, narrowerShare = 0.2, rasterShare = 0.2;

/// A stud to thread, mm.
struct ThreadStud {
    UprightHole stud;
    double low = 0.0, high = 0.0; ///< lowest and highest tip on the helix
    double angle = 0.0;           ///< rad, where the tool is led onto the helix
};

class StudThreadPlanner {
public:
    StudThreadPlanner(const PassRequest& request, const PassGround& ground, const ThreadTooth& tooth,
                      Progress& progress)
        : request_(request)
        , ground_(ground)
        , progress_(progress)
        , tooth_(tooth)
        , depth_(externalDepth(request.pitch, tooth.flat))
        , leadRadius_(0.5 * (depth_ + besideCrests))
        , tool_(pieces(ground.tool.cutter))
        , flutes_(flutePieces(ground.tool.cutter))
        , anticlockwise_(request.conventional)
        , up_(request.conventional != request.leftHand) {
        for (std::size_t i = 0; i < tool_.size(); ++i)
            if (sectionOf(ground.tool.cutter, i) != ToolSection::holder) belowHolder_.push_back(tool_[i]);
    }

    Result<PlannedPass> plan() {
        const Result<std::vector<UprightHole>> studs = requestedStuds();
        if (!studs) return studs.error();
        std::vector<glm::dvec2> places;
        for (const UprightHole& stud : *studs) places.push_back(stud.centre);
        double done = 0.0;
        for (const std::size_t i : shortestOrder(places)) {
            progress_.report(done++ / static_cast<double>(studs->size()));
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
            if (const std::optional<ThreadStud> stud = placed((*studs)[i]))
                addThread(strokeAround(*stud), tool_, ground_.obstacles, progress_, planned_);
        }
        return std::move(planned_);
    }

private:
    double rootDiameter() const noexcept { return request_.majorDiameter - 2.0 * depth_; }
    bool isOfThread(const UprightHole& stud) const noexcept {
        return std::abs(2.0 * stud.radius - rootDiameter()) <= sameStud;
    }

    Result<std::vector<UprightHole>> requestedStuds() const {
        const std::vector<UprightHole> all = uprightStuds(ground_.part.triangles());
        std::vector<UprightHole> ofThread, wanted;
        std::ranges::copy_if(all, std::back_inserter(ofThread), [&](const auto& stud) { return isOfThread(stud); });
        if (request_.places.empty())
            for (const UprightHole& stud : ofThread) {
                if (!request_.area.empty() && !holds(request_.area, stud.centre)) continue;
                if (Result<void> fit = checkFit(stud, stud.centre); !fit) return fit.error();
                wanted.push_back(stud);
            }
        for (const glm::dvec2& place : request_.places) {
            const UprightHole* around = holeAround(ofThread, place); // it may stand on a wider one
            if (around == nullptr) around = holeAround(all, place);
            if (around == nullptr) return wrong(place, "a round upright stud of the part");
            if (Result<void> fit = checkFit(*around, place); !fit) return fit.error();
            const auto same = [&](const UprightHole& stud) {
                return stud.centre == around->centre && stud.radius == around->radius;
            };
            if (std::ranges::none_of(wanted, same)) wanted.push_back(*around);
        }
        return wanted;
    }
    static Error wrong(const glm::dvec2& place, std::string allowed) {
        return {ErrorCode::argumentInvalid, "places_mm", formatShortest(place.x) + ", " + formatShortest(place.y),
                std::move(allowed)};
    }
    Result<void> checkFit(const UprightHole& stud, const glm::dvec2& place) const {
        if (request_.majorDiameter > 0.0 && !isOfThread(stud))
            return wrong(place, "a stud modelled with the minor diameter that this mill cuts, " +
                                    formatFixed(rootDiameter(), 2) + " mm, not with " +
                                    formatFixed(2.0 * stud.radius, 2) + " mm");
        // A stated top far above a stud would make a helix without end in the air.
        const double highest = stud.top + mostPitches * request_.pitch;
        if (!request_.top || (*request_.top > stud.bottom && *request_.top < highest + rounding)) return {};
        return Error{ErrorCode::argumentInvalid, "top_mm", formatShortest(*request_.top),
                     "above " + formatFixed(stud.bottom, 2) + " and at most " + formatFixed(highest, 2) +
                         " mm for the stud at " + formatFixed(stud.centre.x, 2) + ", " + formatFixed(stud.centre.y, 2)};
    }

    double helixRadius(const UprightHole& stud) const noexcept { return stud.radius + tooth_.radius; }
    static glm::dvec2 at(const UprightHole& stud, double angle, double distance) noexcept {
        return stud.centre + distance * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    /// How far the tip leaves the height of the helix on its way to and from it, mm.
    double leadHeight(double radius) const noexcept {
        return request_.pitch * std::asin(leadRadius_ / (radius + leadRadius_)) / (2.0 * pi);
    }

    /// The heights between which the tip moves around a stud; empty if it has no room there, which is counted.
    std::optional<ThreadStud> placed(const UprightHole& stud) {
        const double half = 0.5 * request_.pitch, top = request_.top.value_or(stud.top);
        const double lead = leadHeight(helixRadius(stud));
        const auto tipFor = [&](double crest) { return crest - tooth_.height; };
        double wanted = tipFor(stud.bottom - half), needed = tipFor(stud.bottom);
        const bool isStated = request_.depth > 0.0 || request_.bottom;
        if (isStated) wanted = needed = request_.bottom ? *request_.bottom + lead : tipFor(top - request_.depth);
        const double floor = wanted - lead - aboveShoulder;
        const double angle = roomiestAngle(stud, floor);
        const double crests = stud.top - neckLength(ground_.tool.cutter, depth_); // nothing but the tooth cuts them
        const double part = std::max(restingTip(stud, angle, floor, tool_) + aboveShoulder, crests) + lead;
        const auto reached = [&] { return restingTip(stud, angle, floor, flutes_) + aboveShoulder + lead; };
        const double limit = isStated ? needed : stud.bottom + request_.pitch + aboveShoulder + lead;
        if (part > limit + contact || (part > needed && part > reached() + contact)) return unreached();
        wanted = std::max(wanted, part);
        needed = std::max(needed, part);
        const double middle = 0.5 * (needed + tooth_.height + top);
        if (needed + half > top + half - tooth_.height) return unreached();
        if (!isMilled(stud, middle, needed)) return std::nullopt;
        const double stock = stockAround(stud, angle);
        if (stock > needed + unmilled) return notMilled(needed, 2.0 * helixRadius(stud), majorOf(stud));
        const double low = std::max(wanted, std::min(stock + lead, needed));
        const double turns = std::ceil((top + half - tooth_.height - low) / request_.pitch - 1e-9);
        return ThreadStud{stud, low, low + turns * request_.pitch, angle};
    }
    double majorOf(const UprightHole& stud) const noexcept { return 2.0 * (stud.radius + depth_); }
    std::nullopt_t unreached() {
        ++planned_.unreachedHoles;
        return std::nullopt;
    }
    std::nullopt_t notMilled(double needed, double stands, double allowed) {
        planned_.neededDrilling = planned_.unmilledStud ? std::min(planned_.neededDrilling, needed) : needed;
        if (!planned_.unmilledStud) planned_.unmilledStud = {stands, allowed};
        return unreached();
    }

    /// Where the tool is led onto the helix: the part stops it lowest there.
    double roomiestAngle(const UprightHole& stud, double floor) const {
        TipDrop drop(ground_.part, tool_, 0.0, floor);
        double best = 0.0, lowest = 0.0;
        for (int i = 0; i < lookAngles; ++i) {
            const double angle = 2.0 * pi * i / lookAngles;
            const double tip = drop.at(at(stud, angle, helixRadius(stud) + 2.0 * leadRadius_)).value_or(floor);
            if (i > 0 && tip >= lowest) continue;
            best = angle;
            lowest = tip;
        }
        return best;
    }
    /// The lowest tip at which the part is clear of some pieces of the tool, all round the helix and where the tool is
    /// led onto it, mm. The tooth itself touches the corners of the stud.
    double restingTip(const UprightHole& stud, double angle, double floor,
                      std::span<const RevolvedPiece> pieces) const {
        TipDrop drop(ground_.part, pieces, 0.0, floor);
        const double radius = helixRadius(stud) + drillFit;
        double lowest = floor;
        const auto look = [&](const glm::dvec2& place) { lowest = std::max(lowest, drop.at(place).value_or(floor)); };
        for (int i = 0; i < lookAngles; ++i) look(at(stud, 2.0 * pi * i / lookAngles, radius));
        const glm::dvec2 middle = at(stud, angle, radius + leadRadius_);
        for (int i = 0; i < lookAngles; ++i) {
            const double turn = 2.0 * pi * i / lookAngles;
            look(middle + leadRadius_ * glm::dvec2(std::cos(turn), std::sin(turn)));
        }
        return lowest;
    }

    template <class Visit>
    void visitStock(const UprightHole& stud, double reach, Visit&& visit) const {
        const StandingStock& standing = ground_.standing;
        const double edge = standing.edge;
        const glm::dvec2 home = glm::floor((stud.centre - standing.low) / edge) + 0.5;
        const double count = std::ceil(reach / edge);
        for (double v = -count; v <= count; v += 1.0)
            for (double u = -count; u <= count; u += 1.0) {
                const glm::dvec2 middle = standing.low + edge * (home + glm::dvec2(u, v));
                const double far = glm::distance(middle, stud.centre);
                if (far <= reach) visit(middle, far, standing.highestIn(middle, middle));
            }
    }
    /// Whether the stud has the thread's major diameter in the stock, by the squares that stand; counts it otherwise.
    bool isMilled(const UprightHole& stud, double height, double needed) {
        const double allowed = majorOf(stud), edge = ground_.standing.edge;
        double area = 0.0;
        if (!ground_.standing.heights.empty())
            visitStock(stud, helixRadius(stud), [&](const glm::dvec2&, double far, double stands) {
                if (far <= stud.radius || stands > height) area += edge * edge;
            });
        const double diameter = ground_.standing.heights.empty() ? 2.0 * helixRadius(stud) : 2.0 * std::sqrt(area / pi);
        const double hidden = rasterShare * edge;
        if (diameter <= allowed + mostWider + hidden && diameter >= allowed - narrowerShare * request_.pitch - hidden)
            return true;
        notMilled(needed, diameter, allowed);
        return false;
    }
    /// The lowest tip at which flutes and shank are clear of the stock around a stud, on the helix and where they are
    /// led onto it, mm. Squares that the crests may cut don't count.
    double stockAround(const UprightHole& stud, double angle) const {
        const double edge = ground_.standing.edge, radius = helixRadius(stud);
        const double crests = stud.radius + depth_ + mostWider + std::sqrt(0.5) * edge;
        const glm::dvec2 out(std::cos(angle), std::sin(angle));
        double lowest = -farthestInPlan;
        visitStock(stud, radius + 2.0 * leadRadius_ + tooth_.radius,
                   [&](const glm::dvec2& middle, double far, double stands) {
                       if (far <= crests || stands == WorkpieceHeights::nothing) return;
                       const double along =
                           std::clamp(glm::dot(middle - stud.centre, out), radius, radius + 2.0 * leadRadius_);
                       const double lead = glm::distance(middle, stud.centre + along * out);
                       lowest = std::max(lowest, stands - toolAt(std::min(std::abs(far - radius), lead)));
                   });
        return lowest;
    }
    /// The height above the tip from which on the tool is at least as wide as a distance from its axis, mm.
    double toolAt(double distance) const noexcept {
        double lowest = farthestInPlan;
        for (const RevolvedPiece& piece : belowHolder_)
            if (const std::optional<HeightRange> range = heightsAt(piece, distance))
                lowest = std::min(lowest, range->low);
        return lowest;
    }

    ThreadStroke strokeAround(const ThreadStud& place) const {
        const UprightHole& stud = place.stud;
        const double clear =
            std::max(ground_.stock.high.z, place.high + leadHeight(helixRadius(stud)) + tooth_.height) + aboveStock;
        const int passes = request_.radialPasses + (request_.springPass ? 1 : 0);
        const auto radiusOf = [&](int pass) {
            const double share = std::sqrt(std::min(1.0, static_cast<double>(pass) / request_.radialPasses));
            return helixRadius(stud) + depth_ * (1.0 - share);
        };
        ThreadStroke stroke;
        stroke.add({at(stud, place.angle, radiusOf(1) + 2.0 * leadRadius_), clear}, 0.0);
        for (int pass = 1; pass <= passes; ++pass) addTurns(stroke, place, radiusOf(pass));
        stroke.add({at(stud, place.angle, radiusOf(passes) + 2.0 * leadRadius_), clear}, 0.0);
        return stroke;
    }

    /// Beside the stud to the start, half a circle onto the helix, along it, and half a circle away from it.
    void addTurns(ThreadStroke& stroke, const ThreadStud& place, double radius) const {
        const double turn = anticlockwise_ ? 1.0 : -1.0, rise = up_ ? 1.0 : -1.0;
        const double begin = up_ ? place.low : place.high, height = place.high - place.low;
        const double sweep = 2.0 * pi * height / request_.pitch, share = radius / (radius - tooth_.radius);
        const glm::dvec2 out(std::cos(place.angle), std::sin(place.angle)), side(-out.y, out.x);
        const double outside = radius + 2.0 * leadRadius_;
        stroke.add({at(place.stud, place.angle, outside), begin}, 0.0);
        // On the half circles the height follows the angle about the stud, which goes to and fro.
        const auto addLead = [&](double from, double start) {
            const int steps = threadSteps(pi, leadRadius_);
            for (int i = 1; i <= steps; ++i) {
                const double around = from + pi * i / steps;
                const double along = radius + leadRadius_ * (1.0 + std::cos(around));
                const double aside = -leadRadius_ * std::sin(around); // with the helix
                const double behind = std::atan2(aside, along);
                stroke.add({place.stud.centre + along * out + turn * aside * side,
                            start + rise * request_.pitch * behind / (2.0 * pi)},
                           1.0);
            }
        };
        addLead(0.0, begin);
        const int steps = threadSteps(sweep, radius);
        for (int i = 1; i <= steps; ++i) {
            const double done = static_cast<double>(i) / steps;
            stroke.add({at(place.stud, place.angle + turn * sweep * done, radius), begin + rise * height * done},
                       share);
        }
        addLead(pi, begin + rise * height);
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    ThreadTooth tooth_;
    double depth_;      ///< mm, of the thread
    double leadRadius_; ///< mm, of the half circles that lead onto the helix and off
    std::vector<RevolvedPiece> tool_, flutes_, belowHolder_;
    bool anticlockwise_, up_; ///< direction of the tool on the helix, seen from above
    PlannedPass planned_;
};

} // namespace

Result<PlannedPass> planStudThreads(const PassRequest& request, const PassGround& ground, Progress& progress) {
    const Result<ThreadTooth> tooth = externalThreadTooth(ground.tool.cutter, request.pitch);
    if (!tooth) return tooth.error();
    return StudThreadPlanner(request, ground, *tooth, progress).plan();
}

} // namespace burin
