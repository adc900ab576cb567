// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/volume/operations/moments.h"
#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_moments {

using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

double largest(const glm::dmat3& matrix) {
    double most = 0.0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(matrix[i][k]));
    return most;
}
bool close(const glm::dmat3& a, const glm::dmat3& b, double share) {
    return largest(a - b) <= share * std::max(largest(a), largest(b));
}

/// Moments of a box, from its formulas.
BodyMoments boxMoments(const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 size = high - low;
    BodyMoments body;
    body.volume = size.x * size.y * size.z;
    body.centroid = 0.5 * (low + high);
    for (int i = 0; i < 3; ++i) body.secondMoments[i][i] = body.volume * size[i] * size[i] / 12.0;
    return body;
}

/// Sums over every 1/256 voxel as a box of its own, about a centroid that is computed first: the definition, step by
/// step.
BodyMoments denseMoments(const DenseGrid& dense, const Grid& grid, PropertyIndex property) {
    const auto each = [&](auto&& visit) {
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                for (RunPosition unit = 0; unit < grid.lineEnd(); ++unit) {
                    if (dense.at(line, unit) != property) continue;
                    const glm::dvec2 across = grid.lineCentre(line);
                    glm::dvec3 place;
                    place[grid.axisOfU()] = across.x;
                    place[grid.axisOfV()] = across.y;
                    place[grid.axisOfRuns()] = 0.5 * (grid.toMillimetres(unit) + grid.toMillimetres(unit + 1));
                    visit(place);
                }
    };
    BodyMoments body;
    glm::dvec3 sum(0.0);
    double count = 0.0;
    each([&](const glm::dvec3& place) {
        sum += place;
        count += 1.0;
    });
    if (count == 0.0) return body;
    const double edge = grid.edge(), unit = grid.unitVolume();
    body.volume = count * unit;
    body.centroid = sum / count;
    glm::dvec3 own(edge * edge / 12.0);
    own[grid.axisOfRuns()] /= double{unitsPerVoxel} * unitsPerVoxel;
    each([&](const glm::dvec3& place) {
        const glm::dvec3 way = place - body.centroid;
        body.secondMoments += unit * glm::outerProduct(way, way);
        for (int i = 0; i < 3; ++i) body.secondMoments[i][i] += unit * own[i];
    });
    return body;
}

} // namespace

class TestMoments : public QObject {
    Q_OBJECT

private slots:
    void aBoxHasThoseOfItsFormulas_data() {
        QTest::addColumn<int>("axis");
        for (int axis = 0; axis < 3; ++axis) QTest::addRow("runs along %d", axis) << axis;
    }
    void aBoxHasThoseOfItsFormulas() {
        QFETCH(int, axis);
        const Grid grid = *Grid::make({-3.0, 5.0, 1000.0}, 0.25, {30, 40, 50}, static_cast<RunAxis>(axis));
        RunVolume volume = emptyVolume(grid);
        QVERIFY(volume.fillBlock({3, 5}, {17, 29}, 700, 5001, wax));
        glm::dvec3 low, high;
        low[grid.axisOfU()] = grid.low()[grid.axisOfU()] + 3 * 0.25;
        high[grid.axisOfU()] = grid.low()[grid.axisOfU()] + 17 * 0.25;
        low[grid.axisOfV()] = grid.low()[grid.axisOfV()] + 5 * 0.25;
        high[grid.axisOfV()] = grid.low()[grid.axisOfV()] + 29 * 0.25;
        low[grid.axisOfRuns()] = grid.toMillimetres(700);
        high[grid.axisOfRuns()] = grid.toMillimetres(5001);
        const BodyMoments expected = boxMoments(low, high), found = moments(volume.snapshot()).byProperty[wax];
        QVERIFY(std::abs(found.volume - expected.volume) <= 1e-13 * expected.volume);
        QVERIFY(glm::length(found.centroid - expected.centroid) < 1e-11);
        QVERIFY(close(found.secondMoments, expected.secondMoments, 1e-12));
        const double mass = expected.volume;
        const glm::dvec3 size = high - low;
        QVERIFY(std::abs(found.inertia()[2][2] - mass * (size.x * size.x + size.y * size.y) / 12.0) < 1e-10 * mass);
    }

    void aBallsConvergeWithTheVoxel() {
        constexpr double radius = 4.3;
        const glm::dvec3 centre(6.07, 5.91, 6.23);
        const double volume = 4.0 / 3.0 * pi * radius * radius * radius, second = volume * radius * radius / 5.0;
        double before = 0.0;
        for (const int voxels : {24, 48, 96, 192}) {
            RunVolume ball = emptyVolume(cubeGrid({voxels, voxels, voxels}, RunAxis::y, 12.0 / voxels));
            fillSphere(ball, aluminium, centre, radius);
            const BodyMoments found = moments(ball.snapshot()).byProperty[aluminium];
            const double off = std::abs(found.secondMoments[0][0] / second - 1.0) +
                               std::abs(found.secondMoments[1][1] / second - 1.0) +
                               std::abs(found.secondMoments[2][2] / second - 1.0) +
                               std::abs(found.volume / volume - 1.0);
            qInfo("%d voxels: second moments and volume %.2e off, centroid %.2e mm", voxels, off,
                  glm::length(found.centroid - centre));
            // With an eighth of the voxel, second order would be a 64th.
            if (voxels == 192) QVERIFY(off < before / 32.0);
            if (voxels == 24) before = off;
            QVERIFY(glm::length(found.centroid - centre) < 0.02 * 12.0 / voxels);
        }
    }

    void theyAreThoseOfEveryUnit() {
        QVERIFY(rc::check("moments by property against unit by unit", [] {
            const auto axis = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
            const Grid grid = *Grid::make({-100.5, 3.0, 7.25}, 0.5, {3, 4, 3}, axis);
            RunVolume volume = emptyVolume(grid, std::size_t{1} << 20);
            DenseGrid dense(grid);
            const int runs = *rc::gen::inRange(0, 25);
            for (int i = 0; i < runs; ++i) {
                const LineIndex line{*rc::gen::inRange(0, grid.lineCountU()), *rc::gen::inRange(0, grid.lineCountV())};
                const auto from = *rc::gen::inRange<RunPosition>(0, grid.lineEnd());
                const auto to = from + *rc::gen::inRange<RunPosition>(0, 600);
                const auto property = *rc::gen::inRange<PropertyIndex>(0, 4);
                RC_ASSERT(volume.fillSpan(line, from, to, property));
                dense.fillSpan(line, from, to, property);
            }
            const VolumeMoments found = moments(volume.snapshot());
            RC_ASSERT(found.byProperty.size() == std::size_t{4});
            double total = 0.0;
            glm::dvec3 first(0.0);
            for (const PropertyIndex property : {wax, aluminium, part}) {
                const BodyMoments expected = denseMoments(dense, grid, property), &is = found.byProperty[property];
                RC_ASSERT(std::abs(is.volume - expected.volume) <= 1e-12);
                if (expected.volume == 0.0) continue;
                RC_ASSERT(glm::length(is.centroid - expected.centroid) < 1e-9);
                RC_ASSERT(close(is.secondMoments, expected.secondMoments, 1e-9));
                total += is.volume;
                first += is.volume * is.centroid;
            }
            RC_ASSERT(found.byProperty[airProperty].volume == 0.0);
            RC_ASSERT(std::abs(found.material.volume - total) <= 1e-12);
            if (total > 0.0) RC_ASSERT(glm::length(found.material.centroid - first / total) < 1e-9);
        }));
    }

    void theLargestGridDoesNotOverflow() {
        RunVolume volume = emptyVolume(*Grid::make(glm::dvec3(0.0), 0.01, {32768, 16, 32768}));
        QVERIFY(volume.fillBlock({32760, 0}, {32768, 16}, 0, 32768 * 256, wax));
        const BodyMoments expected = boxMoments({327.6, 0.0, 0.0}, {327.68, 0.16, 327.68});
        const BodyMoments found = moments(volume.snapshot()).material;
        QVERIFY(glm::length(found.centroid - expected.centroid) < 1e-9);
        QVERIFY(close(found.secondMoments, expected.secondMoments, 1e-10));
        QVERIFY(std::abs(found.secondMoments[0][0] / expected.secondMoments[0][0] - 1.0) < 1e-9);
    }
};

BURIN_TEST(TestMoments, NoApplication)

} // namespace burin::tst_moments

#include "tst_moments.moc"
