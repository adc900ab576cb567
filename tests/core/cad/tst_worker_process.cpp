// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "cad_test.h"

#include "core/base/file.h"
#include "core/cad/worker_message.h"
#include "core/cad/worker_process.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include <poll.h>
#include <thread>

namespace burin::tst_worker_process {

using namespace burin::test;

namespace fs = std::filesystem;

class WorkerProcesses : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    /// Options that start a shell script instead of the import program.
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
    /// As under a high load: the process waits for the processor far longer than it works.
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
    /// The system has a limit of its own, and on a busy machine it may be the first to report that the time is used up.
    void theSystemsOwnLimitIsATimeOutToo() {
        ImportOptions options = scripted("while :; do :; done");
        options.limits.seconds = 0.3;
        Result<WorkerProcess> worker = WorkerProcess::start(ReadRequest{}, options, "a part");
        QVERIFY(worker);
        pollfd end{worker->output(), POLLIN, 0};
        constexpr int longest = 60'000; // ms; the limit is two seconds of processor time
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
    /// The faster mesher may crash on a face; the file is then read again without it.
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
        wrong.fileUnit = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(errorOf(wrong).code == ErrorCode::argumentInvalid);
    }
    void fileThatHangsCostsNothingElse() {
        // After each of the faults above the next import works.
        QVERIFY(import(modelFile("cube.brep")));
    }

    /// It arrives before the model, resembles it, and is sent only on request.
    void aPreviewComesFirst() {
        Progress progress;
        std::vector<ModelPreview> previews;
        double fractionThen = -1.0;
        const Result<Model> model =
            importModel(modelFile("red-cube-blue-cylinder.step"), options(), progress, [&](ModelPreview preview) {
                fractionThen = progress.fraction();
                previews.push_back(std::move(preview));
            });
        QVERIFY(model);
        QCOMPARE(previews.size(), std::size_t{1});
        const ModelPreview& preview = previews.front();
        QVERIFY(fractionThen < 1.0);
        QCOMPARE(preview.sourceFile, model->sourceFile);
        QCOMPARE(preview.bodies.size(), model->bodies.size());
        const double coarse = 0.01 * glm::length(model->box().size());
        for (std::size_t i = 0; i < preview.bodies.size(); ++i) {
            QCOMPARE(preview.bodies[i].name, model->bodies[i].name);
            QVERIFY(preview.bodies[i].colour == model->bodies[i].colour);
            Box box;
            for (const glm::vec3& vertex : preview.bodies[i].mesh.vertices) box.include(glm::dvec3(vertex));
            QVERIFY(glm::distance(box.low, model->bodies[i].box.low) < coarse);
            QVERIFY(glm::distance(box.high, model->bodies[i].box.high) < coarse);
        }
    }
    void withoutOneWhoLooksThereIsNoPreview() {
        const ReadRequest silent{modelFile("red-cube-blue-cylinder.step").string()};
        Result<WorkerProcess> process = WorkerProcess::start(silent, options(), "a part");
        QVERIFY(process);
        QTRY_VERIFY_WITH_TIMEOUT((process->advance(), process->finished()), 30000);
        QVERIFY(!process->takePreview());
    }
    /// However many the program sends: more would overload the display.
    void onePreviewIsTaken() {
        const fs::path frames = fs::path(folder_.path().toStdString()) / "frames";
        std::string bytes;
        for (const char* name : {"first", "second", "third"}) bytes += encodeFrame(ModelPreview{name, {}});
        bytes += encodeFrame(WorkerAnswer(Error{ErrorCode::modelHasNoSolid, {}, {}, {}}));
        QVERIFY(writeFileAtomically(frames, bytes));
        std::vector<std::string> seen;
        Progress progress;
        const auto answers = runWorkers({ReadRequest{}}, scripted("cat '" + frames.string() + "'"), "a part", progress,
                                        [&](const ModelPreview& preview) { seen.push_back(preview.sourceFile); });
        QVERIFY(!answers && answers.error().code == ErrorCode::modelHasNoSolid);
        QCOMPARE(seen, std::vector<std::string>{"first"});
    }
    void damagedPreviewsAreRefused() {
        ModelPreview preview{"/a/part.step", {{"Body 1", {{1, 2, 3}}, {}}, {"lid", std::nullopt, {}}}};
        preview.bodies[0].mesh.vertices = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.5F}};
        preview.bodies[0].mesh.triangles = {{0, 1, 2}};
        const auto read = [](const std::string& frame) {
            FrameReader reader;
            reader.append(frame);
            return reader.next();
        };
        const std::string frame = encodeFrame(preview);
        const std::optional<WorkerFrame> whole = read(frame);
        const auto* same = whole ? std::get_if<ModelPreview>(&*whole) : nullptr;
        QVERIFY(same);
        QCOMPARE(same->sourceFile, preview.sourceFile);
        QCOMPARE(same->bodies.size(), std::size_t{2});
        QVERIFY(same->bodies[0].colour == preview.bodies[0].colour && !same->bodies[1].colour);
        QCOMPARE(same->bodies[0].mesh.vertices, preview.bodies[0].mesh.vertices);
        QVERIFY(same->bodies[0].mesh.triangles == preview.bodies[0].mesh.triangles);
        for (std::size_t i = 0; i < frame.size(); ++i) {
            std::string broken = frame;
            broken[i] = static_cast<char>(broken[i] ^ 0x55);
            QVERIFY(!read(broken) || (i >= 12 && i < 16)); // only the reserved word may change undetected
        }
        // Intact bytes with invalid contents.
        ModelPreview outside = preview, nowhere = preview;
        outside.bodies[0].mesh.triangles = {{0, 1, 3}};
        nowhere.bodies[0].mesh.vertices[1].y = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(!read(encodeFrame(outside)));
        QVERIFY(!read(encodeFrame(nowhere)));
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
            // Only the reserved word may change undetected; a greater length waits for bytes that never arrive.
            QVERIFY(!got || (i >= 12 && i < 16));
        }
    }
};

BURIN_TEST(WorkerProcesses, QCoreApplication)

} // namespace burin::tst_worker_process

#include "tst_worker_process.moc"
