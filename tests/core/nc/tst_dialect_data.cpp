// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/base/resource_folder.h"
#include "core/nc/dialect_data.h"
#include "tests/core/nc/dialect_jobs.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

namespace burin::tst_dialect_data {

namespace {

QByteArray shipped(const char* id) {
    const auto text =
        readFile(std::filesystem::path(BURIN_SOURCE_DIRECTORY) / "resources/dialects" / (std::string(id) + ".json"));
    return text ? QByteArray::fromStdString(*text) : QByteArray();
}

} // namespace

class TestDialectData : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        qputenv("XDG_DATA_HOME", folder_.path().toLocal8Bit());
    }

    void theShippedOnesAreRead() {
        const DialectList all = dialects();
        QVERIFY2(all.faults.empty(), all.faults.empty() ? "" : all.faults.front().subject.c_str());
        QStringList ids;
        for (const DialectDescription& one : all.known) {
            ids << QString::fromStdString(one.id);
            QVERIFY(one.library.empty() && one.control == one.id && &controlOfDialect(one.id) == findControl(one.id));
        }
        QCOMPARE(ids, (QStringList{"fanuc", "grbl", "grblhal", "haas", "linuxcnc", "mach"}));
    }

    void faultsNameFileKeyAndRemedy_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("remedy");
        const auto row = [](const char* name, const char* from, const char* to, const char* key, const char* remedy) {
            QTest::newRow(name) << QByteArray(from) << QByteArray(to) << key << remedy;
        };
        row("too many decimals", "\"decimals\": 3", "\"decimals\": 9", "numbers.millimetre.decimals",
            "has to be a whole number from 1 to 6");
        row("a key missing", "\"rapid\": \"G0\",", "", "words.rapid", "is missing");
        row("a key that is not known", "\"rapid\": \"G0\"", "\"rapid\": \"G0\", \"rapids\": \"G0\"", "words.rapids",
            "is not known");
        row("a key twice", "\"rapid\": \"G0\"", "\"rapid\": \"G0\", \"rapid\": \"G00\"", "rapid", "stands twice");
        row("a control that nobody knows", "\"control\": \"linuxcnc\"", "\"control\": \"siemens\"", "control",
            "has to be one of: linuxcnc, grbl, grblhal, fanuc, haas, mach");
        row("a word of a block", "T{tool} M6", "T{tols} M6", "tool_change[1]", "has {tols}, which is none of {units}");
        row("a brace left open", "T{tool} M6", "T{tool M6", "tool_change[1]", "has {tool M6}, which is none of");
        row("comments within a block", "[\"{comments}\"", "[\"O1 {comments}\"", "begin[0]",
            "has more than {comments}, which has to stand alone");
        row("a tool's comment within a block", "T{tool} M6", "T{tool} M6 {tool_comment}", "tool_change[1]",
            "has more than {tool_comment}, which has to stand alone");
        row("a dwell without its time", "G4 P{seconds}", "G4 P3", "words.dwell",
            "has to hold one of {seconds}, {milliseconds}");
        row("a work offset without its number", "G{offset}", "G54", "words.work_offset", "has to hold one of {offset}");
        row("a sweep beyond a turn", "\"largest_sweep_deg\": 360", "\"largest_sweep_deg\": 361",
            "arcs.largest_sweep_deg", "has to be a number from 30 to 360");
        row("a block that is no text", "[\"M2\"]", "[2]", "end[0]", "has to be a text that is not empty");
        row("blocks that are no list", "[\"M2\"]", "\"M2\"", "end", "has to be a list of texts");
        row("a truth that is none", "\"changes_tools\": true", "\"changes_tools\": 1", "changes_tools",
            "has to be true or false");
        row("two lines in one", "\"M5\", \"M9\"", "\"M5\\nM9\"", "tool_end[0]", "has to be one line");
    }
    void faultsNameFileKeyAndRemedy() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, key);
        QFETCH(QString, remedy);
        QByteArray text = shipped("linuxcnc");
        QVERIFY(text.contains(from));
        const qsizetype at = text.indexOf(from);
        text.replace(at, from.size(), to);
        const auto dialect = dialectFromJson(text.toStdString(), "mine.json");
        QVERIFY(!dialect);
        QCOMPARE(dialect.error().code, ErrorCode::resourceInvalid);
        QCOMPARE(QString::fromStdString(dialect.error().subject), "mine.json");
        QCOMPARE(QString::fromStdString(dialect.error().place), key);
        QVERIFY2(QString::fromStdString(dialect.error().detail).startsWith(remedy), dialect.error().detail.c_str());
    }

    void theUsersOwnReplacesOurs() {
        QByteArray text = shipped("linuxcnc");
        text.replace("[\"M2\"]", "[\"M30\"]").replace("\"number_step\": 0", "\"number_step\": 10");
        const std::filesystem::path file = userResourceDirectory(dialectResource) / "linuxcnc.json";
        std::filesystem::create_directories(file.parent_path());
        QVERIFY(writeFileAtomically(file, text.toStdString()));
        const auto written = posted("linuxcnc", referenceJob(NcUnits::millimetre, 1));
        std::filesystem::remove(file);
        QVERIFY(written);
        QVERIFY(written->find("\nN10 G17 G21 G40 G49\nN20 G54") != std::string::npos);
        QVERIFY(written->ends_with(" M30\n"));
    }

    void theUsersOwnStandsBesideOurs() {
        QByteArray text = shipped("grbl");
        text.replace("\"id\": \"grbl\"", "\"id\": \"my-router\"")
            .replace("\"leading_zero\": true", "\"leading_zero\": false");
        const std::filesystem::path file = userResourceDirectory(dialectResource) / "my-router.json";
        std::filesystem::create_directories(file.parent_path());
        QVERIFY(writeFileAtomically(file, text.toStdString()));
        const DialectList all = dialects();
        const auto written = posted("my-router", referenceJob(NcUnits::inch, 1));
        const Control& control = controlOfDialect("my-router");
        std::filesystem::remove(file);
        QVERIFY(all.faults.empty());
        QCOMPARE(all.known.size(), std::size_t{7});
        QVERIFY(written);
        QVERIFY(written->find("X-.1969 Y.4860") != std::string::npos);
        QVERIFY(&control == findControl("grbl"));
    }

    /// A number that is broken in two would be another number; and no line may begin like a command to the control.
    void longCommentsAreBrokenBetweenWords() {
        NcProgram job = referenceJob(NcUnits::millimetre, 1);
        job.header = {"Program zero in the frame of the model X5.000 Y5.000 Z14.000",
                      "Whatever fills a line, the next one begins as DEBUG, #1 and is a comment all the same"};
        MachineProfile machine = roomyMachine();
        for (const char* dialect : {"haas", "grbl", "linuxcnc"})
            for (machine.maximumLineLength = 50; machine.maximumLineLength < 80; ++machine.maximumLineLength) {
                const auto text = posted(dialect, job, machine);
                QVERIFY(text);
                for (const char* figure : {"X5.000", "Y5.000", "Z14.000"})
                    QVERIFY2(text->find(figure) != std::string::npos, text->c_str());
                QVERIFY2(text->find("(DEBUG,") == std::string::npos, text->c_str());
            }
    }

    void aUsersFaultyDialectIsNamed() {
        const std::filesystem::path file = userResourceDirectory(dialectResource) / "broken.json";
        std::filesystem::create_directories(file.parent_path());
        QVERIFY(writeFileAtomically(file, "{\"id\": \"broken\"}"));
        const auto post = loadDialect("broken");
        const DialectList all = dialects();
        std::filesystem::remove(file);
        QCOMPARE(all.known.size(), std::size_t{6}); // the others stay
        QCOMPARE(all.faults.size(), std::size_t{1});
        QCOMPARE(all.faults.front().subject, file.string());
        QVERIFY(!post);
        QCOMPARE(post.error().code, ErrorCode::resourceInvalid);
        QCOMPARE(post.error().subject, file.string());
    }

    void anUnknownOneListsThoseThereAre() {
        const auto post = loadDialect("siemens840d");
        QVERIFY(!post);
        QCOMPARE(post.error().code, ErrorCode::dialectNotFound);
        QCOMPARE(QString::fromStdString(post.error().detail), "fanuc grbl grblhal haas linuxcnc mach");
    }

private:
    QTemporaryDir folder_;
};

BURIN_TEST(TestDialectData, QCoreApplication)

} // namespace burin::tst_dialect_data

#include "tst_dialect_data.moc"
