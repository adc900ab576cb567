// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QString>

#include <optional>
#include <vector>

/// A straight move as LinuxCNC's interpreter makes it, mm, in the frame of the work offset.
struct CanonicalMove {
    bool rapid = false;
    double feed = 0.0; ///< mm/min in force
    glm::dvec3 to{0.0};
};

/// What `rs274 -g` says of a program; nothing where it refuses it. `home` is a folder that it may write in.
inline std::optional<std::vector<CanonicalMove>> canonicalMoves(const QString& program, const QString& home, int tool,
                                                                double diameter) {
    QFile table(home + "/tools.tbl");
    if (!table.open(QIODevice::WriteOnly)) return std::nullopt;
    table.write(QStringLiteral("T%1 P%1 D%2 Z0\n").arg(tool).arg(diameter / 25.4, 0, 'f', 6).toLatin1());
    table.close();
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", home);
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(home);
    process.setStandardInputFile(QProcess::nullDevice());
    process.start("rs274", {"-g", "-t", table.fileName(), program});
    if (!process.waitForFinished(300'000) || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return std::nullopt;
    std::vector<CanonicalMove> moves;
    double feed = 0.0;
    const auto numbers = [](const QByteArray& line) {
        const qsizetype open = line.indexOf('('), close = line.lastIndexOf(')');
        return line.mid(open + 1, close - open - 1).split(',');
    };
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        if (line.contains("SET_FEED_RATE")) feed = numbers(line).front().trimmed().toDouble();
        const bool rapid = line.contains("STRAIGHT_TRAVERSE");
        if (!rapid && !line.contains("STRAIGHT_FEED")) continue;
        const auto words = numbers(line);
        moves.push_back(
            {rapid,
             rapid ? 0.0 : feed,
             {words[0].trimmed().toDouble(), words[1].trimmed().toDouble(), words[2].trimmed().toDouble()}});
    }
    return moves;
}
