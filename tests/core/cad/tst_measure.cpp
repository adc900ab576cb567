// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/measure.h"
#include "tests/core/cad/rounded_block.h"
#include "tests/test_program.h"

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>

#include <QCoreApplication>
#include <QtTest>

namespace burin::tst_measure {

namespace {

TopoDS_Shape asSplines(const TopoDS_Shape& shape) {
    return BRepBuilderAPI_NurbsConvert(shape).Shape();
}

/// A ball that protrudes from one side of the block, by 2 mm at (20, 18, 62).
TopoDS_Shape blockWithBall() {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, roundedBlock());
    builder.Add(both, asSplines(BRepPrimAPI_MakeSphere(gp_Pnt(20.0, 18.0, 53.0), 9.0).Shape()));
    return both;
}

} // namespace

class TestMeasure : public QObject {
    Q_OBJECT

private slots:
    /// Neither poles of splines nor tolerances widen it, and no face that extends beyond the others is left out.
    void theBoxIsTight_data() {
        QTest::addColumn<TopoDS_Shape>("shape");
        QTest::addColumn<double>("lowX");
        QTest::addColumn<double>("highX");
        QTest::addColumn<double>("lowZ");
        QTest::addColumn<double>("highZ");
        const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(gp_Ax2({1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}), 5.0, 2.0).Shape();
        QTest::newRow("block with round edges") << roundedBlock() << 0.0 << 40.0 << 0.0 << 60.0;
        QTest::newRow("the same as splines") << asSplines(roundedBlock()) << 0.0 << 40.0 << 0.0 << 60.0;
        QTest::newRow("torus") << torus << -6.0 << 8.0 << 1.0 << 5.0;
        QTest::newRow("torus as splines") << asSplines(torus) << -6.0 << 8.0 << 1.0 << 5.0;
        QTest::newRow("a small face that reaches out") << blockWithBall() << 0.0 << 40.0 << 0.0 << 62.0;
        QTest::newRow("an edge alone")
            << TopoDS_Shape(
                   TopExp_Explorer(BRepPrimAPI_MakeBox(gp_Pnt(1.0, 2.0, 3.0), 1.0, 1.0, 4.0).Shape(), TopAbs_EDGE)
                       .Current())
            << 1.0 << 1.0 << 3.0 << 7.0;
    }
    void theBoxIsTight() {
        QFETCH(TopoDS_Shape, shape);
        QFETCH(double, lowX);
        QFETCH(double, highX);
        QFETCH(double, lowZ);
        QFETCH(double, highZ);
        constexpr double close = 1e-4; // mm
        const Box box = exactBox(shape);
        QVERIFY(std::abs(box.low.x - lowX) < close && std::abs(box.high.x - highX) < close);
        QVERIFY(std::abs(box.low.z - lowZ) < close && std::abs(box.high.z - highZ) < close);
    }
    void volumeAndAreaAreExact() {
        for (const TopoDS_Shape& block : {roundedBlock(), asSplines(roundedBlock())}) {
            QVERIFY(std::abs(exactVolume(block) / roundedVolume - 1.0) < 1e-5);
            QVERIFY(std::abs(exactArea(block) / roundedArea - 1.0) < 1e-5);
        }
    }
};

BURIN_TEST(TestMeasure, QCoreApplication)

} // namespace burin::tst_measure

#include "tst_measure.moc"
