// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/swept_span.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/oracles/moved_piece.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_swept_span {

using random::real;

namespace {

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

} // namespace

class SweptSpanTest : public QObject {
    Q_OBJECT

private slots:
    /// The central test: for any piece and any move, a line meets what sampled poses meet.
    void agreesWithSampledPoses() {
        const bool held = rc::check("span of a moved piece", [] {
            const RevolvedPiece piece = random::straightPiece();
            const glm::dvec3 from(real(-5.0, 5.0), real(-5.0, 5.0), real(-5.0, 5.0));
            const glm::dvec3 to = from + random::move();
            const SweptPiece swept(piece, from, to);
            const Box box = swept.bounds();
            for (int line = 0; line < 40; ++line) {
                const double x = real(box.low.x, box.high.x), y = real(box.low.y, box.high.y);
                const oracles::SampledSpan expected = oracles::sampledSpan(piece, from, to, x, y);
                const double room = oracles::outlineOf(piece) - expected.closest;
                if (std::abs(room) < 1e-9) continue; // touching within rounding: either answer is valid
                const std::optional<Span> found = swept.along(x, y);
                RC_ASSERT(found.has_value() == (room > 0.0));
                if (!found) continue;
                RC_ASSERT(near(found->low, expected.low, 1e-6));
                RC_ASSERT(near(found->high, expected.high, 1e-6));
                RC_ASSERT(swept.bottomAlong(x, y) == std::optional(found->low));
                RC_ASSERT(found->low >= box.low.z - 1e-12 && found->high <= box.high.z + 1e-12);
            }
        });
        QVERIFY(held);
    }

    /// A sampled height is never below the exact one: the bull nose's iteration has found the bottom to 1e-9 mm.
    void bullNoseFindsTheLowestPlaceToANanometre() {
        const bool held = rc::check("bull nose", [] {
            const double radius = real(0.5, 8.0);
            const RevolvedPiece piece{0.0, 20.0, radius, radius, radius * real(0.05, 0.95)};
            const glm::dvec3 to(real(0.1, 6.0), real(0.1, 6.0), real(-6.0, 6.0));
            const SweptPiece swept(piece, glm::dvec3(0.0), to);
            const double t = real(0.0, 1.0), across = real(-0.98, 0.98) * radius;
            const glm::dvec2 ahead = glm::normalize(glm::dvec2(to));
            const glm::dvec2 place = glm::dvec2(to) * t + glm::dvec2(-ahead.y, ahead.x) * across;
            const std::optional<Span> found = swept.along(place.x, place.y);
            RC_ASSERT(found.has_value());
            const oracles::SampledSpan expected = oracles::sampledSpan(piece, glm::dvec3(0.0), to, place.x, place.y);
            RC_ASSERT(near(found->low, expected.low, 1e-9));
        });
        QVERIFY(held);
    }

    /// A swept ball is a capsule: closed formula along the motion of its centre.
    void ballIsACapsule() {
        const RevolvedPiece ball{0.0, 20.0, 3.0, 3.0, 3.0};
        const SweptPiece swept(ball, {0.0, 0.0, 0.0}, {4.0, 0.0, 3.0});
        // Below the middle of the motion the lowest point touches the slanted cylinder: 3 / cos of the slope below its
        // axis.
        const std::optional<Span> span = swept.along(2.0, 0.0);
        QVERIFY(span.has_value());
        QVERIFY(near(span->low, 3.0 + 1.5 - 3.0 * 5.0 / 4.0, 1e-12));
        QVERIFY(near(span->high, 20.0 + 3.0, 1e-12));
    }

    void linesThatOnlyTouchMeetNothing_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("side of the way") << 1.0 << 3.0;
        QTest::newRow("other side") << 1.0 << -3.0;
        QTest::newRow("behind the start") << -3.0 << 0.0;
        QTest::newRow("before the end") << 5.0 << 0.0;
        QTest::newRow("beyond") << 5.1 << 0.0;
    }
    void linesThatOnlyTouchMeetNothing() {
        QFETCH(double, x);
        QFETCH(double, y);
        for (const double corner : {0.0, 1.0, 3.0}) {
            const SweptPiece swept({0.0, 10.0, 3.0, 3.0, corner}, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
            QVERIFY(!swept.along(x, y).has_value());
        }
    }

    void verticalMoveIntervalsTheSpan() {
        const RevolvedPiece flat{0.0, 10.0, 3.0, 3.0, 0.0};
        const std::optional<Span> span = SweptPiece(flat, {1.0, 1.0, 2.0}, {1.0, 1.0, -4.0}).along(2.0, 2.0);
        QVERIFY(span.has_value());
        QCOMPARE(span->low, -4.0);
        QCOMPARE(span->high, 12.0);
    }

    /// Two moves that meet in a tip agree there bitwise: the second covers everything that the first left at its end.
    void waysThatMeetAgreeToTheLastBit() {
        const bool held = rc::check("ends of ways", [] {
            const RevolvedPiece piece = random::straightPiece();
            const glm::dvec3 tip(real(-5.0, 5.0), real(-5.0, 5.0), real(-5.0, 5.0));
            const SweptPiece standing(piece, tip, tip), arriving(piece, tip - random::move(), tip);
            const SweptPiece leaving(piece, tip, tip + random::move());
            const double reach = oracles::outlineOf(piece);
            const double x = tip.x + real(-reach, reach), y = tip.y + real(-reach, reach);
            const std::optional<Span> still = standing.along(x, y);
            if (!still) return;
            for (const SweptPiece& way : {arriving, leaving}) {
                const std::optional<Span> moved = way.along(x, y);
                if (!moved && reach - std::hypot(x - tip.x, y - tip.y) < 1e-9) continue;
                RC_ASSERT(moved.has_value());
                RC_ASSERT(moved->low <= still->low && moved->high >= still->high);
            }
        });
        QVERIFY(held);
    }

    /// The shadow contains exactly the lines that are met: processing shadows row by row misses none.
    void shadowHoldsEveryLineThatIsMet() {
        const bool held = rc::check("shadow", [] {
            const RevolvedPiece piece = random::straightPiece();
            const glm::dvec3 from(real(-5.0, 5.0), real(-5.0, 5.0), real(-5.0, 5.0));
            const SweptPiece swept(piece, from, from + random::move());
            const Box box = swept.bounds();
            const double x = real(box.low.x, box.high.x), y = real(box.low.y, box.high.y);
            const std::optional<Span> shadow = swept.shadow(y);
            const bool inside = shadow && x > shadow->low + 1e-9 && x < shadow->high - 1e-9;
            const bool outside = !shadow || x < shadow->low - 1e-9 || x > shadow->high + 1e-9;
            if (inside) RC_ASSERT(swept.along(x, y).has_value());
            if (outside) RC_ASSERT(!swept.along(x, y).has_value());
        });
        QVERIFY(held);
    }
};

BURIN_TEST(SweptSpanTest, NoApplication)

} // namespace burin::tst_swept_span

#include "tst_swept_span.moc"
