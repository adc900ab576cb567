// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/bench_fixture.h"
#include "ui/scene/viewport.h"

#include <QDir>
#include <QSignalSpy>
#include <QTest>

using namespace burin;

namespace {

constexpr const char* screenshots = BURIN_BUILD_DIRECTORY "/tests/screenshots/";
const Box stock{{-30.0, -22.0, -4.0}, {30.0, 22.0, 18.0}};

} // namespace

class TestViewport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QDir().mkpath(QString::fromLatin1(screenshots));
        viewport_ = std::make_unique<Viewport>();
        viewport_->resize(1000, 700);
        viewport_->setPalette3D(fixture::palette());
        viewport_->setPart(fixture::model({24.0, 16.0, 14.0}));
        viewport_->setStockOutline(stock);
        viewport_->setTool(fixture::ballTool());
        ToolMarks marks;
        marks.proxy.tip = {6.0, -4.0, 20.0};
        viewport_->setToolMarks(marks);
        viewport_->show();
        QVERIFY(QTest::qWaitForWindowExposed(viewport_.get()));
        QTest::qWait(600);
        save("viewport-part");
    }
    void something() { QVERIFY(viewport_->statistics().frames > 0); }
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
