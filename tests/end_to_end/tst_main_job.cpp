// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "part_judge.h"
#include "program_run.h"

#include "core/base/units.h"
#include "core/document/project.h"
#include "core/tool/tool.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_main_job {

namespace {

/// Whether a point is above the part's outline, offset inwards by the radius. From z = 0 up the sample part is a column
/// over its base, so its outline is that of a section just above the base.
bool overShrunkOutline(const MeshDistance& part, const glm::dvec3& tip, double radius) {
    constexpr int directions = 24;
    for (int i = 0; i < directions; ++i) {
        const double angle = 2.0 * pi * i / directions;
        if (part.closest({tip.x + radius * std::cos(angle), tip.y + radius * std::sin(angle), 0.3}).signedDistance >=
            0.0)
            return false;
    }
    return true;
}

} // namespace

/// `burin demo` as a new user starts it, judged by independent programs.
class MainJobTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void answersWithEveryFigure();
    void leavesFilesBehind();
    void pictureShowsPartStockAndTool();
    void volumesAgree();
    void interpreterAcceptsTheProgramAndNothingGouges();
    void finishingLiesOnThePart();
    void proxyNeverEntersThePart();
    void bringsOutTheProjectAgain();

private:
    QTemporaryDir folder_;
    QJsonObject answer_;
    std::optional<PartJudge> judge_;
    std::vector<ToolSample> samples_;
};

void MainJobTest::initTestCase() {
    const ProgramRun run = runBurin({"demo", "--json", "--output", folder_.filePath("out")});
    QVERIFY2(run.status == 0, run.messages.constData());
    QVERIFY2(run.messages.isEmpty(), run.messages.constData());
    answer_ = run.json();
    judge_ = PartJudge::of(BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", 3.0);
    QVERIFY(judge_);
}

void MainJobTest::answersWithEveryFigure() {
    for (const char* key : {"program", "project", "picture", "gouge_max_mm", "excess_max_mm", "removed_mm3", "ticks",
                            "tick_us_p50", "tick_us_p999", "samples", "blocks", "work_offset_mm", "tool"})
        QVERIFY2(answer_.contains(key), key);
    QCOMPARE(answer_["tool"].toObject()["type"].toString(), QString("ball"));
    QCOMPARE(answer_["tool"].toObject()["diameter_mm"].toDouble(), 6.0);
    QVERIFY(answer_["gouge_max_mm"].toDouble() <= 0.02);
    QCOMPARE(answer_["ticks"].toInteger(), answer_["samples"].toInteger());
    QVERIFY(answer_["blocks"].toInteger() > 1000);
}

void MainJobTest::leavesFilesBehind() {
    for (const char* key : {"program", "project", "picture", "report"}) {
        const QFileInfo file(answer_[key].toString());
        QVERIFY2(file.isAbsolute() && file.size() > 1000, key);
    }
}

void MainJobTest::pictureShowsPartStockAndTool() {
    const QImage picture(answer_["picture"].toString(), "PNG");
    QVERIFY(picture.width() >= 1280 && picture.height() >= 800);
    // The bare part is blue, the stock is pale, the background dark: each covers a good share of the picture.
    int blue = 0, pale = 0, dark = 0;
    for (int y = 0; y < picture.height(); y += 4)
        for (int x = 0; x < picture.width(); x += 4) {
            const QColor colour = picture.pixelColor(x, y);
            if (colour.blue() > colour.red() + 40 && colour.blue() > 70)
                ++blue;
            else if (colour.lightness() > 110)
                ++pale;
            else if (colour.lightness() < 70)
                ++dark;
        }
    const int all = (picture.width() / 4) * (picture.height() / 4);
    QVERIFY2(blue > all / 40, qPrintable(QString::number(blue)));
    QVERIFY2(pale > all / 60, qPrintable(QString::number(pale)));
    QVERIFY2(dark > all / 5, qPrintable(QString::number(dark)));
}

void MainJobTest::volumesAgree() {
    const double exact = judge_->model().bodies.front().volume; // OpenCASCADE's integral over the B-rep
    QVERIFY(std::abs(answer_["part_volume_mm3"].toDouble() - exact) <= 0.005 * exact);
    const double removed = answer_["removed_mm3"].toDouble(), drop = answer_["workpiece_drop_mm3"].toDouble();
    QVERIFY(removed > 1000.0);
    QVERIFY(std::abs(removed - drop) <= 1e-9 * drop);
}

void MainJobTest::interpreterAcceptsTheProgramAndNothingGouges() {
    const auto moves = canonicalMoves(answer_["program"].toString(), folder_.path(),
                                      answer_["tool"].toObject()["number"].toInt(), 6.0);
    QVERIFY2(moves.has_value(), "rs274 refused the program");
    const QJsonArray offset = answer_["work_offset_mm"].toArray();
    samples_ = judge_->along(*moves, {offset[0].toDouble(), offset[1].toDouble(), offset[2].toDouble()});
    QVERIFY(samples_.size() > 100'000);
    const std::optional<double> gouge = judge_->exactGouge(samples_, 500);
    QVERIFY(gouge);
    QVERIFY2(*gouge <= 0.02, qPrintable(QString("gouge %1 mm").arg(*gouge)));
    double clearance = 1e9;
    for (const ToolSample& sample : samples_) clearance = std::min(clearance, sample.clearance);
    QVERIFY2(clearance >= -0.02, qPrintable(QString("gouge %1 mm on the mesh").arg(-clearance)));
}

void MainJobTest::finishingLiesOnThePart() {
    QVERIFY(!samples_.empty());
    std::size_t all = 0, onPart = 0;
    for (std::size_t i = 0; i < samples_.size(); i += 5) { // every half millimetre, which is enough for a share
        const ToolSample& sample = samples_[i];
        if (!sample.cutting || !overShrunkOutline(judge_->part(), sample.tip, 3.0)) continue;
        ++all;
        if (sample.clearance <= 0.1) ++onPart;
    }
    QVERIFY(all > 10'000);
    const double share = static_cast<double>(onPart) / static_cast<double>(all);
    QVERIFY2(share >= 0.9, qPrintable(QString("%1 of %2 samples").arg(share).arg(all)));
    QVERIFY(std::abs(share - answer_["on_part_share"].toDouble()) < 0.02);
}

void MainJobTest::proxyNeverEntersThePart() {
    const Result<Project> project = Project::open(answer_["project"].toString().toStdString());
    QVERIFY(project);
    const Tool tool = loadTool("ball-6").value();
    const double voxel = answer_["voxel_mm"].toDouble();
    const auto takes = project->takes().value();
    QCOMPARE(takes.size(), std::size_t(2));
    QCOMPARE(takes[0].allowance, 0.5);
    QCOMPARE(takes[1].allowance, 0.0);
    for (const TakeInfo& info : takes) {
        const Take take = project->take(info.id).value();
        double deepestPress = 0.0;
        for (const Sample& sample : take.samples)
            deepestPress = std::max(deepestPress, glm::length(sample.stylusTip - sample.proxy.tip));
        const double deepest = judge_->deepestProxy(take, tool);
        QVERIFY2(deepest <= 0.05 * voxel - info.allowance, qPrintable(QString("%1 mm").arg(deepest)));
        if (info.allowance == 0.0) QVERIFY(deepestPress > 1.5); // it was the push-back that protected the part
    }
}

void MainJobTest::bringsOutTheProjectAgain() {
    const ProgramRun run = runBurin({"info", answer_["project"].toString(), "--json"});
    QCOMPARE(run.status, 0);
    const QJsonObject info = run.json();
    QCOMPARE(info["samples"].toInteger(), answer_["samples"].toInteger());
    QCOMPARE(info["takes"].toArray().size(), 2);
    QCOMPARE(info["paths"].toArray().size(), 1);
    QCOMPARE(info["programs"].toArray().size(), 1);
    QCOMPARE(info["recovered"].toBool(), false);
}

BURIN_TEST(MainJobTest, QCoreApplication)

} // namespace burin::tst_main_job

#include "tst_main_job.moc"
