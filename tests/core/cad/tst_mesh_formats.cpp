// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <zip.h>

#include <cmath>
#include <cstring>

namespace burin::tst_mesh_formats {

using namespace burin::test;

namespace {

/// Corners and quadrilaterals of a box, counted from `first`; x counts fastest.
QByteArray boxCorners(const glm::dvec3& low, const glm::dvec3& high, const char* before) {
    QByteArray text;
    for (unsigned i = 0; i < 8; ++i)
        text += before + QByteArray::number((i & 1U) ? high.x : low.x) + ' ' +
                QByteArray::number((i & 2U) ? high.y : low.y) + ' ' + QByteArray::number((i & 4U) ? high.z : low.z) +
                '\n';
    return text;
}
constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

QByteArray boxFaces(int first, const char* before) {
    QByteArray text;
    for (const auto& quad : quads) {
        text += before;
        for (const int corner : quad) text += ' ' + QByteArray::number(first + corner);
        text += '\n';
    }
    return text;
}

QByteArray cubeObj() {
    return "# two boxes\nmtllib colours.mtl\no big\n" + boxCorners({0, 0, 0}, {10, 20, 30}, "v ") + boxFaces(1, "f") +
           "o small\n" + boxCorners({100, 0, 0}, {101, 1, 1}, "v ") + boxFaces(9, "f");
}

QByteArray boxPly(int faces = 6) {
    return "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement "
           "face " +
           QByteArray::number(faces) + "\nproperty list uchar int vertex_indices\nend_header\n" +
           boxCorners({0, 0, 0}, {10, 20, 30}, "") + boxFaces(0, "4");
}

/// Little-endian, as scanners write it.
QByteArray binaryPly() {
    QByteArray data = "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                      "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    const auto add = [&](const auto& value) { data.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (unsigned i = 0; i < 8; ++i)
        for (const float number : {(i & 1U) ? 10.0F : 0.0F, (i & 2U) ? 20.0F : 0.0F, (i & 4U) ? 30.0F : 0.0F})
            add(number);
    for (const auto& quad : quads) {
        data.append(char(4));
        for (const std::int32_t corner : quad) add(corner);
    }
    return data;
}

QByteArray boxOff() {
    return "OFF\n# a comment\n8 6 12\n" + boxCorners({0, 0, 0}, {10, 20, 30}, "") + boxFaces(0, "4");
}

QByteArray xmlMesh(const char* vertex, const char* triangle, bool amf) {
    QByteArray text;
    for (unsigned i = 0; i < 8; ++i) {
        const QByteArray x = (i & 1U) ? "1" : "0", y = (i & 2U) ? "2" : "0", z = (i & 4U) ? "3" : "0";
        text += amf ? "<vertex><coordinates><x>" + x + "</x><y>" + y + "</y><z>" + z + "</z></coordinates></vertex>"
                    : QByteArray("<") + vertex + " x=\"" + x + "\" y=\"" + y + "\" z=\"" + z + "\"/>";
    }
    text += amf ? "</vertices><volume>" : "</vertices><triangles>";
    for (const auto& quad : quads)
        for (const auto& corners : {std::array{quad[0], quad[1], quad[2]}, std::array{quad[0], quad[2], quad[3]}}) {
            text += QByteArray("<") + triangle;
            if (amf) text += ">";
            for (int i = 0; i < 3; ++i) {
                const QByteArray name = "v" + QByteArray::number(i + 1),
                                 at = QByteArray::number(corners[static_cast<std::size_t>(i)]);
                text += amf ? "<" + name + ">" + at + "</" + name + ">" : " " + name + "=\"" + at + "\"";
            }
            text += amf ? "</triangle>" : "/>";
        }
    return text;
}

QByteArray boxAmf(const char* unit) {
    return QByteArray("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf version=\"1.1\"") + unit +
           "><object id=\"0\"><metadata type=\"name\">casting</metadata><mesh><vertices>" +
           xmlMesh("vertex", "triangle", true) + "</volume></mesh></object></amf>\n";
}

/// One object with two instances: unchanged, and rotated by 90° about z and moved by 100 along x.
QByteArray model3mf(const char* unit) {
    return QByteArray("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model") + unit +
           " xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>"
           "<object id=\"1\" type=\"model\" name=\"bracket\"><mesh><vertices>" +
           xmlMesh("vertex", "triangle", false) +
           "</triangles></mesh></object></resources><build><item objectid=\"1\"/>"
           "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 100 0 0\"/></build></model>";
}

QByteArray zipped(const QByteArray& content, const char* name) {
    zip_error_t error;
    zip_source_t* buffer = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(buffer);
    zip_t* archive = zip_open_from_source(buffer, ZIP_TRUNCATE, &error);
    const auto add = [&](const char* file, const QByteArray& text) {
        zip_source_t* source = zip_source_buffer(archive, text.constData(), static_cast<zip_uint64_t>(text.size()), 0);
        zip_file_add(archive, file, source, ZIP_FL_OVERWRITE);
    };
    const QByteArray relations =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><Relationships "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
        "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    add("_rels/.rels", relations);
    add(name, content);
    zip_close(archive);
    zip_stat_t state;
    zip_source_stat(buffer, &state);
    zip_source_open(buffer);
    QByteArray bytes(static_cast<int>(state.size), '\0');
    zip_source_read(buffer, bytes.data(), state.size);
    zip_source_close(buffer);
    zip_source_free(buffer);
    return bytes;
}

} // namespace

/// Meshes written by other programs. Boxes, so that the oracle is a closed formula: 10 × 20 × 30, or 1 × 2 × 3 of a
/// unit.
class MeshFormats : public QObject {
    Q_OBJECT

private slots:
    void aBoxIsReadFromEach_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QList<double>>("size");
        QTest::addColumn<int>("bodies");
        const QList<double> box{10.0, 20.0, 30.0};
        QTest::newRow("PLY") << boxPly() << "PLY"
                             << "none" << box << 1;
        QTest::newRow("binary PLY") << binaryPly() << "PLY"
                                    << "none" << box << 1;
        QTest::newRow("OFF") << boxOff() << "OFF"
                             << "none" << box << 1;
        QTest::newRow("OBJ") << cubeObj() << "OBJ"
                             << "none" << QList<double>{101.0, 20.0, 30.0} << 2;
        QTest::newRow("OBJ of Windows") << cubeObj().replace("\n", "\r\n") << "OBJ"
                                        << "none" << QList<double>{101.0, 20.0, 30.0} << 2;
        QTest::newRow("AMF") << boxAmf("") << "AMF"
                             << "mm" << QList<double>{1.0, 2.0, 3.0} << 1;
        QTest::newRow("AMF in inches") << boxAmf(" unit=\"inch\"") << "AMF"
                                       << "inch" << QList<double>{25.4, 50.8, 76.2} << 1;
        QTest::newRow("packed AMF") << zipped(boxAmf(" unit='feet'"), "part.amf") << "AMF"
                                    << "foot" << QList<double>{304.8, 609.6, 914.4} << 1;
        // The second one extends from 98 to 100 along x and from 0 to 1 along y.
        QTest::newRow("3MF") << zipped(model3mf(" unit=\"millimeter\""), "3D/3dmodel.model") << "3MF"
                             << "mm" << QList<double>{100.0, 2.0, 3.0} << 2;
        QTest::newRow("3MF in inches") << zipped(model3mf(" unit=\"inch\""), "3D/3dmodel.model") << "3MF"
                                       << "inch" << QList<double>{2540.0, 50.8, 76.2} << 2;
        QTest::newRow("3MF without a unit") << zipped(model3mf(""), "3D/3dmodel.model") << "3MF"
                                            << "mm" << QList<double>{100.0, 2.0, 3.0} << 2;
    }
    void aBoxIsReadFromEach() {
        QFETCH(QByteArray, content);
        QFETCH(QString, format);
        QFETCH(QString, unit);
        QFETCH(QList<double>, size);
        QFETCH(int, bodies);
        const Result<Model> model = read(content);
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QCOMPARE(QString::fromStdString(model->format), format);
        QCOMPARE(QString::fromStdString(model->lengthUnit), unit);
        QCOMPARE(model->bodies.size(), static_cast<std::size_t>(bodies));
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY2(std::abs(model->box().size()[axis] - size[axis]) < 1e-4 * size[axis],
                     qPrintable(QString::number(model->box().size()[axis])));
        for (const Body& body : model->bodies) {
            QCOMPARE(body.openEdges, std::size_t{0});
            const glm::dvec3 sides = body.box.size();
            QVERIFY(std::abs(body.volume - sides.x * sides.y * sides.z) < 1e-4 * body.volume);
        }
    }

    void namesAreKeptAndWhatIsLostIsSaid() {
        const Result<Model> obj = read(cubeObj());
        QVERIFY(obj && obj->bodies[0].name == "big" && obj->bodies[1].name == "small");
        QVERIFY(std::ranges::any_of(
            obj->notes, [](const ImportNote& note) { return note.text.find("colours.mtl") != std::string::npos; }));
        const Result<Model> mf = read(zipped(model3mf(""), "3D/3dmodel.model"));
        QVERIFY(mf && mf->bodies[0].name.find("bracket") != std::string::npos);
    }

    void theUnitOfOneWithoutIsAsked() {
        ImportOptions asked = options();
        asked.fileUnit = 25.4;
        for (const QByteArray& content : {boxPly(), boxOff(), cubeObj()}) {
            const Result<Model> model = read(content, asked);
            QVERIFY(model && std::abs(model->box().size().z - 762.0) < 1e-3);
        }
        const Result<Model> stated = read(boxAmf(" unit=\"millimeter\""), asked);
        QVERIFY(stated && std::abs(stated->box().size().z - 3.0) < 1e-6); // the unit is stated in the file
    }

    void whatIsDamagedIsRefused_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("a PLY that ends in its faces") << boxPly(2000);
        QTest::newRow("a PLY that ends in its head") << boxPly().left(60);
        QTest::newRow("a binary PLY that is cut off") << binaryPly().left(230);
        QTest::newRow("an OFF that ends in its faces") << boxOff().replace("8 6 12", "8 600 12");
        QTest::newRow("an OFF without counts") << QByteArray("OFF\n# nothing\n");
        QTest::newRow("an AMF that is cut off") << boxAmf("").left(700);
        QTest::newRow("an AMF of a strange unit") << boxAmf(" unit=\"furlong\"");
        QTest::newRow("a 3MF of a strange unit") << zipped(model3mf(" unit=\"furlong\""), "3D/3dmodel.model");
        QTest::newRow("a 3MF that is cut off")
            << zipped(model3mf(""), "3D/3dmodel.model").left(zipped(model3mf(""), "3D/3dmodel.model").size() / 2);
        QTest::newRow("an OBJ whose faces name no places")
            << QByteArray("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\nf 7 8 9\n");
        QTest::newRow("an OBJ of one triangle") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    void whatIsDamagedIsRefused() {
        QFETCH(QByteArray, content);
        const Result<Model> model = read(content);
        QVERIFY(!model);
        QVERIFY2(model.error().code == ErrorCode::fileDamaged || model.error().code == ErrorCode::modelHasNoSolid,
                 describe(model.error()).c_str());
    }

private:
    Result<Model> read(const QByteArray& content, const ImportOptions& asked = options()) {
        const QString file = folder_.filePath("model.any"); // the content decides
        QFile stream(file);
        if (!stream.open(QIODevice::WriteOnly) || stream.write(content) != content.size())
            return Error{ErrorCode::fileNotWritable, file.toStdString(), {}, {}};
        stream.close();
        Progress progress;
        return importModel(file.toStdString(), asked, progress);
    }

    QTemporaryDir folder_;
};

BURIN_TEST(MeshFormats, NoApplication)

} // namespace burin::tst_mesh_formats

#include "tst_mesh_formats.moc"
