// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/cutting/removal.h"
#include "core/exchange/array_volume.h"
#include "core/tool/tool.h"
#include "tests/test_program.h"

#include <zlib.h>

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <random>

namespace burin::tst_arrays {

namespace {

/// Written byte by byte, as the documentation of the format describes.
std::string header(const std::string& type, const std::string& encoding, const std::string& more = {}) {
    return "NRRD0004\n# a scan\ntype: " + type +
           "\ndimension: 3\nsizes: 4 3 2\nspace directions: (0.5,0,0) (0,0.5,0) "
           "(0,0,0.5)\nspace origin: (10,20,30)\nspace units: \"mm\" \"mm\" \"mm\"\nendian: little\nencoding: " +
           encoding + "\n" + more;
}

/// 24 values of two bytes, little-endian: each is its position times ten.
std::string shorts() {
    std::string data;
    for (int i = 0; i < 24; ++i) {
        const int value = 10 * i;
        data += static_cast<char>(value & 0xff);
        data += static_cast<char>(value >> 8);
    }
    return data;
}

std::string packed(const std::string& data) {
    std::string out(compressBound(data.size()) + 64, '\0');
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY); // gzip
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

Result<Property> anyMaterial(const std::string& id) {
    Property property;
    property.id = property.name = id;
    return property;
}

ArrayTable tableFor(const std::string& text) {
    return ArrayTable::parse(text, "table.json", anyMaterial).value();
}

} // namespace

class TestArrays : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::string write(const std::string& name, const std::string& content) {
        const std::string file = folder_.filePath(QString::fromStdString(name)).toStdString();
        if (!writeFileAtomically(file, content)) qFatal("no test file");
        return file;
    }

private slots:
    void eachWayOfKeepingTheDataIsRead() {
        write("data.raw", shorts());
        const std::string files[] = {
            write("a.nrrd", header("short", "raw") + "\n" + shorts()),
            write("b.nrrd", header("int16", "gzip") + "\n" + packed(shorts())),
            write("c.nhdr", header("signed short", "raw", "data file: data.raw\n")),
            write("d.json", R"({"data_file": "data.raw", "type": "int16", "sizes": [4, 3, 2], "spacing_mm": 0.5,
                               "low_corner_mm": [9.75, 19.75, 29.75]})")};
        for (const std::string& file : files) {
            const auto array = readArrayFile(file);
            QVERIFY2(array, file.c_str());
            QCOMPARE(array->count, glm::ivec3(4, 3, 2));
            QCOMPARE(array->edge, 0.5);
            QVERIFY(glm::distance(array->low, glm::dvec3(9.75, 19.75, 29.75)) < 1e-12); // the origin is a centre
            for (std::size_t i = 0; i < 24; ++i) QCOMPARE(array->at(i), 10.0 * static_cast<double>(i));
        }
    }

    void everyTypeOfNumberIsRead_data() {
        QTest::addColumn<QString>("type");
        QTest::addColumn<QByteArray>("one"); // of 24, big-endian
        QTest::addColumn<double>("value");
        QTest::newRow("int8") << "int8" << QByteArray::fromHex("fe") << -2.0;
        QTest::newRow("uint8") << "uchar" << QByteArray::fromHex("fe") << 254.0;
        QTest::newRow("int16") << "short" << QByteArray::fromHex("fffe") << -2.0;
        QTest::newRow("uint16") << "ushort" << QByteArray::fromHex("0102") << 258.0;
        QTest::newRow("int32") << "int" << QByteArray::fromHex("fffffffe") << -2.0;
        QTest::newRow("uint32") << "uint32" << QByteArray::fromHex("00010000") << 65536.0;
        QTest::newRow("int64") << "long long" << QByteArray::fromHex("fffffffffffffffe") << -2.0;
        QTest::newRow("uint64") << "uint64_t" << QByteArray::fromHex("0000000100000000") << 4294967296.0;
        QTest::newRow("float") << "float" << QByteArray::fromHex("3fc00000") << 1.5;
        QTest::newRow("double") << "double" << QByteArray::fromHex("3ff8000000000000") << 1.5;
    }
    void everyTypeOfNumberIsRead() {
        QFETCH(QString, type);
        QFETCH(QByteArray, one);
        QFETCH(double, value);
        std::string text = header(type.toStdString(), "raw") + "\n" + one.repeated(24).toStdString();
        text.replace(text.find("little"), 6, "big");
        const auto array = readArrayFile(write("t.nrrd", text));
        QVERIFY(array);
        QCOMPARE(array->at(0), value);
        QCOMPARE(array->at(23), value);
    }

    void whatCantBeReadIsSaid_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const char* from, const char* to, ErrorCode code) {
            QTest::newRow(name) << from << to << static_cast<int>(code);
        };
        row("no magic", "NRRD0004", "NURD0004", ErrorCode::fileFormatUnknown);
        row("no sizes", "sizes: 4 3 2\n", "", ErrorCode::fileDamaged);
        row("a size of nothing", "sizes: 4 3 2", "sizes: 4 0 2", ErrorCode::fileDamaged);
        row("huge", "sizes: 4 3 2", "sizes: 32768 32768 32768", ErrorCode::volumeTooLarge);
        row("longer than any axis", "sizes: 4 3 2", "sizes: 99999999 3 2", ErrorCode::volumeTooLarge);
        row("too little data", "sizes: 4 3 2", "sizes: 4 3 3", ErrorCode::fileDamaged);
        row("two dimensions", "dimension: 3", "dimension: 2", ErrorCode::notSupported);
        row("blocks", "type: short", "type: block", ErrorCode::fileDamaged);
        row("another encoding", "encoding: raw", "encoding: bzip2", ErrorCode::notSupported);
        row("no order of bytes", "endian: little\n", "", ErrorCode::fileDamaged);
        row("turned", "(0.5,0,0) (0,0.5,0)", "(0,0.5,0) (0.5,0,0)", ErrorCode::notSupported);
        row("mirrored", "(0.5,0,0) (0,0.5,0)", "(-0.5,0,0) (0,0.5,0)", ErrorCode::notSupported);
        row("slices that are thicker", "(0,0,0.5)", "(0,0,1.5)", ErrorCode::notSupported);
        row("another unit", "\"mm\"", "\"furlong\"", ErrorCode::fileDamaged);
        row("data elsewhere", "encoding: raw\n", "encoding: raw\ndata file: ../../etc/passwd\n",
            ErrorCode::notSupported);
        row("data that are not there", "encoding: raw\n", "encoding: raw\ndata file: none.raw\n",
            ErrorCode::fileNotFound);
        row("packed rubbish", "encoding: raw", "encoding: gzip", ErrorCode::fileDamaged);
    }
    void whatCantBeReadIsSaid() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(int, code);
        std::string text = header("short", "raw") + "\n" + shorts();
        text.replace(text.find(from.toStdString()), static_cast<std::size_t>(from.size()), to.toStdString());
        const auto array = readArrayFile(write("bad.nrrd", text));
        QVERIFY(!array);
        QCOMPARE(static_cast<int>(array.error().code), code);
    }

    void tablesMapRangesAndRefuseOverlaps() {
        const ArrayTable table = tableFor(R"({"entries": [{"value": 0, "material": null},
            {"from": 10, "to": 20, "material": "wax"}, {"from": 30, "to": 40, "material": "bone"},
            {"value": 50, "material": "wax"}]})");
        QCOMPARE(table.materials().size(), 3);
        QCOMPARE(table.of(0.0), std::optional<PropertyIndex>(airProperty));
        for (const double value : {10.0, 15.5, 20.0, 50.0}) QCOMPARE(table.of(value), std::optional<PropertyIndex>(1));
        QCOMPARE(table.of(40.0), std::optional<PropertyIndex>(2));
        for (const double value : {-1.0, 5.0, 25.0, 41.0}) QVERIFY(!table.of(value));
        for (const char* wrong :
             {"", "[]", R"({"entries": 1})", R"({"entries": [{"value": 1}]})", R"({"entries": [{"material": "wax"}]})",
              R"({"entries": [{"from": 3, "to": 2, "material": null}]})",
              R"({"entries": [{"value": 1, "material": 7}]})",
              R"({"entries": [{"from": 0, "to": 5, "material": null}, {"value": 5, "material": "wax"}]})"})
            QVERIFY2(!ArrayTable::parse(wrong, "table.json", anyMaterial), wrong);
    }

    void aValueThatTheTableDoesNotKnowIsNamed() {
        const auto array = readArrayFile(write("a.nrrd", header("short", "raw") + "\n" + shorts()));
        const auto volume = volumeOf(*array, tableFor(R"({"entries": [{"from": 0, "to": 160, "material": "wax"}]})"));
        QVERIFY(!volume);
        QCOMPARE(volume.error().place, std::string("170"));
        QVERIFY2(volume.error().detail.find("voxel 1, 1, 1 at X10.5 Y20.5 Z30.5 mm") != std::string::npos,
                 volume.error().detail.c_str());
    }

    /// Section 2 of the paper from the user's side: an array of voxels with one property each is imported, milled and
    /// exported; voxels that no flute touched are unchanged.
    void anArrayComesInIsMilledAndGoesOut() {
        constexpr int side = 40;
        std::mt19937 random(3);
        std::string data;
        for (int i = 0; i < side * side * side; ++i) data += static_cast<char>(random() % 5U);
        const std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 40 40\nspacings: 0.5 0.5 0.5\n"
                                 "encoding: raw\n\n" +
                                 data;
        const auto array = readArrayFile(write("scan.nrrd", text));
        QVERIFY(array && !array->unitKnown);
        const ArrayTable table = tableFor(R"({"entries": [{"value": 0, "material": null}, {"value": 1, "material": "a"},
            {"value": 2, "material": "b"}, {"value": 3, "material": "c"}, {"value": 4, "material": "d"}]})");
        auto volume = volumeOf(*array, table);
        QVERIFY(volume);
        const Cutter cutter{CutterType::flat, 4.0, 0.0, 30.0, 4.0, 40.0, {}};
        MaterialRemoval removal(cutter, volume->grid());
        const glm::dvec3 from{-3.0, 10.0, 12.0}, to{23.0, 10.0, 12.0};
        removal.cut(*volume, from, to);

        const WholeVoxels out = wholeVoxels(volume->snapshot());
        const std::string written =
            write("out.nrrd", nrrdOf(volume->grid().count(), 0.5, volume->grid().low(), out.properties));
        const auto again = readArrayFile(written);
        QVERIFY(again);
        QVERIFY(again->unitKnown && again->low == volume->grid().low());
        int milled = 0;
        for (int z = 0; z < side; ++z)
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) {
                    const auto place = static_cast<std::size_t>((z * side + y) * side + x);
                    const glm::dvec3 middle = 0.5 * (glm::dvec3(x, y, z) + 0.5);
                    const bool cut = middle.z > 12.0 && std::abs(middle.y - 10.0) < 2.0; // the slot has no ends
                    const double expected = cut ? 0.0 : static_cast<unsigned char>(data[place]);
                    if (std::abs(std::abs(middle.y - 10.0) - 2.0) < 1e-9) continue;
                    QCOMPARE(again->at(place), expected);
                    milled += cut ? 1 : 0;
                }
        QVERIFY(milled > 5000);
        const ArrayTable own = ArrayTable::parse(tableOf(volume->properties()), "own", anyMaterial).value();
        QCOMPARE(own.materials().size(), volume->properties().size());
    }
};

BURIN_TEST(TestArrays, QCoreApplication)

} // namespace burin::tst_arrays

#include "tst_arrays.moc"
