// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/csv.h"
#include "core/verify/face_quality.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_face_quality {

namespace {

/// Two triangles over a rectangle, facing the side from which its corners are counter-clockwise.
PartFacePatch rectangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    PartFacePatch patch;
    patch.kind = MeasuredFace::Kind::plane;
    patch.mesh.vertices = {a, b, c, d};
    patch.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    patch.area = surfaceArea(patch.mesh);
    return patch;
}

enum Number { bottom, top, left, right, front, back };

/// The faces of a block of 30 x 20 x 10 mm with a corner at the origin, in the order of `Number`.
std::vector<PartFacePatch> blockFaces() {
    const auto corner = [](int x, int y, int z) { return glm::dvec3(30.0 * x, 20.0 * y, 10.0 * z); };
    return {rectangle(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)),
            rectangle(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)),
            rectangle(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)),
            rectangle(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)),
            rectangle(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)),
            rectangle(corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0))};
}

std::vector<FaceQuality> judged(const std::vector<DeviationSample>& samples, const DeviationTolerance& tolerance) {
    Progress progress;
    return faceQualities(blockFaces(), samples, tolerance, progress).value();
}

/// Four samples on top, two on the right side, one at the front that no tool reaches; none elsewhere.
const std::vector<DeviationSample> samples{{{5.0, 5.0, 10.0}, 0.0, 0.3, true},   {{6.0, 15.0, 10.0}, 0.0, 0.1, true},
                                           {{20.0, 5.0, 10.0}, 0.25, 0.0, true}, {{25.0, 15.0, 10.0}, 0.0, 0.0, true},
                                           {{30.0, 5.0, 5.0}, 0.7, 0.0, true},   {{30.0, 15.0, 5.0}, 0.55, 0.0, true},
                                           {{15.0, 0.0, 9.9}, 4.0, 0.0, false}};

} // namespace

class FaceQualityTest : public QObject {
    Q_OBJECT
private slots:
    /// Expected values computed by hand.
    void eachSampleBelongsToItsFace() {
        const std::vector<FaceQuality> faces = judged(samples, {0.02, 0.1, 0.5});
        QCOMPARE(faces.size(), std::size_t{6});
        for (std::size_t i = 0; i < faces.size(); ++i) {
            QCOMPARE(faces[i].number, i + 1);
            const double shares = faces[i].shares.gouge + faces[i].shares.inTolerance + faces[i].shares.excess +
                                  faces[i].shares.unreachable;
            QVERIFY(std::abs(shares - (faces[i].samples > 0 ? 1.0 : 0.0)) < 1e-12);
        }
        QCOMPARE(faces[top].samples, std::size_t{4});
        QCOMPARE(faces[top].area, 600.0);
        QCOMPARE(faces[top].gouge.amount, 0.3);
        QVERIFY(faces[top].gouge.place == glm::dvec3(5.0, 5.0, 10.0));
        QVERIFY(faces[top].gouge.outward == glm::dvec3(0.0, 0.0, 1.0));
        QCOMPARE(faces[top].excess.amount, 0.0); // 0.25 mm of stock is less than the allowance
        QCOMPARE(faces[top].shares.gouge, 0.5);
        QCOMPARE(faces[top].shares.inTolerance, 0.5);
        QCOMPARE(faces[right].samples, std::size_t{2});
        QCOMPARE(faces[right].gouge.amount, 0.0);
        QVERIFY(std::abs(faces[right].excess.amount - 0.2) < 1e-12); // above the allowance of 0.5 mm
        QVERIFY(faces[right].excess.place == glm::dvec3(30.0, 5.0, 5.0));
        QVERIFY(faces[right].excess.outward == glm::dvec3(1.0, 0.0, 0.0));
        QCOMPARE(faces[right].shares.excess, 0.5);
        QCOMPARE(faces[right].shares.inTolerance, 0.5); // 0.55 mm: within 0.1 mm of the allowance
        // 0.1 mm from the top, but not one of its samples: unreachable, so it is not a worst point.
        QCOMPARE(faces[front].samples, std::size_t{1});
        QCOMPARE(faces[front].excess.amount, 0.0);
        QCOMPARE(faces[front].shares.unreachable, 1.0);
        for (const Number empty : {bottom, left, back}) QCOMPARE(faces[empty].samples, std::size_t{0});
    }

    /// Compared with the nearest face by brute force: for points on a block that is the nearest plane.
    void manyPlacesAsByBruteForce() {
        std::vector<DeviationSample> many;
        std::vector<std::size_t> counted(6, 0);
        for (int i = 1; i < 30; ++i)
            for (int j = 1; j < 20; ++j)
                for (int k = 1; k < 10; ++k) {
                    const glm::dvec3 place(i + 0.13, j + 0.29, k + 0.41);
                    const double to[6] = {place.z, 10.0 - place.z, place.x, 30.0 - place.x, place.y, 20.0 - place.y};
                    ++counted[static_cast<std::size_t>(std::ranges::min_element(to) - std::begin(to))];
                    many.push_back({place, 0.0, 0.0, true});
                }
        const std::vector<FaceQuality> faces = judged(many, {});
        for (std::size_t i = 0; i < 6; ++i) QCOMPARE(faces[i].samples, counted[i]);
    }

    /// Faces with a gouge come first, then those with excess; faces without samples come last.
    void theWorstComesFirst() {
        std::vector<FaceQuality> faces = judged(samples, {0.02, 0.1, 0.5});
        sortByQuality(faces);
        QCOMPARE(faces[0].number, std::size_t{top + 1});
        QCOMPARE(faces[1].number, std::size_t{right + 1});
        QCOMPARE(faces[2].number, std::size_t{front + 1});
        QVERIFY(worstPointOf(faces[0]).place == glm::dvec3(5.0, 5.0, 10.0));
        QVERIFY(worstPointOf(faces[1]).place == glm::dvec3(30.0, 5.0, 5.0));
        // A face without a deviation is shown at its middle.
        QCOMPARE(worstPointOf(faces[2]).place.y, 0.0);
        QVERIFY(worstPointOf(faces[2]).outward == glm::dvec3(0.0, -1.0, 0.0));
    }

    /// Burin's CSV reader reads the same fields.
    void theTableIsCsv() {
        const std::vector<FaceQuality> faces = judged(samples, {0.02, 0.1, 0.5});
        const std::string table = faceTable(faces, ',');
        std::string_view rest = table;
        const auto names = csvFields(takeLine(rest));
        QVERIFY(names && names->size() == 17);
        std::vector<std::vector<std::string>> lines;
        while (!rest.empty()) lines.push_back(csvFields(takeLine(rest)).value());
        QCOMPARE(lines.size(), std::size_t{6});
        const auto field = [&](std::size_t face, const char* name) {
            const auto column = std::ranges::find(*names, name) - names->begin();
            return lines[face][static_cast<std::size_t>(column)];
        };
        for (const auto& line : lines) QCOMPARE(line.size(), names->size());
        QCOMPARE(field(top, "face"), std::string("2"));
        QCOMPARE(field(top, "kind"), std::string("plane"));
        QCOMPARE(field(top, "diameter_mm"), std::string());
        QCOMPARE(field(top, "area_mm2"), std::string("600.000"));
        QCOMPARE(field(top, "gouge_max_mm"), std::string("0.3000"));
        QCOMPARE(field(top, "gouge_z_mm"), std::string("10.0000"));
        QCOMPARE(field(top, "excess_x_mm"), std::string());
        QCOMPARE(field(top, "in_tolerance"), std::string("0.5000"));
        QCOMPARE(field(bottom, "gouge_max_mm"), std::string());
        QCOMPARE(field(bottom, "samples"), std::string("0"));
        std::string tabs = table;
        std::ranges::replace(tabs, ',', '\t');
        QCOMPARE(faceTable(faces, '\t'), tabs);
    }

    void cancellingEndsIt() {
        Progress progress;
        progress.cancel();
        const auto faces = faceQualities(blockFaces(), samples, {}, progress);
        QVERIFY(!faces && faces.error().code == ErrorCode::cancelled);
    }
};

BURIN_TEST(FaceQualityTest, QCoreApplication)

} // namespace burin::tst_face_quality

#include "tst_face_quality.moc"
