// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"
#include "core/volume/packed/volume_file.h"
#include "tests/core/volume/volume_fixtures.h"
#include "tests/oracles/volume_file_form.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QFile>
#include <QtTest>

#include <nlohmann/json.hpp>
#include <sstream>

namespace burin::tst_volume_file_form {

using namespace burin::oracles;
using fixture::VolumeFixture;

// The file form is stable, even if writer and reader change together: files written by version 1 are read, and both
// they and today's files conform literally to volume_file.md.

namespace {

VolumeFixture fixtureNamed(const QString& name) {
    return name == "several-bricks" ? fixture::severalBricks() : fixture::manyProperties();
}

QString fileOf(const QString& name) {
    return BURIN_FIXTURES "/volumes/v1/" + name + ".volume";
}

std::string bytesOfFixture(const QString& name) {
    QFile file(fileOf(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

std::string bytesOfToday(const QString& name) {
    std::ostringstream stream;
    Progress progress;
    RunVolume volume = volumeOf(fixtureNamed(name));
    return writeVolume(stream, "test", volume.snapshot(), progress) ? stream.str() : std::string();
}

std::int32_t bricksFor(std::int32_t lines) {
    return (lines + 7) / 8;
}

/// Segments of all bricks; those of air share one, and lines outside the grid have one segment each.
std::uint64_t segmentsOf(const VolumeFixture& fixture) {
    const Grid& grid = fixture.grid;
    std::uint64_t sum = 0;
    bool anyAir = false;
    for (std::int32_t brickV = 0; brickV < bricksFor(grid.lineCountV()); ++brickV)
        for (std::int32_t brickU = 0; brickU < bricksFor(grid.lineCountU()); ++brickU) {
            std::uint64_t here = 0;
            bool air = true;
            for (int i = 0; i < 64; ++i) {
                const LineIndex line{8 * brickU + i % 8, 8 * brickV + i / 8};
                const auto segments = grid.contains(line) ? fixture.line(line) : std::vector<Segment>(1);
                here += segments.size();
                air = air && segments.size() == 1 && segments[0].property() == airProperty;
            }
            sum += air && anyAir ? 0 : here;
            anyAir |= air;
        }
    return sum;
}

/// Groups of 16 × 16 bricks row by row, within a group bricks row by row.
std::vector<std::vector<LineIndex>> bricksByGroup(const Grid& grid) {
    std::vector<std::vector<LineIndex>> groups;
    const std::int32_t bricksU = bricksFor(grid.lineCountU()), bricksV = bricksFor(grid.lineCountV());
    for (std::int32_t groupV = 0; groupV < bricksV; groupV += 16)
        for (std::int32_t groupU = 0; groupU < bricksU; groupU += 16) {
            groups.emplace_back();
            for (std::int32_t v = groupV; v < std::min(groupV + 16, bricksV); ++v)
                for (std::int32_t u = groupU; u < std::min(groupU + 16, bricksU); ++u)
                    groups.back().push_back({8 * u, 8 * v});
        }
    return groups;
}

bool brickIsThatOfTheRule(const VolumeFixture& fixture, LineIndex corner, const FormBricks::Lines& lines) {
    for (int i = 0; i < 64; ++i) {
        const LineIndex line{corner.u + i % 8, corner.v + i / 8};
        if (fixture.grid.contains(line) && lines[static_cast<std::size_t>(i)] != fixture.line(line)) return false;
    }
    return true;
}

void everyFixture() {
    QTest::addColumn<QString>("name");
    QTest::newRow("several bricks") << "several-bricks";
    QTest::newRow("many properties") << "many-properties";
}

} // namespace

class TestVolumeFileForm : public QObject {
    Q_OBJECT

private slots:
    void aFileOfVersion1IsRead_data() { everyFixture(); }
    void aFileOfVersion1IsRead() {
        QFETCH(QString, name);
        const VolumeFixture fixture = fixtureNamed(name);
        Progress progress;
        const Result<VolumeFileContent> content = readVolumeFile(fileOf(name).toStdString(), progress);
        QVERIFY(content && content->lost.empty() && !content->headerWasDamaged);
        const Grid& grid = content->volume.grid();
        QVERIFY(grid.low() == fixture.grid.low() && grid.edge() == fixture.grid.edge());
        QVERIFY(grid.count() == fixture.grid.count() && grid.axis() == fixture.grid.axis());
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                QVERIFY2(std::ranges::equal(content->volume.line(line), fixture.line(line)),
                         qPrintable(QString("line %1 %2").arg(line.u).arg(line.v)));
        const PropertyList& list = content->volume.properties();
        QCOMPARE(list.size(), fixture.properties.size());
        for (int i = 0; i < list.size(); ++i) {
            const Property &found = list[static_cast<PropertyIndex>(i)],
                           &expected = fixture.properties[static_cast<PropertyIndex>(i)];
            QCOMPARE(found.id, expected.id);
            QCOMPARE(found.name, expected.name);
            QCOMPARE(found.base, expected.base);
            QVERIFY(found.colour == expected.colour && found.machinability == expected.machinability);
            QCOMPARE(found.values.size(), expected.values.size());
            for (const auto& [key, value] : expected.values) {
                const NamedValue& back = found.values.at(key);
                QCOMPARE(back.value, value.value);
                QCOMPARE(back.unit, value.unit);
                QCOMPARE(back.source, value.source);
                QCOMPARE(back.estimate, value.estimate);
            }
        }
    }

    void filesStandToTheWordOfTheForm_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("today");
        QTest::newRow("several bricks, as version 1 wrote them") << "several-bricks" << false;
        QTest::newRow("several bricks, written today") << "several-bricks" << true;
        QTest::newRow("many properties, as version 1 wrote them") << "many-properties" << false;
        QTest::newRow("many properties, written today") << "many-properties" << true;
    }
    void filesStandToTheWordOfTheForm() {
        QFETCH(QString, name);
        QFETCH(bool, today);
        const VolumeFixture fixture = fixtureNamed(name);
        const std::string bytes = today ? bytesOfToday(name) : bytesOfFixture(name);
        FormBytes file(bytes);
        const FormHeader header = takeHeader(file);
        QVERIFY(header.isSound);
        QCOMPARE(header.version, 1U);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            QCOMPARE(header.low[i], fixture.grid.low()[axis]);
            QCOMPARE(header.count[i], static_cast<std::uint32_t>(fixture.grid.count()[axis]));
        }
        QCOMPARE(header.edge, fixture.grid.edge());
        QCOMPARE(header.axis, name == "several-bricks" ? 1U : 2U); // y, z
        QCOMPARE(header.segments, segmentsOf(fixture));
        QCOMPARE(header.properties.size(), static_cast<std::size_t>(fixture.properties.size() - 1));
        const auto properties = static_cast<std::uint32_t>(fixture.properties.size());
        const auto groups = bricksByGroup(fixture.grid);
        for (std::uint32_t group = 0; group < groups.size(); ++group) { // each fits one block
            const FormBlock block = takeBlock(file);
            QVERIFY(block.isSound);
            QCOMPARE(block.group, group);
            QCOMPARE(block.firstBrick, 0U);
            QCOMPARE(static_cast<std::size_t>(block.bricks), groups[group].size());
            QVERIFY(block.frame.starts_with("\x28\xb5\x2f\xfd")); // RFC 8878
            const std::optional<std::string> plain = decompress(block.frame, block.plainBytes);
            QVERIFY(plain && plain->size() == block.plainBytes);
            FormBricks bricks(*plain, properties, fixture.grid.lineEnd());
            for (const LineIndex corner : groups[group])
                QVERIFY2(brickIsThatOfTheRule(fixture, corner, bricks.next()),
                         qPrintable(QString("brick at %1 %2").arg(corner.u).arg(corner.v)));
            QVERIFY(bricks.atEnd());
        }
        QVERIFY(file.rest() == header.bytes);
    }

    /// Byte by byte, except for the length, which depends on the layout of a property's JSON.
    void theHeaderBeginsAsWrittenOut_data() {
        QTest::addColumn<bool>("today");
        QTest::newRow("as version 1 wrote it") << false;
        QTest::newRow("written today") << true;
    }
    void theHeaderBeginsAsWrittenOut() {
        QFETCH(bool, today);
        const std::string bytes = today ? bytesOfToday("several-bricks") : bytesOfFixture("several-bricks");
        const auto part = [&](std::size_t from, std::size_t count) {
            return QByteArray::fromStdString(bytes.substr(from, count)).toHex(' ');
        };
        QCOMPARE(part(0, 12), QByteArray("42 75 72 69 6e 56 6f 6c 01 00 00 00"));      // BurinVol, version 1
        QCOMPARE(part(16, 24), QByteArray("00 00 00 00 00 00 0c c0 00 00 00 00 00 00 " // low corner: -3.5, 1.25,
                                          "f4 3f 00 00 00 00 00 00 24 40"));           // 10
        QCOMPARE(part(40, 8), QByteArray("00 00 00 00 00 00 d0 3f"));                  // edge 0.25
        QCOMPARE(part(48, 12), QByteArray("0a 00 00 00 06 00 00 00 84 00 00 00"));     // 10, 6, 132 voxels
        QCOMPARE(part(60, 4), QByteArray("01 00 00 00"));                              // y
        QCOMPARE(part(72, 4), QByteArray("04 00 00 00"));                              // properties in addition to air
    }

    void aPropertyIsTheJsonOfAMaterial_data() { theHeaderBeginsAsWrittenOut_data(); }
    void aPropertyIsTheJsonOfAMaterial() {
        QFETCH(bool, today);
        const std::string bytes = today ? bytesOfToday("several-bricks") : bytesOfFixture("several-bricks");
        FormBytes file(bytes);
        const FormHeader header = takeHeader(file);
        QCOMPARE(header.properties.size(), std::size_t{4});
        QVERIFY(nlohmann::json::parse(header.properties[0]) == nlohmann::json::parse(R"({
            "id": "wax", "name": "Wachs, grün", "colour": [200, 180, 3], "machinability": "machinable",
            "values": {
                "density": {"value": 0.9375, "unit": "g/cm^3", "source": "a table", "estimate": false},
                "hardness of the day": {"value": 0.1, "unit": "HB", "source": "measured", "estimate": true}}})"));
        QVERIFY(nlohmann::json::parse(header.properties[2]) == nlohmann::json::parse(R"({
            "id": "part", "name": "part", "colour": [128, 128, 128], "machinability": "protected", "values": {}})"));
        QVERIFY(nlohmann::json::parse(header.properties[3]) == nlohmann::json::parse(R"({
            "id": "wax-soft", "name": "Wachs, grün", "colour": [200, 180, 3], "machinability": "machinable",
            "base": "wax", "values": {}})"));
    }
};

BURIN_TEST(TestVolumeFileForm, NoApplication)

} // namespace burin::tst_volume_file_form

#include "tst_volume_file_form.moc"
