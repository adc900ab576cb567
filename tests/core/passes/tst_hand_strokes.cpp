// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Passes next to strokes of the hand: kept off, blended into, extended.
#include "core/base/units.h"
#include "tests/core/passes/pass_stage.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>
#include <set>

namespace burin::tst_hand_strokes {

using namespace burin::test;

namespace {

constexpr double top = 12.0, half = 15.0, radius = 3.0; // mm: of the block, and of the ball
constexpr double finish = 0.02;                         // mm
const double width = std::sqrt(finish * (2.0 * radius - finish));

/// A block up to a plane that rises along y, with a ball of 6 mm. @param slope rise per mm
struct Plane {
    explicit Plane(double slope = 0.0)
        : rise(slope)
        , ground(blockUnder([slope](double, double y) { return top + slope * y; }, half, 10), endMill(6.0, radius),
                 {{-half, -half, 0.0}, {half, half, top + slope * half + 0.5}}, 0.0) {}

    /// Height of a tip of the ball that rests on the plane, by the closed formula.
    double tipAt(double y) const { return top + rise * y + radius * (std::hypot(1.0, rise) - 1.0); }
    TipLine stroke(double fromX, double toX, double y, double above = 0.0) const {
        return {{fromX, y, tipAt(y) + above}, {toX, y, tipAt(y) + above}};
    }

    double rise;
    Ground ground;
};

PassRequest rowsAcross(HandStrokes hand) {
    PassRequest request;
    request.kind = PassKind::parallel;
    request.direction = 0.5 * pi;
    request.stepOver = 1.0;
    request.area = rectangle({-8.3, -10.0}, {8.3, 10.0});
    request.areaOnPart = true; // no row lies on its border
    request.hand = hand;
    if (hand != HandStrokes::ignore) request.finishedWithin = finish;
    return request;
}

Result<PlannedPass> planned(const Plane& plane, const PassRequest& request, std::vector<TipLine> strokes) {
    PassGround ground = plane.ground.ground;
    ground.handStrokes = std::move(strokes);
    Progress progress;
    return planPass(request, ground, progress);
}

/// How many rows along y cross the line y = 0.
std::size_t rowsOf(const PlannedPass& pass) {
    std::size_t rows = 0;
    for (const TipLine& line : pass.strokes)
        for (std::size_t i = 1; i < line.size(); ++i)
            if ((line[i - 1].y < 0.0) != (line[i].y < 0.0)) ++rows;
    return rows;
}

/// mm, of the tips of a pass from the line y = 0 on a plane, measured on the plane
double nearestTo(const PlannedPass& pass, const Plane& plane) {
    double least = 1e9;
    follow(pass, [&](const glm::dvec3& tip) { least = std::min(least, std::hypot(tip.y, tip.z - plane.tipAt(0.0))); });
    return least;
}

} // namespace

class HandStrokesTest final : public QObject {
    Q_OBJECT

private slots:
    /// Where the balls of pass and hand are 2 w apart, the ridge between them is as high as the finish, and none cuts
    /// what the other one has finished. On a slope the distance is measured along it.
    void rowsKeepOff_data() {
        QTest::addColumn<double>("slope");
        QTest::newRow("level") << 0.0;
        QTest::newRow("30 degrees") << std::tan(pi / 6.0);
    }
    void rowsKeepOff() {
        QFETCH(double, slope);
        const Plane plane(slope);
        QVERIFY(std::abs(radius - std::sqrt(radius * radius - width * width) - finish) < 1e-12); // the ridge
        const Result<PlannedPass> pass =
            planned(plane, rowsAcross(HandStrokes::keepOff), {plane.stroke(-12.0, 12.0, 0.0)});
        QVERIFY(pass);
        const double nearest = nearestTo(*pass, plane);
        QVERIFY2(nearest >= 2.0 * width && nearest < 2.0 * width + 0.006, qPrintable(QString::number(nearest)));
        const Result<PlannedPass> whole = planned(plane, rowsAcross(HandStrokes::ignore), {});
        QVERIFY(whole);
        // On each row; joins between rows lie at their other ends.
        const double left = static_cast<double>(rowsOf(*whole)) * 4.0 * width;
        QVERIFY2(std::abs(pass->leftToHand - left) < 0.02 * left, qPrintable(QString::number(pass->leftToHand)));
    }

    /// A row ends as far over the border as the overlap is long, at the height of what the hand has left: no step.
    void rowsBlendIn() {
        constexpr double above = 0.015, overlap = 0.2;
        const Plane plane;
        PassRequest request = rowsAcross(HandStrokes::blend);
        request.overlap = overlap;
        const Result<PlannedPass> pass = planned(plane, request, {plane.stroke(-12.0, 12.0, 0.0, above)});
        QVERIFY(pass);
        // The tips of the hand lie higher than those of the pass.
        const double border = std::sqrt(width * width - above * above);
        std::size_t ends = 0;
        double nearest = 1e9;
        follow(*pass, [&](const glm::dvec3& tip) { nearest = std::min(nearest, std::abs(tip.y)); });
        QVERIFY2(std::abs(nearest - (border - overlap)) < 0.006, qPrintable(QString::number(nearest)));
        for (const TipLine& line : pass->strokes)
            for (const glm::dvec3& tip : {line.front(), line.back()})
                if (std::abs(tip.y) < 2.0) {
                    ++ends;
                    QVERIFY2(std::abs(tip.z - plane.tipAt(0.0) - above) < 0.001, qPrintable(QString::number(tip.z)));
                }
        const Result<PlannedPass> whole = planned(plane, rowsAcross(HandStrokes::ignore), {});
        QVERIFY(whole);
        QCOMPARE(ends, 2 * rowsOf(*whole));
        follow(*pass, [&](const glm::dvec3& tip) {
            const double share = std::clamp((border - std::abs(tip.y)) / overlap, 0.0, 1.0);
            QVERIFY2(std::abs(tip.z - plane.tipAt(0.0) - above * share) < 0.001, qPrintable(QString::number(tip.z)));
        });
    }

    /// What the hand left too high, or cut with an allowance beside the part, is not finished: rows go on.
    void whatIsNotFinishedIsMilled() {
        const Plane plane;
        for (const HandStrokes hand : {HandStrokes::keepOff, HandStrokes::blend}) {
            const Result<PlannedPass> pass =
                planned(plane, rowsAcross(hand), {plane.stroke(-12.0, 12.0, 0.0, finish + 0.001)});
            const Result<PlannedPass> whole = planned(plane, rowsAcross(HandStrokes::ignore), {});
            QVERIFY(pass && whole);
            QCOMPARE(pass->leftToHand, 0.0);
            QVERIFY(pass->strokes == whole->strokes);
        }
    }

    /// Rows lie beside a straight stroke at multiples of the step-over, to the border of the area.
    void rowsExtendAStroke() {
        constexpr double step = 1.5;
        const Plane plane;
        PassRequest request = rowsAcross(HandStrokes::extend);
        request.kind = PassKind::flow;
        request.areaOnPart = false;
        request.stepOver = step;
        const Result<PlannedPass> pass = planned(plane, request, {plane.stroke(-13.0, 13.0, 0.0)});
        QVERIFY(pass);
        std::set<int> rows;
        double farthest = 0.0;
        for (const TipLine& line : pass->strokes)
            for (std::size_t i = 1; i < line.size(); ++i) {
                if (std::abs(line[i].y - line[i - 1].y) > 0.3) continue; // joins rows
                const double number = line[i].y / step;
                rows.insert(static_cast<int>(std::lround(number)));
                farthest = std::max(farthest, step * std::abs(number - std::round(number)));
            }
        QVERIFY2(farthest < 0.03, qPrintable(QString::number(farthest)));
        QCOMPARE(rows, (std::set<int>{-6, -5, -4, -3, -2, -1, 1, 2, 3, 4, 5, 6}));
        PassRequest without = request;
        const Result<PlannedPass> none = planned(plane, without, {});
        QVERIFY(!none && none.error().code == ErrorCode::argumentInvalid);
    }

    /// Where rows of two strokes meet, no gap is wider than a fifth more than the step-over.
    void rowsOfTwoStrokesMeet() {
        constexpr double step = 1.5;
        const Plane plane;
        for (const double apart : {8.0, 8.7, 9.6, 10.3}) {
            PassRequest request = rowsAcross(HandStrokes::extend);
            request.kind = PassKind::flow;
            request.areaOnPart = false;
            request.stepOver = step;
            const std::vector<TipLine> strokes{plane.stroke(-13.0, 13.0, -0.5 * apart),
                                               plane.stroke(-13.0, 13.0, 0.5 * apart)};
            const Result<PlannedPass> pass = planned(plane, request, strokes);
            QVERIFY(pass);
            std::set<double> crossed{-0.5 * apart, 0.5 * apart}; // on x = 0
            for (const TipLine& line : pass->strokes)
                for (std::size_t i = 1; i < line.size(); ++i)
                    if ((line[i - 1].x < 0.0) != (line[i].x < 0.0)) crossed.insert(line[i].y);
            double widest = 0.0, before = -0.5 * apart;
            for (const double y : crossed) {
                if (y > before && y <= 0.5 * apart + 1e-9) widest = std::max(widest, y - before);
                before = y;
            }
            QVERIFY2(widest <= 1.2 * step, qPrintable(QString("%1: %2").arg(apart).arg(widest)));
        }
    }

    /// For any strokes, on, above and in the part, any kind, choice and allowance.
    void nothingGouges() {
        const auto bumps = [](double x, double y) { return 8.0 + 3.0 * std::sin(0.4 * x) * std::cos(0.3 * y); };
        const Ground ground(blockUnder(bumps, 20.0, 80), endMill(6.0, radius),
                            {{-20.0, -20.0, 0.0}, {20.0, 20.0, 12.0}}, 1.0);
        const std::vector<RevolvedPiece> tool = pieces(ground.tool.cutter);
        QVERIFY(testing::holds("passes beside strokes of the hand never gouge", 5, [&] {
            const auto number = [](int low, int high) { return *rc::gen::inRange(low, high); };
            PassRequest request;
            request.kind = static_cast<PassKind>(
                number(static_cast<int>(PassKind::parallel), static_cast<int>(PassKind::rest) + 1));
            request.hand = static_cast<HandStrokes>(number(1, request.kind == PassKind::flow ? 4 : 3));
            request.allowance = number(0, 2) == 0 ? 0.0 : 0.01 * number(0, 50);
            request.stepOver = 0.01 * number(100, 250);
            request.finishedWithin = 0.001 * number(5, 500);
            if (request.hand == HandStrokes::blend) request.overlap = 0.01 * number(1, 300);
            if (request.hand != HandStrokes::extend)
                request.lines = {{{-20.0, number(-20, 20), 0.0}, {20.0, 3.0, 0.0}}};
            request.area = rectangle({-10.0, -10.0}, {number(0, 12), number(0, 12)});
            PassGround with = ground.ground;
            TipDrop drop(ground.part, tool, request.allowance, 0.0);
            for (int i = 0; i < 3; ++i) {
                TipLine& stroke = with.handStrokes.emplace_back();
                const glm::dvec2 from(number(-12, 12), number(-12, 12)), to(number(-12, 12), number(-12, 12));
                for (int k = 0; k <= 50; ++k) {
                    const glm::dvec2 place = glm::mix(from, to, k / 50.0);
                    stroke.emplace_back(place, drop.at(place).value_or(0.0) + 0.001 * number(-300, 300));
                }
            }
            Progress progress;
            const Result<PlannedPass> pass = planPass(request, with, progress);
            if (!pass) { // no stroke counts
                RC_ASSERT(request.hand == HandStrokes::extend && pass.error().code == ErrorCode::argumentInvalid);
                return;
            }
            double deepest = 0.0;
            follow(*pass, [&](const glm::dvec3& tip) {
                const double clearance = ground.part.clearance(tool, {tip, {0.0, 0.0, 1.0}}, 2.0).clearance;
                deepest = std::max(deepest, request.allowance - clearance);
            });
            RC_ASSERT(deepest <= 0.005); // chords deviate from the surface by 0.002 mm
        }));
    }

    void requestsComeBackAndWrongOnesAreRefused() {
        PassRequest request = rowsAcross(HandStrokes::blend);
        request.overlap = 1.0 / 3.0;
        request.strokesDigest = "0123456789abcdef";
        request.lines = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}}};
        request.leads = {{3, 1}};
        const Result<PassRequest> back = passRequestFromJson(toJson(request), "text");
        QVERIFY(back && *back == request);
        const auto subject = [](PassRequest wrong) {
            const Result<void> valid = validate(wrong);
            return valid ? std::string() : valid.error().subject;
        };
        QCOMPARE(subject(request), std::string());
        PassRequest wrong = request;
        wrong.leads = {{3, 3}};
        QCOMPARE(subject(wrong), std::string("leads"));
        wrong = request;
        wrong.hand = HandStrokes::keepOff;
        QCOMPARE(subject(wrong), std::string("overlap_mm"));
        wrong = request;
        wrong.hand = HandStrokes::ignore;
        wrong.overlap = 0.0;
        QCOMPARE(subject(wrong), std::string("finished_within_mm"));
        wrong = request;
        wrong.kind = PassKind::levels;
        QCOMPARE(subject(wrong), std::string("hand"));
        wrong = rowsAcross(HandStrokes::extend); // parallel rows
        QCOMPARE(subject(wrong), std::string("hand"));
        wrong.kind = PassKind::flow;
        QCOMPARE(subject(wrong), std::string());
    }
};

BURIN_TEST(HandStrokesTest, QCoreApplication)

} // namespace burin::tst_hand_strokes

#include "tst_hand_strokes.moc"
