// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_sample {

using namespace burin::test;

class Sample : public QObject {
    Q_OBJECT

private:
    Result<Model> model_ = import(sampleFile());

private slots:
    void isOneClosedMouse() {
        QVERIFY2(model_, model_ ? "" : describe(model_.error()).c_str());
        QCOMPARE(model_->format, std::string("STEP AP214"));
        QCOMPARE(model_->lengthUnit, std::string("mm"));
        QCOMPARE(model_->bodies.size(), std::size_t{1});
        QCOMPARE(model_->bodies[0].name, std::string("mouse"));
        QCOMPARE(*model_->bodies[0].colour, (std::array<std::uint8_t, 3>{64, 115, 166})); // sRGB 0.25, 0.45, 0.65
        QCOMPARE(model_->bodies[0].openEdges, std::size_t{0});
        QVERIFY(!hasNote(*model_, ImportNote::Kind::warning));
        QVERIFY(!hasNote(*model_, ImportNote::Kind::healing));
        QVERIFY(QFileInfo(QString::fromStdString(sampleFile().string())).size() < 1'000'000);
    }
    void hasTheSizeOfAMouse() {
        QVERIFY(model_);
        const Box box = model_->box();
        QVERIFY(glm::length(box.size() - glm::dvec3(110.0, 60.0, 35.0)) < 0.2);
        QVERIFY(std::abs(box.low.z) < 1e-6);
        QVERIFY(std::abs(box.centre().x) < 0.1 && std::abs(box.centre().y) < 0.5);
    }
    void canBeMilledFromAbove() {
        // No face points down except the bottom: then each vertical line meets one piece that starts at z = 0.
        QVERIFY(model_);
        const TriangleMesh& mesh = model_->bodies[0].mesh;
        for (const auto& [a, b, c] : mesh.triangles) {
            const glm::dvec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
            if (std::max({p.z, q.z, r.z}) > 1e-6) QVERIFY(glm::cross(q - p, r - p).z >= 0.0);
        }
    }
    void isWhatItsProgramMakes() {
        QTemporaryDir folder;
        const QString file = folder.filePath("mouse.step");
        QProcess program;
        program.start(QStringLiteral(BURIN_BUILD_DIRECTORY "/burin-make-mouse-sample"), {file});
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitCode(), 0);
        const Result<Model> made = import(file.toStdString());
        QVERIFY(made && model_);
        QVERIFY(std::abs(made->volume() / model_->volume() - 1.0) < 1e-9);
        QVERIFY(glm::length(made->box().size() - model_->box().size()) < 1e-6);
        QCOMPARE(made->bodies[0].faceCount, model_->bodies[0].faceCount);
    }
};

BURIN_TEST(Sample, QCoreApplication)

} // namespace burin::tst_sample

#include "tst_sample.moc"
