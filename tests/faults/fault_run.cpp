// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/fault_run.h"

#include "tests/places.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <filesystem>

namespace {

QProcessEnvironment plainEnvironment(const QString& folder) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LC_ALL", "C.UTF-8");
    environment.insert("XDG_DATA_HOME", folder + "/data"); // where `calibrate` writes
    environment.remove("DISPLAY");
    return environment;
}

QString programOf(const QString& name) {
    const QString build = QStringLiteral(BURIN_BUILD_DIRECTORY "/");
    return name == "burin" ? build + name : build + "test-programs/" + name;
}

FaultRun runProcess(const QString& program, const QStringList& arguments, const QString& folder,
                    const QProcessEnvironment& environment) {
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    process.start(program, arguments);
    FaultRun run;
    if (!process.waitForFinished(60'000)) process.kill();
    process.waitForFinished();
    if (process.exitStatus() == QProcess::NormalExit) run.status = process.exitCode();
    run.messages = process.readAllStandardError();
    return run;
}

} // namespace

FaultRun runWithFault(const FaultCommand& command, const QString& folder, std::uint64_t at, const QString& kind) {
    const QString countFile = folder + ".count";
    QFile count(countFile);
    if (!count.open(QIODevice::WriteOnly) || count.write(QByteArray(8, '\0')) != 8) return {};
    count.close();
    QProcessEnvironment environment = plainEnvironment(folder);
    environment.insert("LD_PRELOAD", QStringLiteral(BURIN_BUILD_DIRECTORY "/test-programs/libburin_failing_calls.so"));
    environment.insert("BURIN_FAULT_PROGRAM", command.program);
    environment.insert("BURIN_FAULT_FOLDER", folder + "/");
    environment.insert("BURIN_FAULT_AT", QString::number(at));
    environment.insert("BURIN_FAULT_KIND", kind);
    environment.insert("BURIN_FAULT_COUNT", countFile);
    FaultRun run = runProcess(programOf(command.program), command.arguments, folder, environment);
    run.lasting = kind == "ENOSPC";
    if (count.open(QIODevice::ReadOnly)) {
        const QByteArray bytes = count.read(8);
        for (qsizetype i = bytes.size(); i > 0; --i)
            run.calls = run.calls << 8U | static_cast<unsigned char>(bytes[i - 1]);
    }
    return run;
}

QString prepareFolder(const QString& folder) {
    QDir().mkpath(folder);
    if (!QFile::copy(BURIN_FIXTURES "/models/pocket-test.stl", folder + "/part.stl")) return "no model";
    const QList<QStringList> steps{
        {"embed", "part.stl", "-o", "p.burin", "--voxel", "2", "--margin", "2", "--material", "tooling-board"},
        {"mill", "p.burin", "--step-over", "4", "--seconds", "2"},
        {"path", "p.burin", "new"},
        {"post", "p.burin", "-o", "program.ngc", "--override", "a test", "--tolerance", "1"},
        {"path", "p.burin", "trace", "1", "-o", "hand.csv"}};
    for (const QStringList& step : steps)
        if (const FaultRun run = runProcess(programOf("burin"), step, folder, plainEnvironment(folder));
            run.status != 0)
            return step.join(' ') + ": " + QString::fromUtf8(run.messages);
    for (const FaultCommand& command : faultCommands())
        for (const QString& output : command.earlier ? QStringList() : command.outputs) {
            QFile older(folder + "/" + output);
            QDir().mkpath(QFileInfo(older).path());
            if (!older.exists() && (!older.open(QIODevice::WriteOnly) || older.write("what stood here before\n") < 0))
                return output;
        }
    return {};
}

QString prepareEarlierFolder(const QString& folder) {
    QDir().mkpath(folder);
    return QFile::copy(BURIN_FIXTURES "/projects/v3/small.burin", folder + "/p.burin") ? QString() : "no project";
}

void copyFolder(const QString& from, const QString& folder) {
    std::filesystem::remove_all(folder.toStdString());
    std::filesystem::copy(from.toStdString(), folder.toStdString(), std::filesystem::copy_options::recursive);
}

QMap<QString, QByteArray> filesIn(const QString& folder) {
    QMap<QString, QByteArray> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.toStdString())) {
        if (!entry.is_regular_file()) continue;
        QFile file(QString::fromStdString(entry.path().string()));
        if (file.open(QIODevice::ReadOnly)) files[QDir(folder).relativeFilePath(file.fileName())] = file.readAll();
    }
    return files;
}
