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

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// A straight move as made by LinuxCNC's interpreter, mm, in the frame of the work offset. An arc is divided into
/// chords that deviate from it by 0.001 mm at most.
struct CanonicalMove {
    bool rapid = false;
    double feed = 0.0; ///< mm/min in force
    glm::dvec3 to{0.0};
};

/// Adds the chords of ARC_FEED(first end, second end, first axis, second axis, rotation, axis end, …).
/// @param from  its start @param axis  across its plane: 0 X, 1 Y, 2 Z
inline void addArc(std::vector<CanonicalMove>& moves, const glm::dvec3& from, const QList<QByteArray>& words, int axis,
                   double feed) {
    const auto number = [&](int at) { return words[at].trimmed().toDouble(); };
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const glm::dvec2 end(number(0), number(1)), centre(number(2), number(3));
    const glm::dvec2 first = glm::dvec2(from[u], from[v]) - centre, last = end - centre;
    const bool clockwise = number(4) < 0.0;
    double sweep = std::atan2(last.y, last.x) - std::atan2(first.y, first.x);
    while (clockwise && sweep >= -1e-9) sweep -= 2.0 * M_PI;
    while (!clockwise && sweep <= 1e-9) sweep += 2.0 * M_PI;
    const double radius = std::max(glm::length(first), 1e-3);
    const double most = 2.0 * std::acos(std::max(0.0, 1.0 - 0.001 / radius)); // angle of a chord
    const int pieces = 1 + static_cast<int>(std::abs(sweep) / most);
    for (int i = 1; i <= pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        const double angle = std::atan2(first.y, first.x) + share * sweep;
        const double here = glm::mix(glm::length(first), glm::length(last), share);
        glm::dvec3 to(0.0);
        to[u] = i == pieces ? end.x : centre.x + here * std::cos(angle);
        to[v] = i == pieces ? end.y : centre.y + here * std::sin(angle);
        to[axis] = glm::mix(from[axis], number(5), share);
        moves.push_back({false, feed, to});
    }
}

/// The moves that `rs274 -g` makes of a program; nullopt if it refuses the program. `home` is a writable folder.
/// @param tools numbers and diameters, mm, of those that it calls
inline std::optional<std::vector<CanonicalMove>> canonicalMoves(const QString& program, const QString& home,
                                                                const std::vector<std::pair<int, double>>& tools) {
    QFile table(home + "/tools.tbl");
    if (!table.open(QIODevice::WriteOnly)) return std::nullopt;
    for (const auto& [tool, diameter] : tools)
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
    int axis = 2;
    const auto numbers = [](const QByteArray& line) {
        const qsizetype open = line.indexOf('('), close = line.lastIndexOf(')');
        return line.mid(open + 1, close - open - 1).split(',');
    };
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        if (line.contains("SET_FEED_RATE")) feed = numbers(line).front().trimmed().toDouble();
        if (line.contains("SELECT_PLANE")) axis = line.contains("_XY") ? 2 : line.contains("_XZ") ? 1 : 0;
        if (line.contains("ARC_FEED")) {
            if (moves.empty()) return std::nullopt;
            addArc(moves, glm::dvec3(moves.back().to), numbers(line), axis, feed);
        }
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
/// The same for a program with one tool.
inline std::optional<std::vector<CanonicalMove>> canonicalMoves(const QString& program, const QString& home, int tool,
                                                                double diameter) {
    return canonicalMoves(program, home, {{tool, diameter}});
}
