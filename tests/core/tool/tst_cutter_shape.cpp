// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/tool/cutter_shape.h"
#include "core/tool/holder_library.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_cutter_shape {

namespace {

double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) * 1e-6;
}

CutterType randomType() {
    return static_cast<CutterType>(*rc::gen::inRange(0, static_cast<int>(CutterType::profile)));
}

Tool toolOf(const Cutter& cutter) {
    Tool tool;
    tool.id = "t";
    tool.cutter = cutter;
    tool.maximumDepthOfCut = 0.5 * cutter.fluteLength;
    return tool;
}

} // namespace

/// Values of a cutter that depend on its type.
class TestCutterShape : public QObject {
    Q_OBJECT
private slots:
    /// Whatever was entered for one type, and whichever comes next, the tool is valid.
    void everyTypeFollowsEveryOther() {
        QVERIFY(rc::check([] {
            Cutter cutter;
            cutter.type = randomType();
            cutter.diameter = real(0.1, 30.0);
            cutter.cornerRadius = real(0.0, 20.0);
            cutter.tipDiameter = real(0.0, 40.0);
            cutter.taperAngle = real(0.0, 1.6);
            cutter.fluteLength = real(0.1, 60.0);
            cutter.shankDiameter = real(0.1, 30.0);
            cutter.stickOut = real(0.1, 100.0);
            for (int i = 0; i < 4; ++i) {
                cutter = fitted(cutter);
                const Result<void> valid = validate(toolOf(cutter));
                if (!valid) qWarning("%s: %s", valid.error().subject.c_str(), valid.error().detail.c_str());
                RC_ASSERT(valid.hasValue());
                const Cutter again = fitted(cutter);
                RC_ASSERT(again.cornerRadius == cutter.cornerRadius && again.fluteLength == cutter.fluteLength &&
                          again.taperAngle == cutter.taperAngle && again.tipDiameter == cutter.tipDiameter);
                cutter.type = randomType();
            }
        }));
    }

    /// Values that fit are kept: every shipped tool is unchanged.
    void shippedToolsStay() {
        QVERIFY(toolIds().size() >= 60);
        for (const std::string& id : toolIds()) {
            const Result<Tool> tool = loadTool(id);
            QVERIFY2(tool, id.c_str());
            Tool same = *tool;
            same.cutter = fitted(same.cutter);
            QCOMPARE(QString::fromStdString(toJson(same)), QString::fromStdString(toJson(*tool)));
        }
    }

    /// Of so many ids only similar ones are suggested.
    void anUnknownToolNamesThoseLikeIt() {
        const Result<Tool> none = loadTool("flat-4.0");
        QVERIFY(!none);
        QCOMPARE(none.error().code, ErrorCode::nameUnknown);
        const QStringList named = QString::fromStdString(none.error().detail).split(", ");
        QVERIFY(named.size() < 12 && named.contains("flat-4"));
    }

    void holdersAreRead() {
        QVERIFY(holderIds().size() >= 8);
        for (const std::string& id : holderIds()) {
            const Result<Holder> holder = loadHolder(id);
            QVERIFY2(holder, id.c_str());
            for (std::size_t i = 1; i < holder->segments.size(); ++i) QVERIFY(holder->segments[i].length > 0.0);
            QVERIFY(!holder->source.empty());
        }
    }

    void aHolderThatIsNoneIsRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("no segment") << QByteArray(R"({"id": "h", "name": "H", "source": "s", "segments": []})");
        QTest::newRow("no length") << QByteArray(
            R"({"id": "h", "name": "H", "source": "s", "segments": [{"lower_diameter_mm": 1, "upper_diameter_mm": 1, "length_mm": 0}]})");
        QTest::newRow("no list") << QByteArray(R"({"id": "h", "name": "H", "source": "s"})");
        QTest::newRow("no JSON") << QByteArray("holder");
    }
    void aHolderThatIsNoneIsRefused() {
        QFETCH(QByteArray, text);
        const Result<Holder> holder = holderFromJson(text.toStdString(), "h.json");
        QVERIFY(!holder);
        QCOMPARE(holder.error().code, ErrorCode::resourceInvalid);
    }
};

BURIN_TEST(TestCutterShape, NoApplication)

} // namespace burin::tst_cutter_shape

#include "tst_cutter_shape.moc"
