// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/recording/take_csv.h"
#include "core/recording/trace_file.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <span>
#include <utility>

namespace burin::tst_take {

namespace {

/// A tool that moves 1 mm along x per 2 ms tick, cuts two materials and rests on the part in the end.
std::vector<Sample> samples() {
    std::vector<Sample> list(4);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].tick = 10 + i;
        list[i].time = 0.002 * static_cast<double>(i);
        list[i].proxy.tip = {static_cast<double>(i), 0.0, 5.0};
        list[i].stylusTip = {static_cast<double>(i), 0.0, 5.0};
    }
    list[1].removed[0] = {100, 3};
    list[1].removed[1] = {7, 2};
    list[2].removed[0] = {23, 3};
    list[2].cuttingForce = {30.0, 40.0, 0.0};
    list[2].reportedRemoval = 0.25;
    list[3].stylusTip.z = 3.0;
    list[3].force = {0.0, 0.0, 1.5};
    list[3].torque = {0.0, -12.5, 0.0};
    list[3].flags = sampleOnBoundary | sampleForceSaturated;
    list[3].tick = 15; // two ticks were lost
    return list;
}

/// Samples in parts of a few, as a project provides them.
SampleSource sourceOf(std::vector<Sample> samples, std::size_t part = 3000) {
    return [samples = std::move(samples), part](const SampleVisitor& visit) -> Result<void> {
        for (std::span<const Sample> rest(samples); !rest.empty(); rest = rest.subspan(std::min(part, rest.size())))
            if (Result<void> visited = visit(rest.first(std::min(part, rest.size()))); !visited) return visited;
        return {};
    };
}

QList<QByteArray> lines(const std::string& text) {
    QList<QByteArray> result = QByteArray::fromStdString(text).split('\n');
    result.removeLast(); // the text ends with a line end
    return result;
}

} // namespace

class TakeTest final : public QObject {
    Q_OBJECT
private slots:
    void valuesStandUnderTheirNames();
    void longTakesAreWrittenWhole();
    void aMaterialThatIsRemovedLateHasItsColumnFromTheStart();
    void aTraceOfATakeIsWhatTheStylusDid();
    void whatEndsTheSamplesLeavesNoFile();
    void aFolderThatIsMissingIsNamed();
};

void TakeTest::valuesStandUnderTheirNames() {
    const QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "take.csv";
    QVERIFY(writeTakeCsv(file, sourceOf(samples()), {"air", "wax", "aluminium-6061"}));
    const QList<QByteArray> text = lines(*readFile(file));
    QCOMPARE(text.size(), 5);
    const QList<QByteArray> names = text[0].split(',');
    for (const QByteArray& line : text) QCOMPARE(line.split(',').size(), names.size());
    const auto value = [&](int row, const char* name) { return text[row].split(',').at(names.indexOf(name)); };
    QCOMPARE(value(1, "tick"), QByteArray("10"));
    QCOMPARE(value(2, "time_s"), QByteArray("0.002"));
    QCOMPARE(value(2, "device_qw"), QByteArray("1"));
    QCOMPARE(value(3, "tool_x_mm"), QByteArray("2"));
    QCOMPARE(value(4, "stylus_z_mm"), QByteArray("3"));
    QCOMPARE(value(4, "axis_z"), QByteArray("1"));
    QCOMPARE(value(4, "force_z_n"), QByteArray("1.5"));
    QCOMPARE(value(4, "torque_y_n_mm"), QByteArray("-12.5"));
    QCOMPARE(value(3, "torque_y_n_mm"), QByteArray("0"));
    QCOMPARE(value(3, "cutting_force_y_n"), QByteArray("40"));
    QCOMPARE(value(3, "reported_removal_mm3"), QByteArray("0.25"));
    QCOMPARE(value(4, "flags"), QByteArray("6"));
    QCOMPARE(value(2, "removed_units_aluminium-6061"), QByteArray("7"));
    QCOMPARE(value(2, "removed_units_property_3"), QByteArray("100")); // a material without a name
    QCOMPARE(value(3, "removed_units_aluminium-6061"), QByteArray("0"));
}

void TakeTest::longTakesAreWrittenWhole() {
    std::vector<Sample> list(30000); // several parts
    for (std::size_t i = 0; i < list.size(); ++i) list[i].tick = i;
    const QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "take.csv";
    QVERIFY(writeTakeCsv(file, sourceOf(list), {}));
    const QList<QByteArray> text = lines(*readFile(file));
    QCOMPARE(text.size(), 30001);
    for (int i = 1; i < text.size(); ++i) QVERIFY(text[i].startsWith(QByteArray::number(i - 1) + ","));
}

void TakeTest::aMaterialThatIsRemovedLateHasItsColumnFromTheStart() {
    const QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "take.csv";
    QVERIFY(writeTakeCsv(file, sourceOf(samples(), 1), {"air", "wax", "foam, \"soft\"", "steel-c45"}));
    const QList<QByteArray> text = lines(*readFile(file));
    QVERIFY(text[0].endsWith(R"(,"removed_units_foam, ""soft""",removed_units_steel-c45)"));
    QVERIFY(text[1].endsWith(",0,0"));
    QVERIFY(text[2].endsWith(",7,100"));
    QVERIFY(text[3].endsWith(",0,23"));
}

void TakeTest::aTraceOfATakeIsWhatTheStylusDid() {
    std::vector<Sample> list = samples();
    for (Sample& sample : list) sample.device.position = {0.1 * static_cast<double>(sample.tick), 1.0 / 3.0, -2.0};
    list[2].flags |= sampleStylusInvalid;
    const QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "trace.csv";
    QVERIFY(writeTakeTrace(file, sourceOf(list, 2)));
    QCOMPARE(*readFile(file), formatTrace(traceOf(list)));
    const auto read = readTrace(file);
    QVERIFY(read);
    QCOMPARE(read->readings.size(), std::size_t{3}); // one was invalid
    QVERIFY(read->readings[2].pose.position == list[3].device.position);
}

void TakeTest::whatEndsTheSamplesLeavesNoFile() {
    const QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "take.csv";
    const SampleSource breaksOff = [](const SampleVisitor& visit) -> Result<void> {
        if (Result<void> visited = visit(samples()); !visited) return visited;
        return Error{ErrorCode::fileDamaged, "p.burin", "take 1, sample 4", ""};
    };
    for (const auto& written : {writeTakeCsv(file, breaksOff, {}), writeTakeTrace(file, breaksOff)}) {
        QVERIFY(!written);
        QCOMPARE(written.error().place, std::string("take 1, sample 4"));
    }
    QVERIFY(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).isEmpty());
}

void TakeTest::aFolderThatIsMissingIsNamed() {
    const auto written = writeTakeCsv("/nowhere/at/all/take.csv", sourceOf(samples()), {});
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::fileNotWritable);
    QCOMPARE(written.error().subject, std::string("/nowhere/at/all/take.csv"));
}

BURIN_TEST(TakeTest, NoApplication)

} // namespace burin::tst_take

#include "tst_take.moc"
