// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/places.h"

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QStringList>

/// One run of the program `burin`.
struct ProgramRun {
    int status = -1; ///< exit status; -1 after a crash or timeout
    QByteArray output, messages;
    QJsonObject json() const { return QJsonDocument::fromJson(output).object(); }
};

inline QString burinProgram() {
    return QStringLiteral(BURIN_BUILD_DIRECTORY "/burin");
}

/// Runs `burin` with arguments to its end, at most ten minutes. In English, whatever the tester's language is, unless
/// another locale is given.
inline ProgramRun runBurin(const QStringList& arguments, const QString& locale = "C.UTF-8") {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LC_ALL", locale);
    environment.remove("DISPLAY"); // no command needs one
    process.setProcessEnvironment(environment);
    process.start(burinProgram(), arguments);
    ProgramRun run;
    const int limit = qEnvironmentVariableIntValue("QTEST_FUNCTION_TIMEOUT"); // longer under sanitizers
    if (!process.waitForFinished(limit > 0 ? limit : 600'000)) process.kill();
    if (process.exitStatus() == QProcess::NormalExit && process.error() == QProcess::UnknownError)
        run.status = process.exitCode();
    run.output = process.readAllStandardOutput();
    run.messages = process.readAllStandardError();
    return run;
}

/// The content of a text file; empty if it cannot be read.
inline QString contentOf(const QString& file) {
    QFile content(file);
    return content.open(QIODevice::ReadOnly) ? QString::fromUtf8(content.readAll()) : QString();
}
