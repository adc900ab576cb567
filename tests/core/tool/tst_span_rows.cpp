// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows.h"
#include "core/tool/swept_span.h"

#include <QtTest>
#include <rapidcheck.h>

using namespace burin;

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

} // namespace

class SpanRowsTest : public QObject {
    Q_OBJECT

private slots:
    /// Between the exact spans of a piece that is smaller and one that is larger by the outline's bound, to one unit.
    void agreesWithTheExactSpans() {
        const bool held = rc::check("spans", [] {
            const RevolvedPiece piece = randomPiece();
            const double radius = piece.bottomRadius;
            const glm::dvec3 from(real(300, 1500), real(300, 1500), real(200, 1800));
            glm::dvec3 way(real(-1, 1), real(-1, 1), real(-1, 1));
            if (*rc::gen::inRange(0, 4) == 0) way.z = 0.0;
            if (*rc::gen::inRange(0, 6) == 0) way.x = way.y = 0.0;
            SpanRows rows(piece, 2048 * 256);
            way *= *rc::gen::element(0.0, 0.01, 0.3, 1.0, 5.0, 0.57 * rows.longestWay());
            const glm::dvec3 to = from + way;
            rows.begin({from, {0, 0, 1}}, to, true);
            const double by = SpanRows::outlineError * (radius + glm::length(way));
            const SweptPiece smaller(grown(piece, -by), from, to), larger(grown(piece, by), from, to);
            const int v = int(std::floor(from.y + real(-1.05, 1.05) * radius));
            const int first = int(std::floor((std::min(from.x, to.x) - radius) / 8.0)) - 1;
            const int groups = int((2.0 * radius + glm::length(way)) / 8.0) + 4;
            std::vector<EightIntegers> low(static_cast<std::size_t>(groups)), high(low.size());
            rows.spans(v, first, groups, low.data(), high.data());
            const LineStretch reach = rows.row(v);
            for (int i = 0; i < groups * 8; ++i) {
                const int u = first * 8 + i;
                const double foundLow = low[std::size_t(i) / 8][i % 8], foundHigh = high[std::size_t(i) / 8][i % 8];
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
};

QTEST_APPLESS_MAIN(SpanRowsTest)
#include "tst_span_rows.moc"
