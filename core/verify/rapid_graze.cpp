// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/rapid_graze.h"

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/tool/swept_span.h"
#include "core/volume/runs/brick_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace burin {

namespace {

constexpr double touch = 0.01;       // mm: less is ignored
constexpr double alongOutline = 0.1; // mm between lines on a rapid's outline
constexpr double leastGraze = 1e-4;  // mm³
constexpr int linesAcross = 4;       // of a voxel, inside the outline

using Pieces = std::vector<RevolvedPiece>;

/// The heights along an upright line that remain of an interval.
class Heights {
public:
    explicit Heights(const Span& all) : left_{all} {}

    void take(const Span& away) {
        next_.clear();
        for (const Span& span : left_) {
            if (away.low > span.low) next_.push_back({span.low, std::min(span.high, away.low)});
            if (away.high < span.high) next_.push_back({std::max(span.low, away.high), span.high});
        }
        std::erase_if(next_, [](const Span& span) { return span.high - span.low < touch; });
        left_.swap(next_);
    }
    bool empty() const noexcept { return left_.empty(); }
    double length() const noexcept {
        double sum = 0.0;
        for (const Span& span : left_) sum += span.high - span.low;
        return sum;
    }
    double middle() const noexcept { return 0.5 * (left_.front().low + left_.front().high); }

private:
    std::vector<Span> left_, next_;
};

/// A move that may have cleared a brick; later ones come last.
struct Clearing {
    const ToolMove* move = nullptr;
    const Pieces* pieces = nullptr; ///< thickened
    std::uint32_t order = 0;        ///< position among all moves
};

/// The moves that reach over each of the bricks in question.
class ClearedBricks {
public:
    ClearedBricks(const std::vector<GrazedLine>& grazed, const Grid& grid) : grid_(grid) {
        for (const GrazedLine& each : grazed) bricks_[keyOf(each.line)];
    }
    void add(const ToolMove& move, const Pieces& pieces, double radius, std::uint32_t order) {
        if (!move.endKnown) return;
        double reach = radius; // in plan
        for (const RevolvedPiece& piece : pieces)
            if (move.tilted()) reach = std::max(reach, std::hypot(piece.top, piece.widestRadius()));
        const glm::dvec3 low = glm::min(move.begin().tip, move.to.tip) - reach,
                         high = glm::max(move.begin().tip, move.to.tip) + reach;
        const double brick = grid_.edge() * brickSide;
        const glm::dvec3 origin = grid_.low();
        const auto at = [&](double place, double from) {
            return static_cast<std::int32_t>(std::floor((place - from) / brick));
        };
        const std::int32_t u0 = at(low.x, origin.x), u1 = at(high.x, origin.x);
        const std::int32_t v0 = at(low.y, origin.y), v1 = at(high.y, origin.y);
        if (static_cast<double>(u1 - u0 + 1) * (v1 - v0 + 1) > static_cast<double>(bricks_.size())) {
            for (auto& [key, list] : bricks_)
                if (key.first >= u0 && key.first <= u1 && key.second >= v0 && key.second <= v1)
                    list.push_back({&move, &pieces, order});
            return;
        }
        for (std::int32_t u = u0; u <= u1; ++u)
            for (std::int32_t v = v0; v <= v1; ++v)
                if (const auto found = bricks_.find({u, v}); found != bricks_.end())
                    found->second.push_back({&move, &pieces, order});
    }
    const std::vector<Clearing>& of(LineIndex line) const { return bricks_.at(keyOf(line)); }

private:
    static std::pair<std::int32_t, std::int32_t> keyOf(LineIndex line) noexcept {
        return {line.u / brickSide, line.v / brickSide};
    }
    const Grid& grid_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Clearing>> bricks_;
};

/// One rapid, judged against what stands when it is made.
class Graze {
public:
    Graze(const ToolMove& rapid, const Pieces& flutes, std::uint32_t order, const ClearedBricks& cleared,
          const Grid& grid, const Box& stock, std::span<const GrazedLine> lines)
        : rapid_(rapid), order_(order), cleared_(cleared), grid_(grid), stock_(stock), lines_(lines) {
        for (const RevolvedPiece& piece : flutes) {
            sweeps_.emplace_back(piece, rapid.begin().tip, rapid.to.tip);
            radius_ = std::max(radius_, piece.widestRadius());
        }
    }

    /// Volume, mm³; sets `place` to where most of it is.
    double volume(glm::dvec3& place) {
        inside();
        outline();
        place = place_;
        return volume_;
    }

private:
    bool isAsked(LineIndex line) const noexcept {
        return std::ranges::binary_search(lines_, std::pair(line.v, line.u), {},
                                          [](const GrazedLine& one) { return std::pair(one.line.v, one.line.u); });
    }
    LineIndex lineAt(double x, double y) const noexcept {
        return {static_cast<std::int32_t>(std::floor((x - grid_.low().x) / grid_.edge())),
                static_cast<std::int32_t>(std::floor((y - grid_.low().y) / grid_.edge()))};
    }
    /// Length of stock that the rapid meets along an upright line, mm.
    double met(LineIndex line, double x, double y, double& height) const {
        if (x < stock_.low.x || x > stock_.high.x || y < stock_.low.y || y > stock_.high.y) return 0.0;
        double sum = 0.0;
        for (const SweptPiece& sweep : sweeps_) {
            const std::optional<Span> span = sweep.along(x, y);
            if (!span) continue;
            const Span within{std::max(span->low + touch, stock_.low.z), std::min(span->high, stock_.high.z)};
            if (within.high - within.low < touch) continue;
            Heights left(within);
            const std::vector<Clearing>& moves = cleared_.of(line);
            auto at = std::ranges::lower_bound(moves, order_, {}, &Clearing::order);
            while (at != moves.begin() && !left.empty()) {
                --at;
                for (const RevolvedPiece& piece : *at->pieces)
                    if (const auto away =
                            SweptPiece(piece, at->move->begin().tip, at->move->to.tip, at->move->middleAxis())
                                .along(x, y))
                        left.take(*away);
            }
            if (left.empty()) continue;
            sum += left.length();
            height = left.middle();
        }
        return sum;
    }
    void add(double amount, const glm::dvec3& place) {
        volume_ += amount;
        if (amount > most_) {
            most_ = amount;
            place_ = place;
        }
    }

    void inside() {
        const double step = grid_.edge() / linesAcross;
        for (const GrazedLine& each : lines_)
            for (int i = 0; i < linesAcross; ++i)
                for (int k = 0; k < linesAcross; ++k) {
                    const double x = grid_.low().x + each.line.u * grid_.edge() + (i + 0.5) * step;
                    const double y = grid_.low().y + each.line.v * grid_.edge() + (k + 0.5) * step;
                    double height = 0.0;
                    const double length = met(each.line, x, y, height);
                    if (length > 0.0) add(length * step * step, {x, y, height});
                }
    }

    /// Examines both sides of the path and the surroundings of its ends, just inside the widest radius of the flutes.
    void outline() {
        const glm::dvec2 from(rapid_.begin().tip), to(rapid_.to.tip);
        const double length = glm::distance(from, to);
        const glm::dvec2 along = length > 0.0 ? (to - from) / length : glm::dvec2(1.0, 0.0);
        const glm::dvec2 across(-along.y, along.x);
        const auto steps = static_cast<std::size_t>(std::ceil(length / alongOutline));
        for (std::size_t i = 0; i <= steps && length > 0.0; ++i) {
            const glm::dvec2 on = glm::mix(from, to, static_cast<double>(i) / static_cast<double>(steps));
            lookFrom(on, across);
            lookFrom(on, -across);
        }
        const auto turns = static_cast<int>(std::ceil(pi * radius_ / alongOutline));
        for (int i = 0; i <= turns; ++i) {
            const double angle = pi * i / turns;
            const glm::dvec2 ahead = std::sin(angle) * along + std::cos(angle) * across;
            lookFrom(to, ahead);
            lookFrom(from, length > 0.0 ? -std::sin(angle) * along + std::cos(angle) * across : -ahead);
        }
    }
    void lookFrom(const glm::dvec2& axis, const glm::dvec2& outward) {
        const glm::dvec2 place = axis + (radius_ - touch) * outward;
        const LineIndex line = lineAt(place.x, place.y);
        if (!isAsked(line)) return;
        double height = 0.0;
        const double length = met(line, place.x, place.y, height);
        if (length > 0.0) add(length * alongOutline * touch, {place, height});
    }

    const ToolMove& rapid_;
    std::uint32_t order_;
    const ClearedBricks& cleared_;
    const Grid& grid_;
    const Box& stock_;
    std::span<const GrazedLine> lines_; ///< of this rapid, by v, then u
    std::vector<SweptPiece> sweeps_;
    double radius_ = 0.0;
    double volume_ = 0.0, most_ = 0.0;
    glm::dvec3 place_{0.0};
};

double widestOf(const Pieces& pieces) {
    double radius = 0.0;
    for (const RevolvedPiece& piece : pieces) radius = std::max(radius, piece.widestRadius());
    return radius;
}

std::vector<Pieces> flutesOf(std::span<const Tool> tools, double thicker) {
    std::vector<Pieces> all;
    for (const Tool& tool : tools) {
        Pieces flutes = flutePieces(tool.cutter);
        if (thicker > 0.0)
            for (RevolvedPiece& piece : flutes) piece = thickened(piece, thicker);
        all.push_back(std::move(flutes));
    }
    return all;
}

} // namespace

RevolvedPiece thickened(const RevolvedPiece& piece, double by) noexcept {
    if (piece.bulges())
        return bulgingPiece(piece.bottom, piece.top, piece.bulgeCentreRadius, piece.bulgeCentreHeight,
                            piece.bulgeRadius + by);
    RevolvedPiece thicker = piece;
    thicker.bottom -= by;
    thicker.bottomRadius += by;
    thicker.topRadius += by;
    if (piece.cornerRadius > 0.0) thicker.cornerRadius += by;
    return thicker;
}

void judgeGrazes(const std::vector<GrazedLine>& grazed, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                 const Grid& grid, const ExactStock& stock, Findings& findings, const Progress& progress) {
    if (grazed.empty()) return;
    std::vector<GrazedLine> lines = grazed;
    const auto key = [](const GrazedLine& one) { return std::tuple(one.move, one.line.v, one.line.u); };
    std::ranges::sort(lines, {}, key);
    const auto same = std::ranges::unique(lines, {}, key);
    lines.erase(same.begin(), same.end());

    const std::vector<Pieces> flutes = flutesOf(tools, 0.0), thick = flutesOf(tools, touch),
                              thickBefore = flutesOf(stock.toolsBefore, touch);
    ClearedBricks cleared(lines, grid);
    std::uint32_t order = 0;
    for (const ToolMove& move : stock.movesBefore)
        cleared.add(move, thickBefore[move.tool], widestOf(thickBefore[move.tool]), order++);
    const std::uint32_t before = order;
    for (const ToolMove& move : moves) cleared.add(move, thick[move.tool], widestOf(thick[move.tool]), order++);

    std::vector<std::span<const GrazedLine>> rapids;
    for (std::size_t at = 0; at < lines.size();) {
        std::size_t end = at + 1;
        while (end < lines.size() && lines[end].move == lines[at].move) ++end;
        rapids.push_back(std::span(lines).subspan(at, end - at));
        at = end;
    }
    struct Touched {
        double volume = 0.0;
        glm::dvec3 place{0.0};
    };
    std::vector<Touched> touched(rapids.size());
    parallelFor(std::size_t{0}, rapids.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        const std::uint32_t number = rapids[i].front().move;
        const ToolMove& rapid = moves[number];
        touched[i].volume = Graze(rapid, flutes[rapid.tool], before + number, cleared, grid, stock.box, rapids[i])
                                .volume(touched[i].place);
    });
    for (std::size_t i = 0; i < rapids.size(); ++i)
        if (touched[i].volume > leastGraze)
            findings.add(FindingKind::rapidInStock, moves[rapids[i].front().move].line, touched[i].place,
                         touched[i].volume);
}

} // namespace burin
