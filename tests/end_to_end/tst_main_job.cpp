// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "program_run.h"

#include "core/base/units.h"
#include "core/cad/import.h"
#include "core/geometry/mesh_distance.h"
#include "core/project/project.h"
#include "core/tool/tool.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace burin;

namespace {

struct ToolSample {
    glm::dvec3 tip{0.0};
    bool cutting = false; ///< at the cutting feed
    double clearance = 0.0;
};

/// Places every 0.1 mm along the moves, in the model's frame. The first moves come from nowhere.
std::vector<ToolSample> samplesAlong(const std::vector<CanonicalMove>& moves, const glm::dvec3& workOffset) {
    double cuttingFeed = 0.0;
    for (const CanonicalMove& move : moves) cuttingFeed = std::max(cuttingFeed, move.feed);
    std::vector<ToolSample> samples;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        const glm::dvec3 from = moves[i - 1].to, to = moves[i].to;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / 0.1)));
        for (int step = 1; step <= steps; ++step)
            samples.push_back({glm::mix(from, to, static_cast<double>(step) / steps) + workOffset,
                               !moves[i].rapid && moves[i].feed == cuttingFeed, 0.0});
    }
    return samples;
}

/// Is a place over the part's outline, shrunk by the radius? The sample part is a column over its base from z = 0 up,
/// so its outline is that of a cut just above the base.
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

/// `burin demo` as a new user starts it, judged by others than Burin.
class MainJobTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void answersWithEveryFigure();
    void leavesFilesBehind();
    void volumesAgree();
    void interpreterAcceptsTheProgramAndNothingGouges();
    void finishingLiesOnThePart();
    void proxyNeverEntersThePart();
    void bringsOutTheProjectAgain();

private:
    QTemporaryDir folder_;
    QJsonObject answer_;
    std::optional<Model> model_;
    std::optional<MeshDistance> part_;
    std::vector<ToolSample> samples_;
};

void MainJobTest::initTestCase() {
    const ProgramRun run = runBurin({"demo", "--json", "--output", folder_.filePath("out")});
    QVERIFY2(run.status == 0, run.messages.constData());
    QVERIFY2(run.messages.isEmpty(), run.messages.constData());
    answer_ = run.json();
    ImportOptions options;
    options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
    Progress progress;
    Result<Model> model = importModel(BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", options, progress);
    QVERIFY(model);
    model_ = std::move(*model);
    part_.emplace(model_->bodies.front().mesh);
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
    QFile picture(answer_["picture"].toString());
    QVERIFY(picture.open(QIODevice::ReadOnly));
    QVERIFY(picture.read(8) == QByteArray("\x89PNG\r\n\x1a\n", 8));
}

void MainJobTest::volumesAgree() {
    const double exact = model_->bodies.front().volume; // OpenCASCADE's integral over the B-rep
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
    samples_ = samplesAlong(*moves, {offset[0].toDouble(), offset[1].toDouble(), offset[2].toDouble()});
    QVERIFY(samples_.size() > 100'000);
    const RevolvedPiece cutter{0.0, 60.0, 3.0, 3.0, 3.0}; // ball and shank as one, 60 mm long
    for (ToolSample& sample : samples_)
        sample.clearance = part_->clearance({&cutter, 1}, ToolPose{sample.tip, {0.0, 0.0, 1.0}}, 2.0).clearance;

    std::vector<ToolSample> worst = samples_;
    const auto nearer = [](const ToolSample& a, const ToolSample& b) { return a.clearance < b.clearance; };
    std::nth_element(worst.begin(), worst.begin() + 500, worst.end(), nearer);
    std::vector<glm::dvec3> centres;
    for (std::size_t i = 0; i < 500; ++i) centres.push_back(worst[i].tip + glm::dvec3(0.0, 0.0, 3.0));
    ImportOptions options;
    options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
    Progress progress;
    const Result<std::vector<double>> distances = exactSignedDistances(model_->brep, centres, options, progress);
    QVERIFY(distances);
    double gouge = 0.0;
    for (const double distance : *distances) gouge = std::max(gouge, 3.0 - distance);
    QVERIFY2(gouge <= 0.02, qPrintable(QString("gouge %1 mm").arg(gouge)));
    QVERIFY2(-worst.front().clearance <= 0.02,
             qPrintable(QString("gouge %1 mm on the mesh").arg(-worst.front().clearance)));
}

void MainJobTest::finishingLiesOnThePart() {
    QVERIFY(!samples_.empty());
    std::size_t all = 0, onPart = 0;
    for (std::size_t i = 0; i < samples_.size(); i += 5) { // every half millimetre: enough for a share
        const ToolSample& sample = samples_[i];
        if (!sample.cutting || !overShrunkOutline(*part_, sample.tip, 3.0)) continue;
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
    const RevolvedPiece cutter = flutes(tool.cutter);
    const double voxel = answer_["voxel_mm"].toDouble();
    const auto takes = project->takes().value();
    QCOMPARE(takes.size(), std::size_t(2));
    QCOMPARE(takes[0].allowance, 0.5);
    QCOMPARE(takes[1].allowance, 0.0);
    for (const TakeInfo& info : takes) {
        const Take take = project->take(info.id).value();
        double deepest = -1e9, deepestPress = 0.0;
        for (const Sample& sample : take.samples) {
            deepest = std::max(deepest, -part_->clearance({&cutter, 1}, sample.proxy, 2.0).clearance);
            deepestPress = std::max(deepestPress, glm::length(sample.stylusTip - sample.proxy.tip));
        }
        QVERIFY2(deepest <= 0.05 * voxel - info.allowance, qPrintable(QString("%1 mm").arg(deepest)));
        if (info.allowance == 0.0) QVERIFY(deepestPress > 1.5); // the push-back does the work
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

QTEST_GUILESS_MAIN(MainJobTest)
#include "tst_main_job.moc"
