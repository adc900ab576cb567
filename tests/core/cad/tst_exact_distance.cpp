// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/cad/reader/exact_distance.h"
#include "tests/test_program.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

#include <QCoreApplication>
#include <QtTest>

#include <random>
#include <sstream>

namespace burin::tst_exact_distance {

using namespace burin::test;

namespace {

TopoDS_Shape shapeOf(const Model& model) {
    TopoDS_Shape shape;
    std::istringstream stream(model.brep);
    BinTools::Read(shape, stream);
    return shape;
}

std::vector<glm::dvec3> pointsAround(const Box& box, double margin, std::size_t count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<glm::dvec3> points;
    const Box wide = box.grown(margin);
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(wide.low + wide.size() * glm::dvec3(unit(random), unit(random), unit(random)));
    return points;
}

} // namespace

class ExactDistances : public QObject {
    Q_OBJECT

private slots:
    void distancesToACubeFollowItsFormula() {
        const Result<Model> model = import(modelFile("cube.brep"));
        QVERIFY(model);
        const std::vector<glm::dvec3> points = pointsAround(model->box(), 8.0, 300);
        const std::vector<double> measured = distances(*model, points);
        QCOMPARE(measured.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec3 q = glm::abs(points[i] - glm::dvec3(5.0)) - glm::dvec3(5.0);
            const double expected =
                glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
            QVERIFY(std::abs(measured[i] - expected) < 1e-9);
        }
    }

    void distancesAreThoseOfOpenCascadeInFull_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("count");
        QTest::newRow("the sample part") << QString::fromStdString(sampleFile().string()) << 20;
        QTest::newRow("fillets") << QString::fromStdString(modelFile("lower-leg-fork.step").string()) << 10;
        QTest::newRow("freeform cover") << QString::fromStdString(modelFile("mouse-cover.step").string()) << 10;
        QTest::newRow("two solids") << QString::fromStdString(modelFile("red-cube-blue-cylinder.step").string()) << 40;
    }
    void distancesAreThoseOfOpenCascadeInFull() {
        QFETCH(QString, file);
        QFETCH(int, count);
        Progress progress;
        ImportOptions coarse = options();
        coarse.meshChord = 0.5; // the mesh is not used
        const Result<Model> model = importModel(file.toStdString(), coarse, progress);
        QVERIFY(model);
        const TopoDS_Shape shape = shapeOf(*model);
        // A boundary is known only within the tolerance of its edges: there either answer may be the nearer one.
        const double agreement = std::max(1e-6, BRep_Tool::MaxTolerance(shape, TopAbs_EDGE));
        const std::vector<glm::dvec3> points = pointsAround(model->box(), 5.0, static_cast<std::size_t>(count));
        const std::vector<double> measured = distances(*model, points);
        QCOMPARE(measured.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const gp_Pnt point(points[i].x, points[i].y, points[i].z);
            double nearest = 1e300;
            bool inside = false;
            // Solid by solid, using only the surface: OpenCASCADE's distance to a solid is zero inside it.
            for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
                for (TopExp_Explorer shells(solids.Current(), TopAbs_SHELL); shells.More(); shells.Next())
                    nearest = std::min(
                        nearest, BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(point).Vertex(), shells.Current())
                                     .Value());
                BRepClass3d_SolidClassifier classifier(solids.Current(), point, 1e-7);
                inside = inside || classifier.State() == TopAbs_IN;
            }
            QVERIFY2(std::abs(std::abs(measured[i]) - nearest) < agreement,
                     (std::to_string(measured[i]) + " instead of " + std::to_string(nearest)).c_str());
            QVERIFY(nearest < 1e-6 || (measured[i] < 0.0) == inside);
        }
    }

    void withoutABrepThereIsNoExactDistance() {
        Progress progress;
        const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0}};
        const auto none = exactSignedDistances(withBrep(""), points, options(), progress);
        QVERIFY(!none && none.error().code == ErrorCode::argumentInvalid);
        const auto broken = exactSignedDistances(withBrep("no B-rep at all"), points, options(), progress);
        QVERIFY(!broken && errorClass(broken.error().code) == ErrorClass::badInput);
    }
};

BURIN_TEST(ExactDistances, QCoreApplication)

} // namespace burin::tst_exact_distance

#include "tst_exact_distance.moc"
