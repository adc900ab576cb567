// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin::tst_takes {

/// Takes along their time, from the command line: switched off and on, continued from a moment, and the workpiece at a
/// moment.
class TakesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QCOMPARE(run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o",
                      milled_.filePath("p.burin"), "--voxel", "1"})
                     .status,
                 0);
        const ProgramRun milled =
            run({"mill", milled_.filePath("p.burin"), "--tool", "ball-6", "--intent", "scribble", "--seconds", "6"});
        QVERIFY2(milled.status == 0, milled.messages.constData());
        first_ = milled.json()["workpiece_hash"].toString();
        QCOMPARE(first_.size(), 16);
    }
    /// Each test begins with a copy of the same milled project.
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        for (const QString& name : QDir(milled_.path()).entryList(QDir::Files))
            QVERIFY(QFile::copy(milled_.filePath(name), folder_->filePath(name)));
    }

    /// Repeating the same job gives the same hash, and so does opening the project or replaying it from the recordings.
    void theSameRecordingsGiveTheSameHash() {
        QCOMPARE(hash({}), first_);
        QVERIFY(hash({"--stock"}) != first_);
        QCOMPARE(hash({"--at", "1:0"}), hash({"--stock"}));
        QCOMPARE(hash({"--at", "1"}), first_);
        QCOMPARE(hash({"--at", "1:2.5"}), hash({"--at", "1:2.5"}));
        QVERIFY(hash({"--at", "1:2.5"}) != first_);
        const QString other = in("again.burin");
        QVERIFY(QFile::copy(in("p.burin"), other)); // without the stored workpiece
        QCOMPARE(run({"take", "off", other, "1", "--to", "0.001"}).status, 0);
        QCOMPARE(run({"take", "on", other, "1"}).status, 0);
        QCOMPARE(run({"volume", "export", other, "-o", in("other.srle")}).json()["hash"].toString(), first_);
        QCOMPARE(run({"volume", "moments", in("other.srle")}).json()["hash"].toString(), first_);
    }

    void aTakeIsSwitchedOffAndOn() {
        const QString stock = hash({"--stock"});
        const ProgramRun off = run({"take", "off", in("p.burin"), "1"});
        QVERIFY2(off.status == 0, off.messages.constData());
        QCOMPARE(off.json()["switched_off"].toArray().size(), 1);
        QCOMPARE(hash({}), stock);
        QCOMPARE(
            run({"take", "on", in("p.burin"), "1", "--from", "2", "--to", "3"}).json()["switched_off"].toArray().size(),
            2);
        const QString some = hash({});
        QVERIFY(some != stock && some != first_);
        QCOMPARE(run({"take", "on", in("p.burin"), "1"}).json()["switched_off"].toArray().size(), 0);
        QCOMPARE(hash({}), first_);
        QCOMPARE(run({"take", "rename", in("p.burin"), "1", "crown"}).json()["name"].toString(), QString("crown"));
        QCOMPARE(run({"info", in("p.burin")}).json()["takes"].toArray()[0].toObject()["name"].toString(),
                 QString("crown"));
    }

    /// What was recorded after the moment is switched off, and can be switched on again on top.
    void millingGoesOnFromAMoment() {
        const QString then = hash({"--at", "1:2.5"});
        const ProgramRun on = mill({"--from", "1:2.5", "--intent", "scribble", "--seconds", "2", "--seed", "7"});
        QVERIFY2(on.status == 0, on.messages.constData());
        QCOMPARE(hash({}), on.json()["workpiece_hash"].toString());
        const QJsonArray takes = run({"info", in("p.burin")}).json()["takes"].toArray();
        QCOMPARE(takes.size(), 2);
        QVERIFY(takes[0].toObject()["samples_that_count_no_more"].toInt() > 1000);
        QCOMPARE(run({"take", "off", in("p.burin"), "2"}).status, 0);
        QCOMPARE(hash({}), then);
        QCOMPARE(run({"take", "on", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash({}), first_);
    }

    /// A take and its reference: the volume that each removed is the loss of the workpiece, the reference is scored
    /// although it is off, and the project does not change.
    void aTakeIsScoredBesideAReference() {
        QCOMPARE(run({"take", "off", in("p.burin"), "1"}).status, 0);
        const ProgramRun again = mill({"--intent", "scribble", "--seconds", "6"}); // same movements and stock
        QVERIFY2(again.status == 0, again.messages.constData());
        const QByteArray before = bytes();
        const ProgramRun scored = run({"take", "score", in("p.burin"), "2", "--reference", "1"});
        QVERIFY2(scored.status == 0, scored.messages.constData());
        const QJsonObject own = scored.json()["score"].toObject(), other = scored.json()["reference"].toObject();
        QCOMPARE(own["take"].toInt(), 2);
        QCOMPARE(other["take"].toInt(), 1);
        for (const char* key : {"duration_s", "milling_s", "smoothness_sparc", "mean_force_n", "peak_force_n",
                                "removed_mm3", "removal_rate_mm3_s", "stock_left_mean_mm", "stock_left_most_mm"}) {
            QVERIFY2(own[key].isDouble() && own[key] == other[key], key);
            const QJsonObject compared = scored.json()["comparison"].toObject()[key].toObject();
            QCOMPARE(compared["verdict"].toString(), QString("same"));
            QCOMPARE(compared["ratio"].toDouble(), 1.0);
        }
        QVERIFY(std::abs(own["duration_s"].toDouble() - 6.0) < 0.01);
        QVERIFY(own["smoothness_sparc"].toDouble() < -1.0);
        QVERIFY(std::abs(own["removed_mm3"].toDouble() - again.json()["removed_mm3"].toDouble()) < 1e-6);
        const ProgramRun alone = runBurin({"take", "score", in("p.burin"), "2"});
        QVERIFY(alone.status == 0 && alone.output.contains("Mean force: ") && !alone.output.contains("reference"));
        QCOMPARE(bytes(), before);
    }

    /// A value for every ten samples; the tool was held out of the part. The project does not change.
    void theDeviationIsMeasuredOverTime() {
        const QByteArray before = bytes();
        const ProgramRun measured = run({"take", "deviation", in("p.burin"), "1", "-o", in("deviation.csv")});
        QVERIFY2(measured.status == 0, measured.messages.constData());
        const QJsonObject answer = measured.json();
        const int samples = run({"info", in("p.burin")}).json()["takes"].toArray()[0].toObject()["samples"].toInt();
        QCOMPARE(answer["values"].toInt(), (samples + 9) / 10);
        const double least = answer["least_mm"].toDouble(), greatest = answer["greatest_mm"].toDouble();
        QVERIFY2(least > -0.05 && least < 2.0 && greatest > least, measured.output.constData());
        QFile file(in("deviation.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), answer["values"].toInt() + 1);
        QCOMPARE(lines.front(), QByteArray("time_s,deviation_mm"));
        double found = 1e9;
        for (qsizetype i = 1; i < lines.size(); ++i) {
            QVERIFY(std::abs(lines[i].split(',')[0].toDouble() - 0.01 * static_cast<double>(i - 1)) < 1e-6);
            found = std::min(found, lines[i].split(',')[1].toDouble());
        }
        QVERIFY(std::abs(found - least) < 1e-4);
        const ProgramRun text = runBurin({"take", "deviation", in("p.burin"), "1"});
        QVERIFY(text.status == 0 && text.output.contains("mm from the part"));
        QCOMPARE(bytes(), before);
    }

    /// A point is inserted into the path at a moment of the take; a moment that the path lacks is refused by its name.
    void aPointIsInsertedIntoThePath() {
        QCOMPARE(run({"path", in("p.burin"), "new", "--takes", "1"}).status, 0);
        const auto edit = [](int tick) {
            return QStringLiteral(R"({"edit": "insert-point", "at": {"take": 1, "tick": %1}, "by_mm": [0, 0, 2]})")
                .arg(tick);
        };
        const auto apply = [&](int tick) {
            return run({"path", in("p.burin"), "apply", "1", "--edit", edit(tick), "--place", "2"});
        };
        QCOMPARE(apply(3000).status, 0);
        const ProgramRun shown = run({"path", in("p.burin"), "show", "1"});
        QVERIFY2(shown.status == 0, shown.messages.constData());
        const QJsonObject report = shown.json()["reports"].toArray()[2].toObject();
        QCOMPARE(report["edit"].toString(), QString("insert-point"));
        QCOMPARE(report["inserted_mm"].toArray().size(), 1);
        QCOMPARE(run({"path", in("p.burin"), "undo", "1", "--place", "2"}).status, 0);
        QCOMPARE(apply(900000).status, 0);
        const ProgramRun refused = run({"path", in("p.burin"), "show", "1"});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.messages.contains("take 1, tick 900000"), refused.messages.constData());
    }

    /// The workpiece at a time of a program: before its first cut the stock, at its end the result of "post".
    void aProgramsWorkpieceIsWrittenAtAnyTime() {
        QCOMPARE(run({"path", in("p.burin"), "new"}).status, 0);
        const ProgramRun posted = run({"post", in("p.burin"), "-o", in("p.ngc"), "--override", "a test reads it"});
        QVERIFY2(posted.status == 0, posted.messages.constData());
        const auto at = [&](const QStringList& until) {
            const ProgramRun run = runBurin(QStringList{"verify", in("p.ngc"), "--project", in("p.burin"),
                                                        "--workpiece", in("then.srle"), "--exact", "0", "--json"} +
                                            until);
            return run.json();
        };
        const QJsonObject start = at({"--until", "0"}), end = at({});
        QCOMPARE(start["workpiece_hash"].toString(), hash({"--stock"}));
        QVERIFY(std::abs(end["workpiece_at_s"].toDouble() - end["machining_s"].toDouble()) < 0.02);
        const double half = 0.5 * end["workpiece_at_s"].toDouble();
        const QJsonObject middle = at({"--until", QString::number(half)});
        QVERIFY(middle["workpiece_hash"] != end["workpiece_hash"] &&
                middle["workpiece_hash"] != start["workpiece_hash"]);
        QVERIFY(middle["workpiece_at_line"].toInt() > start["workpiece_at_line"].toInt());
        QVERIFY(middle["workpiece_at_line"].toInt() < end["workpiece_at_line"].toInt());
        QCOMPARE(run({"volume", "moments", in("then.srle")}).json()["hash"].toString(),
                 middle["workpiece_hash"].toString());
    }

    /// Moved takes are replayed in the new order, while workpiece and path stay the same; after moving back, the output
    /// of "info" is the same byte for byte. A copy mills nothing twice, and replaces its original.
    void takesAreMovedAndCopied() {
        QVERIFY(mill({"--intent", "scribble", "--seconds", "3", "--seed", "7"}).status == 0);
        QCOMPARE(run({"path", in("p.burin"), "new"}).status, 0);
        const QString all = hash({}), border = hash({"--at", "1"});
        const QByteArray listing = takes(), points = pathPoints();
        QVERIFY(all != border && border == first_ && !points.isEmpty());
        const auto order = [](const ProgramRun& run) { return run.json()["takes"].toArray(); };
        QCOMPARE(order(run({"take", "move", in("p.burin"), "2", "--before", "1"})), (QJsonArray{2, 1}));
        QCOMPARE(hash({}), all);
        QCOMPARE(pathPoints(), points);
        QCOMPARE(run({"info", in("p.burin")}).json()["takes"].toArray()[0].toObject()["id"].toInt(), 2);
        const QString second = hash({"--at", "2"}); // at the end of take 2: only that take
        QVERIFY(second != border && second != all);
        QCOMPARE(hash({"--at", "1"}), all);
        QCOMPARE(hash({"--at", "2:0"}), hash({"--stock"}));
        QCOMPARE(run({"take", "off", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash({}), second);
        QCOMPARE(run({"take", "on", in("p.burin"), "1"}).status, 0);
        QCOMPARE(order(run({"take", "move", in("p.burin"), "2", "--to", "2"})), (QJsonArray{1, 2}));
        QCOMPARE(takes(), listing);
        QCOMPARE(hash({"--at", "1"}), border);

        const ProgramRun copied = run({"take", "duplicate", in("p.burin"), "1"});
        QVERIFY2(copied.status == 0, copied.messages.constData());
        QCOMPARE(copied.json()["take"].toInt(), 3);
        QCOMPARE(order(copied), (QJsonArray{1, 2, 3}));
        QVERIFY(copied.json()["name"].toString().endsWith(" (copy)"));
        QCOMPARE(hash({}), all);
        QCOMPARE(pathPoints(), points);
        QCOMPARE(run({"path", in("p.burin"), "apply", "1", "--take", "3"}).json()["takes"].toArray().size(), 3);
        QVERIFY(pathPoints().size() > points.size());
        QCOMPARE(run({"path", in("p.burin"), "delete", "1", "--take", "3"}).json()["takes"].toArray().size(), 2);
        QCOMPARE(pathPoints(), points);
        QCOMPARE(run({"take", "off", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash({}), all);
    }

    void whatIsWrongChangesNothing() {
        const QByteArray before = bytes();
        for (const QStringList& wrong : {QStringList{"take", "off", in("p.burin"), "7"},
                                         {"take", "off", in("p.burin"), "1", "--from", "99"},
                                         {"take", "off", in("p.burin"), "1", "--from", "3", "--to", "2"},
                                         {"take", "rename", in("p.burin"), "1", " "},
                                         {"take", "score", in("p.burin"), "7"},
                                         {"take", "deviation", in("p.burin"), "7"},
                                         {"take", "score", in("p.burin"), "1", "--reference", "1"},
                                         {"take", "score", in("p.burin"), "1", "--reference", "0"},
                                         {"take", "move", in("p.burin"), "1"},
                                         {"take", "move", in("p.burin"), "1", "--to", "2"},
                                         {"take", "move", in("p.burin"), "1", "--to", "0"},
                                         {"take", "move", in("p.burin"), "1", "--before", "1"},
                                         {"take", "move", in("p.burin"), "1", "--before", "7"},
                                         {"take", "move", in("p.burin"), "7", "--to", "1"},
                                         {"take", "duplicate", in("p.burin"), "7"},
                                         {"mill", in("p.burin"), "--from", "1:99"},
                                         {"mill", in("p.burin"), "--from", "x"},
                                         {"volume", "export", in("p.burin"), "--at", "9:1", "-o", in("w.srle")},
                                         {"volume", "export", in("p.burin"), "--at", "1:-1", "-o", in("w.srle")}}) {
            const ProgramRun refused = run(wrong);
            QVERIFY2(refused.status == 2 || refused.status == 3, qPrintable(wrong.join(' ')));
            QVERIFY2(refused.json().contains("error") && refused.messages.count('\n') == 1,
                     refused.messages.constData());
        }
        QVERIFY(!QFileInfo::exists(in("w.srle")));
        QCOMPARE(bytes(), before);
    }

private:
    QString in(const char* name) const { return folder_->filePath(name); }
    static ProgramRun run(QStringList arguments) { return runBurin(arguments << "--json"); }
    ProgramRun mill(const QStringList& more) const {
        return run(QStringList{"mill", in("p.burin"), "--tool", "ball-6"} + more);
    }
    QString hash(const QStringList& more) const {
        const ProgramRun written = run(QStringList{"volume", "export", in("p.burin"), "-o", in("volume.srle")} + more);
        if (written.status != 0) qWarning("%s", written.messages.constData());
        return written.json()["hash"].toString();
    }
    /// The takes as "info" lists them.
    QByteArray takes() const { return QJsonDocument(run({"info", in("p.burin")}).json()["takes"].toArray()).toJson(); }
    QByteArray pathPoints() const {
        if (run({"path", in("p.burin"), "show", "1", "-o", in("points.csv")}).status != 0) return {};
        QFile file(in("points.csv"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QByteArray bytes() const {
        QFile file(in("p.burin"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QTemporaryDir milled_;
    std::unique_ptr<QTemporaryDir> folder_;
    QString first_;
};

BURIN_TEST(TakesTest, QCoreApplication)

} // namespace burin::tst_takes

#include "tst_takes.moc"
