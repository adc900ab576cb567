// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/tool_bounds.h"
#include "tests/core/job/part_milling.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <random>

namespace burin::tst_tool_bounds {

using namespace burin::test;

class TestToolBounds : public QObject {
    Q_OBJECT
    MillingContext milling_ = partMilling(sessionTool());

    Result<BoundaryLayers> layers(const AxisMode& axis, const Surroundings& surroundings = {}) {
        Progress progress;
        return boundaryLayers(milling_, axis, surroundings, 0.5, progress);
    }

private slots:
    void thePartBoundsTheToolWithAnyKindOfAxis_data() {
        QTest::addColumn<bool>("free");
        QTest::addColumn<double>("tilt");
        QTest::newRow("three axes") << false << 0.0;
        QTest::newRow("3+2") << false << 0.6;
        QTest::newRow("free") << true << 0.6;
    }
    void thePartBoundsTheToolWithAnyKindOfAxis() {
        QFETCH(bool, free);
        QFETCH(double, tilt);
        const glm::dvec3 direction(std::sin(tilt), 0.0, std::cos(tilt));
        Result<BoundaryLayers> made = layers({free, direction});
        QVERIFY(made);
        const std::vector<RevolvedPiece> tool = pieces(milling_.tool.cutter);
        const Box tips = milling_.part.bounds().grown(2.0);
        std::mt19937 engine(1);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        int near = 0;
        for (int i = 0; i < 4000; ++i) {
            const ToolPose pose{tips.low + tips.size() * glm::dvec3(share(engine), share(engine), share(engine)),
                                direction};
            const double exact = milling_.part.clearance(tool, pose).clearance;
            const PoseSample sample = made->at(pose, 1.0);
            // The clearance is never larger than the true one, except at the edges of the block: the guarantee of a
            // field for smooth faces.
            if (exact > 0.0) QVERIFY(sample.clearance <= exact + 0.1 * milling_.setup.voxel);
            if (!sample.fine || exact < 0.0 || exact > 0.5) continue;
            ++near;
            QVERIFY(sample.clearance >= exact - 0.25 * milling_.setup.voxel);
        }
        QVERIFY(near > 20);
    }

    void obstaclesAndEnvelopeComeAsLayersAfterIt() {
        Surroundings surroundings;
        Obstacle vise;
        vise.shape = Box{{-100, -100, -100}, {-90, 100, 100}};
        vise.on = false;
        surroundings.obstacles = {vise, vise};
        QCOMPARE(layers({true, {0, 0, 1}}, surroundings)->size(), std::size_t{3});
        surroundings.envelope.tips = {{-200, -200, -200}, {200, 200, 200}};
        const Result<BoundaryLayers> made = layers({true, {0, 0, 1}}, surroundings);
        QCOMPARE(made->size(), std::size_t{4});
        QCOMPARE(made->state(1), BoundaryLayers::State::off);
        QCOMPARE(made->state(3), BoundaryLayers::State::inForce);
    }

    void anAxisThatIsNoDirectionIsRefused() {
        const Result<BoundaryLayers> made = layers({false, {0.0, 0.5, 0.5}});
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(TestToolBounds, QCoreApplication)

} // namespace burin::tst_tool_bounds

#include "tst_tool_bounds.moc"
