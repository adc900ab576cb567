// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/core/cutting/sweeping.h"

#include <QtTest>

#include <random>

using namespace burin;
using namespace burin::tests;

namespace {

/// A solid with a closed formula for its volume, and a way on which it is moved.
struct Solid {
    const char* name;
    RevolvedPiece piece;
    double way = 0.0; ///< mm, across the axis
    double volume = 0.0;
};

const double radius = 2.0, ring = 1.5, tube = 1.0, length = 3.0;

std::vector<Solid> solids() {
    return {
        {"sphere", bulgingPiece(0.0, 2.0 * radius, 0.0, radius, radius), 0.0, 4.0 / 3.0 * pi * std::pow(radius, 3)},
        {"capsule", bulgingPiece(0.0, 2.0 * radius, 0.0, radius, radius), length,
         4.0 / 3.0 * pi * std::pow(radius, 3) + pi * radius * radius * length},
        // The outer half of a torus around a cylinder: pi times the integral of (ring + sqrt(tube² - z²))².
        {"torus", bulgingPiece(0.0, 2.0 * tube, ring, tube, tube), 0.0,
         pi * (2.0 * tube * ring * ring + ring * pi * tube * tube + 4.0 / 3.0 * std::pow(tube, 3))},
        {"cone", {0.0, length, 0.0, radius, 0.0}, 0.0, pi * radius * radius * length / 3.0},
        {"cylinder", {0.0, length, radius, radius, 0.0}, 0.0, pi * radius * radius * length},
    };
}

/// Root mean square of the relative error over places and leans that have nothing to do with the grid.
double errorAt(const Solid& solid, int voxelsPerRadius) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const double edge = radius / voxelsPerRadius;
    const int side = static_cast<int>(std::ceil(16.0 / edge));
    double sum = 0.0;
    constexpr int trials = 12;
    for (int trial = 0; trial < trials; ++trial) {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        const glm::dvec3 across = glm::normalize(glm::cross(axis, glm::dvec3(any(random), any(random), any(random))));
        const glm::dvec3 tip = edge * glm::dvec3(any(random), any(random), any(random));
        const auto runs = static_cast<RunAxis>(trial % 3);
        RunVolume volume = tests::solid(glm::dvec3(-8.0), edge, glm::ivec3(side), runs);
        RunAmounts removed;
        sweep(volume, {&solid.piece, 1}, {tip, tip + solid.way * across, axis}, removed);
        const double found = static_cast<double>(totalOf(removed)) * volume.grid().unitVolume();
        sum += std::pow(found / solid.volume - 1.0, 2);
    }
    return std::sqrt(sum / trials);
}

} // namespace

/// What a tool removes against closed formulas: it gets better as the voxels get finer, at the order that a sum over
/// scanlines has.
class SweptVolumeTest : public QObject {
    Q_OBJECT

private slots:
    void volumesConverge_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < static_cast<int>(solids().size()); ++i)
            QTest::newRow(solids()[static_cast<std::size_t>(i)].name) << i;
    }
    void volumesConverge() {
        QFETCH(int, index);
        const Solid solid = solids()[static_cast<std::size_t>(index)];
        const double coarse = errorAt(solid, 5), middle = errorAt(solid, 10), fine = errorAt(solid, 20);
        const double order = std::log2(coarse / fine) / 2.0;
        qInfo("%s: relative error %.2g, %.2g, %.2g at R = 5, 10, 20 voxels: order %.2f", solid.name, coarse, middle,
              fine, order);
        QVERIFY(coarse < 0.02);
        QVERIFY(middle < coarse && fine < middle);
        QVERIFY2(order > 1.0, qPrintable(QString::number(order)));
    }
};

QTEST_APPLESS_MAIN(SweptVolumeTest)
#include "tst_swept_volume.moc"
