// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_kernels.h"
#include "core/tool/swept_span.h"
#include "tests/test_program.h"

#include <QtTest>
#include <array>
#include <cstring>
#include <rapidcheck.h>

namespace burin::tst_span_rows {

namespace {

double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

RevolvedPiece randomPiece() {
    const double radius = *rc::gen::element(1.0, 3.0, 12.0, 50.0, 200.0) * real(0.9, 1.1);
    const double corner = *rc::gen::inRange(0, 3) * 0.5;
    const double rounding = corner == 0.5 ? radius * real(0.02, 0.95) : corner * radius;
    return {0.0, rounding + radius * real(0.1, 2.0), radius, radius, rounding};
}

RevolvedPiece grown(const RevolvedPiece& piece, double by) {
    const double corner = piece.cornerRadius == 0.0 ? 0.0 : piece.cornerRadius + by;
    return {piece.bottom - (piece.cornerRadius == 0.0 ? 0.0 : by), piece.top, piece.bottomRadius + by,
            piece.topRadius + by, corner};
}

/// The lines of a row that are needed.
LineInterval reachOf(SpanRows& rows, int v) {
    RowSpans row;
    const LineInterval all{-1000, 1000};
    std::vector<BrickOfSpans> bricks(2001);
    if (rows.intervals(v, 1, all, bricks.data(), &row) == 0) return {};
    return {8 * row.firstGroup, 8 * (row.firstGroup + row.groups) - 1};
}

SpanRows::Shape shapeOf(const SpanRows::Upright& piece) {
    if (piece.cornerRadius == 0.0F) return SpanRows::Shape::flat;
    return piece.flatRadius == 0.0F ? SpanRows::Shape::ball : SpanRows::Shape::bullNose;
}

} // namespace

class SpanRowsTest : public QObject {
    Q_OBJECT

private slots:
    /// The span lies between the exact spans of a smaller and a larger piece, offset by the outline's bound, to one
    /// unit.
    void agreesWithTheExactSpans() {
        const bool held = rc::check("spans", [] {
            const RevolvedPiece piece = randomPiece();
            const double radius = piece.bottomRadius;
            const glm::dvec3 from(real(300, 1500), real(300, 1500), real(200, 1800));
            glm::dvec3 way(real(-1, 1), real(-1, 1), real(-1, 1));
            if (*rc::gen::inRange(0, 4) == 0) way.z = 0.0;
            if (*rc::gen::inRange(0, 6) == 0) way.x = way.y = 0.0;
            SpanRows rows(piece, 2048 * 256);
            way *= *rc::gen::element(0.0, 0.01, 0.3, 1.0, 5.0, 0.57 * rows.longestWay({0, 0, 1}));
            const glm::dvec3 to = from + way;
            rows.begin({from, {0, 0, 1}}, to, true);
            const double by = SpanRows::outlineError * (radius + glm::length(way));
            const SweptPiece smaller(grown(piece, -by), from, to), larger(grown(piece, by), from, to);
            const int v = int(std::floor(from.y + real(-1.05, 1.05) * radius));
            const int first = int(std::floor((std::min(from.x, to.x) - radius) / 8.0)) - 1;
            const int groups = int((2.0 * radius + glm::length(way)) / 8.0) + 4;
            std::vector<BrickOfSpans> bricks(static_cast<std::size_t>(groups));
            rows.spans(std::array{RowSpans{v, first, groups, bricks.data()}});
            const LineInterval reach = reachOf(rows, v);
            for (int i = 0; i < groups * 8; ++i) {
                const int u = first * 8 + i;
                const BrickOfSpans& brick = bricks[std::size_t(i) / 8];
                const double foundLow = brick.low[v & 7][i % 8], foundHigh = brick.high[v & 7][i % 8];
                const std::optional<Span> inner = smaller.along(u, v), outer = larger.along(u, v);
                if (inner) {
                    RC_ASSERT(foundLow < foundHigh);
                    RC_ASSERT(u >= reach.first && u <= reach.last);
                    RC_ASSERT(foundLow <= std::max(inner->low * 256.0, 0.0) + 0.5 + SpanRows::endError);
                    RC_ASSERT(foundHigh >= std::min(inner->high * 256.0, 2048.0 * 256.0) - 0.5 - SpanRows::endError);
                }
                if (foundLow >= foundHigh) continue;
                RC_ASSERT(outer.has_value());
                RC_ASSERT(foundLow >= outer->low * 256.0 - 0.5 - SpanRows::endError);
                RC_ASSERT(foundHigh <= outer->high * 256.0 + 0.5 + SpanRows::endError);
            }
        });
        QVERIFY(held);
    }

    /// The spans of an upright piece, and the lines needed, are bitwise identical on every machine.
    void coversTheSameOnEveryProcessor() {
        const bool held = rc::check("processors", [] {
            RevolvedPiece form = randomPiece();
            if (form.bottomRadius > 60.0) form = {0.0, 90.0, 60.0, 60.0, std::min(form.cornerRadius, 60.0)};
            SpanRows spans(form, 2048 * 256);
            const glm::dvec3 from(real(300, 310), real(300, 310), real(200, 1800));
            glm::dvec3 way(real(-1, 1), real(-1, 1), real(-1, 1));
            if (*rc::gen::inRange(0, 4) == 0) way[*rc::gen::inRange(0, 3)] = 0.0;
            way *= *rc::gen::element(0.01, 0.3, 1.0, 5.0);
            spans.begin({from, {0, 0, 1}}, from + way, *rc::gen::arbitrary<bool>());
            SpanRows::Upright piece = spans.upright();
            // Where the piece rises within the grid and continues, a fully covered line may be reported as covered from
            // the start's upper face on or from farther below: the same for a volume that was cut there already.
            if (!piece.withStart) piece.topRises = false;
            const int first = *rc::gen::inRange(230, 370);
            SpanRows::UprightRows here{}, elsewhere{};
            kernels::planRows(piece, first, here);
            kernels::any_processor::planRows(piece, first, elsewhere);
            RC_ASSERT(std::memcmp(&here, &elsewhere, sizeof here) == 0);

            constexpr int mostGroups = 90; // no piece extends farther
            std::vector<BrickOfSpans> bricks(mostGroups), others(mostGroups);
            std::vector<RowSpans> asked, askedElsewhere;
            for (int row = first; row <= (first | 7); ++row) {
                const int begin = std::max(here.begin[std::size_t(row - first)], 0),
                          end = std::min(here.end[std::size_t(row - first)], mostGroups);
                if (end <= begin || *rc::gen::inRange(0, 6) == 0) continue;
                asked.push_back({row, begin, end - begin, &bricks[std::size_t(begin)]});
                askedElsewhere.push_back({row, begin, end - begin, &others[std::size_t(begin)]});
            }
            kernels::uprightSpans(shapeOf(piece), piece, here, asked);
            kernels::any_processor::uprightSpans(shapeOf(piece), piece, elsewhere, askedElsewhere);
            for (std::size_t i = 0; i < asked.size(); ++i)
                for (int group = 0; group < asked[i].groups; ++group) {
                    const std::ptrdiff_t at = group * RowSpans::pitch;
                    const auto same = [at](const EightIntegers* a, const EightIntegers* b) {
                        return std::memcmp(a + at, b + at, sizeof *a) == 0;
                    };
                    RC_ASSERT(same(asked[i].lows(), askedElsewhere[i].lows()));
                    RC_ASSERT(same(asked[i].highs(), askedElsewhere[i].highs()));
                }
        });
        QVERIFY(held);
    }

    /// A tilted piece: points that some pose of the motion covers by a margin are in the span; points of the span are,
    /// within the bounds, covered by the poses. Compared with signed distances at finely sampled poses.
    void leaningSpansHoldWhatThePosesCover() {
        const bool held = rc::check("leaning spans", [] {
            RevolvedPiece piece = randomPiece();
            if (piece.bottomRadius > 60.0) piece = {0.0, 90.0, 60.0, 60.0, std::min(piece.cornerRadius, 60.0)};
            const double polar = *rc::gen::element(0.001, 0.1, 0.5, 1.2, 1.5707963, 2.5), azimuth = real(0.0, 6.28);
            const glm::dvec3 axis(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                                  std::cos(polar));
            const glm::dvec3 from(real(300, 900), real(300, 900), real(300, 900));
            SpanRows rows(piece, 2048 * 256);
            const double length = *rc::gen::element(0.0, 0.05, 1.0, 0.5) * rows.longestWay(axis);
            const glm::dvec3 way = glm::normalize(glm::dvec3(real(-1, 1), real(-1, 1.01), real(-1, 1))) * length;
            const glm::dvec3 to = from + way;
            rows.begin({from, axis}, to, true);
            const auto nearest = [&](const glm::dvec3& place) {
                double least = 1e9;
                for (int i = 0; i <= 50; ++i) {
                    const glm::dvec3 local = place - (from + way * (i / 50.0));
                    const double height = glm::dot(local, axis);
                    const double radius = std::sqrt(std::max(0.0, glm::dot(local, local) - height * height));
                    least = std::min(least, signedDistance(piece, radius, height));
                }
                return least;
            };
            const double bound = SpanRows::outlineError * (rows.reach() + length) * 4.0 +
                                 (SpanRows::endError + 0.5) / 256.0 + length / 50.0;
            for (int sample = 0; sample < 20; ++sample) {
                const glm::dvec3 middle = from + axis * real(piece.bottom, piece.top);
                const int v = int(std::floor(middle.y + real(-1.1, 1.1) * piece.bottomRadius));
                const int u = int(std::floor(middle.x + real(-1.1, 1.1) * piece.bottomRadius));
                BrickOfSpans brick;
                rows.spans(std::array{RowSpans{v, u >> 3, 1, &brick}});
                const double foundLow = brick.low[v & 7][u & 7] / 256.0, foundHigh = brick.high[v & 7][u & 7] / 256.0;
                if (foundLow < foundHigh) {
                    RC_ASSERT(reachOf(rows, v).first <= u && u <= reachOf(rows, v).last);
                    RC_ASSERT(v >= rows.rows().first && v <= rows.rows().last);
                    for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0})
                        RC_ASSERT(nearest({u, v, foundLow + part * (foundHigh - foundLow)}) <= bound);
                }
                const double z = middle.z + real(-1.5, 1.5) * piece.bottomRadius;
                const bool inSpan = foundLow <= z && z <= foundHigh;
                if (nearest({u, v, z}) < -bound - SpanRows::leaningWayError) RC_ASSERT(inSpan);
            }
        });
        QVERIFY(held);
    }
};

BURIN_TEST(SpanRowsTest, NoApplication)

} // namespace burin::tst_span_rows

#include "tst_span_rows.moc"
