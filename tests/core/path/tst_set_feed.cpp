// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/evaluate.h"
#include "tests/core/path/path_fixture.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_set_feed {

using namespace burin::test;

namespace {

constexpr double spindle = 6000.0, feed = 600.0, plunge = 200.0; // the values of the tables

PathContext shop() {
    static const MeshDistance nothing{TriangleMesh{}};
    PathContext context = contextOf(nothing, ballTool(), {{-100, -100, -50}, {100, 100, 0}});
    context.conditions.spindleSpeed = spindle;
    context.conditions.feed = feed;
    context.conditions.plungeFeed = plunge;
    context.machine.name = "Mill";
    context.machine.maximumSpindleSpeed = 10000.0;
    context.machine.maximumFeed = 3000.0;
    context.tool.maximumSpindleSpeed = 0.0;
    return context;
}

Result<EvaluatedPath> fed(const SetFeed& edit, const PathContext& context) {
    return run({takeOf(along({{0, 0, 0}, {20, 0, 0}}, 50.0))}, {{Simplify{}}, {Link{}}, {edit}}, context);
}

double feedOf(const EvaluatedPath& path, MoveKind kind) {
    for (const PathPoint& point : path.path.points)
        if (point.kind == kind) return point.feed;
    return 0.0;
}

} // namespace

class TestSetFeed : public QObject {
    Q_OBJECT
private slots:
    void speedsAndFeedsFollowTheTables_data() {
        QTest::addColumn<double>("speedFactor");
        QTest::addColumn<double>("feedFactor");
        QTest::addColumn<double>("toolsLimit"); // 1/min, 0: none
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("cutting");
        QTest::addColumn<double>("plunging");
        QTest::newRow("as they are") << 1.0 << 1.0 << 0.0 << 6000.0 << 600.0 << 200.0;
        QTest::newRow("slower: the chip stays") << 0.5 << 1.0 << 0.0 << 3000.0 << 300.0 << 100.0;
        QTest::newRow("a thinner chip") << 1.0 << 0.5 << 0.0 << 6000.0 << 300.0 << 100.0;
        QTest::newRow("no faster than the machine") << 2.0 << 1.0 << 0.0 << 10000.0 << 1000.0 << 1000.0 / 3.0;
        QTest::newRow("no faster than the tool") << 2.0 << 1.0 << 7500.0 << 7500.0 << 750.0 << 250.0;
        QTest::newRow("no faster feed than the machine") << 1.0 << 5.0 << 0.0 << 6000.0 << 3000.0 << 1000.0;
    }
    void speedsAndFeedsFollowTheTables() {
        QFETCH(double, speedFactor);
        QFETCH(double, feedFactor);
        QFETCH(double, toolsLimit);
        PathContext context = shop();
        context.tool.maximumSpindleSpeed = toolsLimit;
        SetFeed edit;
        edit.speedFactor = speedFactor;
        edit.feedFactor = feedFactor;
        const auto path = fed(edit, context);
        QVERIFY(path);
        QTEST(path->path.spindleSpeed, "speed");
        QTEST(feedOf(*path, MoveKind::cut), "cutting");
        QTEST(feedOf(*path, MoveKind::plunge), "plunging");
    }

    void coolantIsTheMaterialsAdviceOrTheUsersWord() {
        using Coolants = std::optional<std::vector<Coolant>>;
        const Coolants unknown, none = std::vector<Coolant>{}, floods = std::vector{Coolant::flood};
        struct Row {
            const char* what;
            Coolant advice;
            Coolants machine;
            SetFeed::Cooling wanted;
            std::optional<Coolant> expected; ///< empty: refused
        };
        using enum SetFeed::Cooling;
        for (const Row& row : {Row{"advice", Coolant::flood, floods, advised, Coolant::flood},
                               {"no advice", Coolant::off, floods, advised, Coolant::off},
                               {"advice that can't be had", Coolant::flood, none, advised, Coolant::off},
                               {"a machine of which nothing is known", Coolant::mist, unknown, advised, Coolant::mist},
                               {"dry against advice", Coolant::flood, floods, off, Coolant::off},
                               {"wet against advice", Coolant::off, floods, flood, Coolant::flood},
                               {"a word that can't be kept", Coolant::flood, floods, mist, std::nullopt}}) {
            PathContext context = shop();
            context.advisedCoolant = row.advice;
            context.machine.coolants = row.machine;
            SetFeed edit;
            edit.cooling = row.wanted;
            const auto path = fed(edit, context);
            QVERIFY2(path.hasValue() == row.expected.has_value(), row.what);
            if (path) {
                QVERIFY2(path->path.coolant == *row.expected, row.what);
            } else {
                QCOMPARE(path.error().code, ErrorCode::notSupported);
                QCOMPARE(path.error().subject, std::string("mist coolant for Mill"));
            }
        }
    }
};

BURIN_TEST(TestSetFeed, NoApplication)

} // namespace burin::tst_set_feed

#include "tst_set_feed.moc"
