// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/cad/part_edge.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_part_edges {

using namespace burin::test;

namespace {

Result<std::vector<PartEdge>> edgesOf(const Model& model, double chord = 0.005) {
    Progress progress;
    return partEdges(model, chord, options(), progress);
}

bool isClosed(const PartEdge& edge) {
    return glm::distance(edge.points.front(), edge.points.back()) < 1e-6;
}

} // namespace

class PartEdges : public QObject {
    Q_OBJECT

private slots:
    void aCubeHasTwelveStraightOnes() {
        const Result<Model> model = import(modelFile("cube.brep"));
        QVERIFY(model);
        const auto edges = edgesOf(*model);
        QVERIFY2(edges, edges ? "" : describe(edges.error()).c_str());
        QCOMPARE(edges->size(), std::size_t{12});
        for (const PartEdge& edge : *edges) {
            QCOMPARE(edge.points.size(), edge.tangents.size());
            QVERIFY(std::abs(edge.length - 10.0) < 1e-9);
            const glm::dvec3 way = glm::normalize(edge.points.back() - edge.points.front());
            for (const glm::dvec3& tangent : edge.tangents) QVERIFY(glm::distance(tangent, way) < 1e-9);
        }
    }

    void aCylindersAreCirclesWithoutItsSeam() {
        const Result<Model> model = import(modelFile("red-cube-blue-cylinder.step"));
        QVERIFY(model);
        constexpr double chord = 0.002;
        const auto edges = edgesOf(*model, chord);
        QVERIFY2(edges, edges ? "" : describe(edges.error()).c_str());
        QCOMPARE(edges->size(), std::size_t{12 + 2});
        QCOMPARE(std::count_if(edges->begin(), edges->end(), isClosed), std::ptrdiff_t{2});
        for (const PartEdge& edge : *edges) {
            if (!isClosed(edge)) continue;
            glm::dvec3 centre(0.0);
            for (std::size_t i = 1; i < edge.points.size(); ++i) centre += edge.points[i];
            centre /= static_cast<double>(edge.points.size() - 1);
            const double radius = glm::distance(edge.points[0], centre);
            for (std::size_t i = 0; i < edge.points.size(); ++i) {
                QVERIFY(std::abs(glm::distance(edge.points[i], centre) - radius) < 1e-6);
                QVERIFY(std::abs(glm::dot(edge.tangents[i], edge.points[i] - centre)) < 1e-6 * radius);
                if (i == 0) continue;
                const glm::dvec3 middle = 0.5 * (edge.points[i] + edge.points[i - 1]);
                QVERIFY(radius - glm::distance(middle, centre) <= chord);
            }
        }
    }

    void theyLieOnThePart() {
        const Result<Model> model = import(modelFile("lower-leg-fork.step"));
        QVERIFY(model);
        const auto edges = edgesOf(*model);
        QVERIFY2(edges, edges ? "" : describe(edges.error()).c_str());
        QVERIFY(edges->size() > 20);
        std::vector<glm::dvec3> points;
        for (std::size_t i = 0; i < edges->size(); i += 1 + edges->size() / 40)
            points.push_back((*edges)[i].points[(*edges)[i].points.size() / 2]);
        Progress progress;
        const auto distances = exactSignedDistances(*model, points, options(), progress);
        QVERIFY(distances);
        for (const double distance : *distances)
            QVERIFY2(std::abs(distance) < 1e-3, qPrintable(QString::number(distance)));
    }

    void whatIsNoPartIsRefused() {
        Progress progress;
        QCOMPARE(partEdges(withBrep(""), 0.01, options(), progress).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(partEdges(withBrep("rubbish"), 0.01, options(), progress).error().code, ErrorCode::fileDamaged);
        QCOMPARE(partEdges(withBrep("rubbish"), 0.0, options(), progress).error().code, ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(PartEdges, NoApplication)

} // namespace burin::tst_part_edges

#include "tst_part_edges.moc"
