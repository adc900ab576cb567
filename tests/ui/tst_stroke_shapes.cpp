// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "ui/input/stroke_shapes.h"

#include <QTest>

#include <rapidcheck.h>

#include <cmath>

namespace burin::tst_stroke_shapes {

namespace {

double anyNumber(int low, int high) { // in steps of a hundredth
    return 0.01 * *rc::gen::inRange(low, high);
}
glm::dvec3 anyPlace() {
    return {anyNumber(-10000, 10000), anyNumber(-10000, 10000), anyNumber(-500, 500)};
}

/// Rows parallel to the longer side, back and forth, from edge to edge, none missing and none superfluous.
void checkRows() {
    const glm::dvec3 corner = anyPlace(), opposite = anyPlace();
    const double stepOver = anyNumber(5, 3000);
    const std::vector<glm::dvec3> ends = rasterRows(corner, opposite, stepOver);
    const bool alongX = std::abs(opposite.x - corner.x) >= std::abs(opposite.y - corner.y);
    const int along = alongX ? 0 : 1, across = alongX ? 1 : 0;
    const double width = std::abs(opposite[across] - corner[across]);
    RC_ASSERT(ends.size() >= 2 && ends.size() % 2 == 0);
    const std::size_t rows = ends.size() / 2;
    RC_ASSERT(ends.front() == corner);
    RC_ASSERT(std::abs(ends.back()[across] - (rows > 1 ? opposite[across] : corner[across])) < 1e-9);
    const bool fewest = rows == 1 ? width < 1e-3 : static_cast<double>(rows - 2) * stepOver < width;
    RC_ASSERT(fewest);
    for (std::size_t row = 0; row < rows; ++row) {
        const glm::dvec3 &begin = ends[2 * row], &end = ends[2 * row + 1];
        RC_ASSERT(begin[across] == end[across] && begin.z == corner.z && end.z == corner.z);
        RC_ASSERT(std::abs(std::abs(end[along] - begin[along]) - std::abs(opposite[along] - corner[along])) < 1e-9);
        if (row == 0) continue;
        const double spacing = std::abs(begin[across] - ends[2 * row - 1][across]);
        RC_ASSERT(spacing <= stepOver + 1e-9);
        RC_ASSERT(std::abs(spacing - width / static_cast<double>(rows - 1)) < 1e-9);
        RC_ASSERT(begin[along] == ends[2 * row - 1][along]);
    }
}

/// Every point of the line stays, in order; the inserted points lie on it, and no two neighbours are too far apart.
void checkSubdivided() {
    std::vector<glm::dvec3> line;
    for (int i = *rc::gen::inRange(1, 8); i > 0; --i) line.push_back(anyPlace());
    const double spacing = anyNumber(10, 3000);
    const std::vector<glm::dvec3> places = subdivided(line, spacing);
    RC_ASSERT(static_cast<double>(places.size()) <= subdividedCount(line, spacing));
    std::size_t reached = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i > 0) RC_ASSERT(glm::distance(places[i - 1], places[i]) <= spacing * (1.0 + 1e-6));
        if (reached < line.size() && places[i] == line[reached]) {
            ++reached;
            continue;
        }
        RC_ASSERT(reached > 0 && reached < line.size());
        const glm::dvec3 &from = line[reached - 1], &to = line[reached];
        const double detour = glm::distance(from, places[i]) + glm::distance(places[i], to) - glm::distance(from, to);
        RC_ASSERT(detour < 1e-6);
    }
    RC_ASSERT(reached == line.size());
}

/// The result lies on the permitted line and is, seen from above, the point of it nearest to the requested one.
void checkLocked() {
    const glm::dvec3 anchor = anyPlace(), place = anyPlace();
    const double angle = anyNumber(0, 628);
    const auto [lock, direction] =
        *rc::gen::element(std::pair(StrokeLock::alongX, glm::dvec3(1.0, 0.0, 0.0)),
                          std::pair(StrokeLock::alongY, glm::dvec3(0.0, 1.0, 0.0)),
                          std::pair(StrokeLock::direction, glm::dvec3(std::cos(angle), std::sin(angle), 0.0)));
    const glm::dvec3 held = locked(lock, anchor, direction, place);
    RC_ASSERT(held.z == place.z);
    const glm::dvec2 line(direction), fromAnchor(held - anchor), asked(place - held);
    RC_ASSERT(std::abs(fromAnchor.x * line.y - fromAnchor.y * line.x) < 1e-9);
    RC_ASSERT(std::abs(glm::dot(asked, line)) < 1e-9);
}

} // namespace

class TestStrokeShapes : public QObject {
    Q_OBJECT

private slots:
    void shapesOfStrokesFitAnyRectangleLineAndLock() {
        QVERIFY(rc::check("rows of a raster", checkRows));
        QVERIFY(rc::check("a line with more places", checkSubdivided));
        QVERIFY(rc::check("a place that a lock allows", checkLocked));
    }
};

BURIN_TEST(TestStrokeShapes, NoApplication)

} // namespace burin::tst_stroke_shapes

#include "tst_stroke_shapes.moc"
