// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/imported_mesh.h"
#include "tests/oracles/push_back_scenes.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_push_back_on_parts {

using namespace burin::oracles;

class TestPushBackOnParts : public QObject {
    Q_OBJECT
private slots:
    void noToolEntersAPartOfCad_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("ticks");
        QTest::newRow("a block with pockets") << "pocket-test.stl" << 200;
        QTest::newRow("a freeform cover") << "mouse-cover.stl" << 60;
    }
    void noToolEntersAPartOfCad() {
        QFETCH(QString, file);
        QFETCH(int, ticks);
        const TriangleMesh mesh = tests::importedMesh(file.toLatin1().constData());
        QVERIFY(!mesh.empty());
        const PushBackScene scene = partPushBackScene(file.toStdString(), mesh);
        int touching = 0;
        for (const std::size_t place : {0U, 2U, 4U}) {
            const Tool tool = pushBackTools()[place];
            for (const PushBackAxis axis : {PushBackAxis::freeWithoutTorque, PushBackAxis::freeWithTorque}) {
                PushBackRun run;
                run.axis = axis;
                run.ticks = ticks;
                BoundaryLayers layers = pushBackLayers(scene, tool, axis, run.voxel, 0.5);
                const PushBackFigures figures = measurePushBack(scene, tool, layers, run);
                const double deepest = std::max(figures.gouge, figures.gougeOnTheWay) / run.voxel;
                QVERIFY2(deepest <= edgeGougeLimit, qPrintable(QString::number(deepest)));
                touching += figures.touching;
            }
        }
        QVERIFY(touching > ticks);
    }
};

BURIN_TEST(TestPushBackOnParts, NoApplication)

} // namespace burin::tst_push_back_on_parts

#include "tst_push_back_on_parts.moc"
