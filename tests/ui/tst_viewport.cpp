// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/bench_fixture.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTest>

using namespace burin;

namespace {

constexpr const char* screenshots = BURIN_BUILD_DIRECTORY "/tests/screenshots/";
const Box stock{{-30.0, -22.0, -4.0}, {30.0, 22.0, 18.0}};
const glm::dvec3 radii{24.0, 16.0, 14.0};

ToolMarks marksAt(const glm::dvec3& tip) {
    ToolMarks marks;
    marks.proxy.tip = tip;
    marks.stylusTip = tip;
    return marks;
}

std::vector<glm::vec3> wave(float x) {
    std::vector<glm::vec3> tips;
    for (int i = 0; i <= 400; ++i) {
        const float y = -16.0F + 0.08F * static_cast<float>(i);
        const float inside = 1.0F - x * x / 576.0F - y * y / 256.0F;
        tips.emplace_back(x, y, std::max(4.0F, 14.0F * std::sqrt(std::max(0.0F, inside))));
    }
    return tips;
}

} // namespace

class TestViewport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QDir().mkpath(QString::fromLatin1(screenshots));
        viewport_ = std::make_unique<Viewport>();
        viewport_->resize(1000, 700);
        viewport_->setPalette3D(fixture::palette());
        viewport_->setPart(fixture::model(radii));
        viewport_->setStockOutline(stock);
        viewport_->setTool(fixture::ballTool());
        viewport_->setToolMarks(marksAt({6.0, -4.0, 20.0}));
        viewport_->show();
        QVERIFY(QTest::qWaitForWindowExposed(viewport_.get()));
        QTest::qWait(600);
        save("viewport-part");
    }

    void showsTheBench() {
        RunVolume volume = fixture::milledBlock(stock, 0.25, radii);
        viewport_->setWorkpiece(volume.snapshot());
        ToolMarks marks = marksAt({-3.0, -5.0, 13.0});
        marks.stylusTip = {-3.0, -5.0, 10.0};
        marks.force = {-0.9, -0.6, 1.4};
        marks.ghost = true;
        viewport_->setToolMarks(marks);
        for (float x = -20.0F; x < -2.0F; x += 3.0F) viewport_->appendLivePath(wave(x), true);
        QTRY_VERIFY_WITH_TIMEOUT(viewport_->statistics().fullDetail, 5000);
        QTest::qWait(100);
        save("viewport-bench");
        const FrameStatistics statistics = viewport_->statistics();
        qInfo("paint max %.1f p95 %.1f ms, %zu triangles", statistics.paintMaximum, statistics.paintP95,
              statistics.triangles);
        marks.alarm = true;
        viewport_->setToolMarks(marks);
        QTest::qWait(60);
        save("viewport-alarm");
        marks.alarm = false;
        viewport_->setToolMarks(marks);
    }
    void cleanupTestCase() { viewport_.reset(); }

private:
    void save(const char* name) {
        const QString ratio = viewport_->devicePixelRatio() > 1.5 ? QStringLiteral("@2x") : QString();
        QVERIFY(viewport_->grabFramebuffer().save(QString::fromLatin1(screenshots) + QString::fromLatin1(name) + ratio +
                                                  QStringLiteral(".png")));
    }
    std::unique_ptr<Viewport> viewport_;
};

QTEST_MAIN(TestViewport)
#include "tst_viewport.moc"
