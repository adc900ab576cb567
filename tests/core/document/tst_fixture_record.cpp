// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/surroundings_record.h"
#include "core/setup/fixture_library.h"
#include "core/setup/fixture_placement.h"
#include "tests/test_program.h"

#include <nlohmann/json.hpp>

#include <QtTest>

namespace burin::tst_fixture_record {

class TestFixtureRecord : public QObject {
    Q_OBJECT
private slots:
    /// A project keeps what each kind was made of, bit for bit.
    void whatAFixtureIsMadeOfIsKept() {
        const Box stock{{0.1, 0.2, 0.3}, {40.0, 30.0, 20.0}};
        for (const FixtureKindRow& row : fixtureKinds) {
            const FixtureDesign design =
                placedAt(standardFixture(row.kind), {}, siteOf(stock, {}), firstPoint(row.kind, stock));
            const Result<Obstacle> fixture = fixtureOf(design, stock, row.id, 0.7);
            QVERIFY2(fixture, row.id);
            const RecordWithBlob record = recordOf(*fixture);
            const std::optional<Obstacle> read = obstacleFrom(record.json, record.blob);
            QVERIFY2(read && *read == *fixture, row.id);
            QVERIFY(read->design == design);
        }
    }

    /// A kind of a later version, or damaged sizes: the solid stands, as for a version that knows no library.
    void anUnknownKindIsAPlainSolid() {
        const Box stock{{0.0, 0.0, 0.0}, {40.0, 30.0, 20.0}};
        const Result<Obstacle> fixture = fixtureOf(
            placedAt(standardFixture(FixtureKind::vise), {}, siteOf(stock, {}), {20.0, 0.0, 5.0}), stock, "Vise", 1.0);
        QVERIFY(fixture);
        const RecordWithBlob record = recordOf(*fixture);
        const auto changed = [&](const char* pointer, const nlohmann::json& value) {
            nlohmann::json json = nlohmann::json::parse(record.json);
            json[nlohmann::json::json_pointer(pointer)] = value;
            return obstacleFrom(json.dump(), record.blob);
        };
        for (const auto& read : {changed("/library/kind", "magnet"), changed("/library/values_mm/opening", -3.0),
                                 changed("/library/values_mm", nlohmann::json::object()),
                                 changed("/library/place_mm", "here"), changed("/library", 7)}) {
            QVERIFY(read && !read->design);
            QCOMPARE(boundsOf(*read).low, boundsOf(*fixture).low);
            QCOMPARE(boundsOf(*read).high, boundsOf(*fixture).high);
        }
    }
};

BURIN_TEST(TestFixtureRecord, NoApplication)

} // namespace burin::tst_fixture_record

#include "tst_fixture_record.moc"
