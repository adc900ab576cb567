// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/base/file.h"
#include "core/cad/worker_message.h"
#include "core/cad/worker_process.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include <poll.h>
#include <thread>

using namespace burin;
using namespace burin::test;

namespace fs = std::filesystem;

class WorkerProcesses : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    /// Options that start a shell script in place of the import program.
    ImportOptions scripted(const std::string& commands) {
        static int number = 0;
        const fs::path script = fs::path(folder_.path().toStdString()) / ("worker-" + std::to_string(++number));
        if (!writeFileAtomically(script, "#!/bin/sh\n" + commands + "\n")) qFatal("no place to write");
        fs::permissions(script, fs::perms::owner_all);
        ImportOptions options;
        options.worker = script;
        options.limits.seconds = 30.0;
        return options;
    }
    static Error errorOf(const ImportOptions& options) {
        Progress progress;
        const Result<Model> model = importModel(modelFile("cube.brep"), options, progress);
        return model ? Error{ErrorCode::checkFailed, "an answer", {}, {}} : model.error();
    }

private slots:
    void hangingProgramTimesOut() {
        ImportOptions options = scripted("exec sleep 1000");
        options.limits.waitSeconds = 0.3;
        const Error error = errorOf(options);
        QVERIFY2(error.code == ErrorCode::importTimedOut, describe(error).c_str());
        QCOMPARE(error.place, std::string("0.3 s"));
        QVERIFY(error.subject.find("cube.brep") != std::string::npos);
    }
    /// As under a high load: it waits for its turn far longer than it works.
    void waitingIsNoWork() {
        ImportOptions options = scripted("sleep 1; exit 3");
        options.limits.seconds = 0.5;
        QVERIFY(errorOf(options).code == ErrorCode::importCrashed);
    }
    void workingWithoutEndTimesOut() {
        ImportOptions options = scripted("while :; do :; done");
        options.limits.seconds = 0.3;
        const Error error = errorOf(options);
        QVERIFY2(error.code == ErrorCode::importTimedOut, describe(error).c_str());
        QCOMPARE(error.place, std::string("0.3 s"));
        QVERIFY(error.detail.empty());
    }
    /// The system counts by itself, and on a busy machine it may be the first to find the time used up.
    void theSystemsOwnLimitIsATimeOutToo() {
        ImportOptions options = scripted("while :; do :; done");
        options.limits.seconds = 0.3;
        Result<WorkerProcess> worker = WorkerProcess::start(ReadRequest{}, options, "a part");
        QVERIFY(worker);
        pollfd end{worker->output(), POLLIN, 0};
        constexpr int longest = 60'000; // ms; it takes two seconds of a processor
        QCOMPARE(::poll(&end, 1, longest), 1);
        QTRY_VERIFY((worker->advance(), worker->finished()));
        const WorkerAnswer answer = worker->takeAnswer();
        const auto* error = std::get_if<Error>(&answer);
        QVERIFY2(error && error->code == ErrorCode::importTimedOut, error ? describe(*error).c_str() : "an answer");
    }
    void programThatClosedItsOutputTimesOutToo() {
        ImportOptions options = scripted("exec >&-; sleep 1000");
        options.limits.waitSeconds = 0.3;
        QVERIFY(errorOf(options).code == ErrorCode::importTimedOut);
    }
    void nothingThatItStartedSurvives() {
        const fs::path trace = fs::path(folder_.path().toStdString()) / "alive";
        ImportOptions options = scripted("(sleep 1; touch '" + trace.string() + "') & sleep 1000");
        options.limits.waitSeconds = 0.3;
        QVERIFY(errorOf(options).code == ErrorCode::importTimedOut);
        QTest::qWait(1500);
        QVERIFY(!fs::exists(trace));
    }
    void crashIsReportedWithItsSignal_data() {
        QTest::addColumn<QString>("commands");
        QTest::addColumn<QString>("detail");
        QTest::newRow("segmentation fault") << "kill -SEGV $$"
                                            << "signal 11";
        QTest::newRow("abort") << "kill -ABRT $$"
                               << "signal 6";
        QTest::newRow("ends without an answer") << "exit 3"
                                                << "exit status 3";
        QTest::newRow("answers garbage") << "head -c 100000 /dev/urandom"
                                         << "damaged";
        QTest::newRow("answers text") << "echo hello, this is not an answer of the import program"
                                      << "damaged";
    }
    void crashIsReportedWithItsSignal() {
        QFETCH(QString, commands);
        QFETCH(QString, detail);
        const Error error = errorOf(scripted(commands.toStdString()));
        QVERIFY2(error.code == ErrorCode::importCrashed, describe(error).c_str());
        QVERIFY2(error.detail.find(detail.toStdString()) != std::string::npos, error.detail.c_str());
    }
    /// The faster mesher may crash on a face; the file is read again without it.
    void aCrashIsTriedAgain() {
        const fs::path crashed = fs::path(folder_.path().toStdString()) / "crashed";
        ImportOptions again = scripted("[ -e " + crashed.string() + " ] && exec " + options().worker.string() +
                                       "\ntouch " + crashed.string() + "; kill -SEGV $$");
        Progress progress;
        const Result<Model> model = importModel(modelFile("cube.brep"), again, progress);
        QVERIFY2(model, model ? "" : describe(model.error()).c_str());
        QVERIFY(fs::exists(crashed));
        QCOMPARE(model->bodies.size(), std::size_t{1});
        QVERIFY(countOpenEdges(model->bodies.front().mesh) == 0);
    }
    void missingProgramIsSaid() {
        ImportOptions options;
        options.worker = "/nonexistent/burin-import";
        const Error error = errorOf(options);
        QVERIFY(error.code == ErrorCode::fileNotFound);
        QCOMPARE(error.subject, std::string("/nonexistent/burin-import"));
    }
    void memoryIsLimited() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("sanitizers reserve terabytes; the limit is off then");
#else
        // Enough to load OpenCASCADE's libraries, too little for the file, which has a gigabyte (of holes).
        const fs::path file = fs::path(folder_.path().toStdString()) / "large.stl";
        if (!writeFileAtomically(file, "solid")) qFatal("no place to write");
        fs::resize_file(file, 1ULL << 30);
        ImportOptions tight = options();
        tight.limits.memoryBytes = 400ULL << 20;
        Progress progress;
        const Result<Model> model = importModel(file, tight, progress);
        QVERIFY(!model);
        QVERIFY2(model.error().code == ErrorCode::importOutOfMemory, describe(model.error()).c_str());
        QCOMPARE(model.error().place, std::string("400 MiB"));
#endif
    }
    void cancellingStopsIt() {
        Progress progress;
        const ImportOptions options = scripted("exec sleep 1000");
        std::thread canceller([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            progress.cancel();
        });
        const Result<Model> model = importModel(modelFile("cube.brep"), options, progress);
        canceller.join();
        QVERIFY(!model);
        QVERIFY(model.error().code == ErrorCode::cancelled);
    }
    void progressArrives() {
        Progress progress;
        QVERIFY(importModel(modelFile("tet.step"), options(), progress));
        QCOMPARE(progress.fraction(), 1.0);
    }
    void badOptionsAreRefused() {
        ImportOptions wrong = options();
        wrong.meshChord = 0.0;
        QVERIFY(errorOf(wrong).code == ErrorCode::argumentInvalid);
        wrong = options();
        wrong.stlUnit = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(errorOf(wrong).code == ErrorCode::argumentInvalid);
    }
    void fileThatHangsCostsNothingElse() {
        // After every fault above the next import works.
        QVERIFY(import(modelFile("cube.brep")));
    }

    void damagedAnswersAreRefused() {
        Progress progress;
        const Result<Model> model = import(modelFile("tet.step"));
        QVERIFY(model);
        const std::string frame = encodeFrame(WorkerAnswer(*model));
        FrameReader whole;
        whole.append(frame);
        const std::optional<WorkerFrame> read = whole.next();
        QVERIFY(read);
        const auto* answer = std::get_if<WorkerAnswer>(&*read);
        QVERIFY(answer && std::get_if<Model>(answer));
        QCOMPARE(std::get_if<Model>(answer)->brep, model->brep);
        QCOMPARE(std::get_if<Model>(answer)->bodies[0].mesh.vertices, model->bodies[0].mesh.vertices);
        for (std::size_t i = 0; i < frame.size(); i += 1 + frame.size() / 500) {
            std::string broken = frame;
            broken[i] = static_cast<char>(broken[i] ^ 0x55);
            FrameReader reader;
            reader.append(broken);
            const std::optional<WorkerFrame> got = reader.next();
            // The reserved word alone may change unnoticed; a longer length waits for bytes that never come.
            QVERIFY(!got || (i >= 12 && i < 16));
        }
    }
};

QTEST_GUILESS_MAIN(WorkerProcesses)
#include "tst_worker_process.moc"
