// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/canonical_program.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace burin {
namespace {

constexpr int canonicalTools = 7;

std::vector<double> numbersOf(const QString& arguments) {
    std::vector<double> numbers;
    for (const QString& one : arguments.split(',')) numbers.push_back(one.trimmed().toDouble());
    return numbers;
}

} // namespace

bool CanonicalProgram::available() {
    return !QStandardPaths::findExecutable("rs274").isEmpty();
}

CanonicalProgram CanonicalProgram::ofText(const std::string& text) {
    QTemporaryDir folder;
    QFile file(folder.filePath("program.ngc"));
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(text.data(), static_cast<qsizetype>(text.size()));
    file.close();
    return CanonicalProgram(file.fileName());
}

CanonicalProgram::CanonicalProgram(const QString& program) {
    QTemporaryDir folder;
    QFile table(folder.filePath("tool.tbl"));
    if (!table.open(QIODevice::WriteOnly)) return;
    for (int tool = 1; tool <= canonicalTools; ++tool) table.write(QString("T%1 P%1 D0.25 Z0\n").arg(tool).toLatin1());
    table.close();
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", folder.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder.path());
    process.setStandardInputFile(QProcess::nullDevice());
    process.start("rs274", {"-g", "-t", table.fileName(), program});
    if (!process.waitForFinished(60000)) return;
    exitCode = process.exitCode();
    complaint = QString::fromLocal8Bit(process.readAllStandardError());
    readCalls(QString::fromLocal8Bit(process.readAllStandardOutput()));
}

void CanonicalProgram::readCalls(const QString& output) {
    static const QRegularExpression call(R"(([A-Z_0-9]+)\(([^()]*)\)\s*$)", QRegularExpression::MultilineOption);
    CanonicalMove now;
    glm::dvec3 place(0.0);
    glm::dvec3 shift(0.0); // mm
    double shiftDoubt = 0.0;
    int axis = 2;
    double speed = 0.0; // 1/min
    bool turns = false;
    auto found = call.globalMatch(output);
    while (found.hasNext()) {
        const auto match = found.next();
        const QString name = match.captured(1), arguments = match.captured(2);
        const std::vector<double> n = numbersOf(arguments);
        bool isMove = true;
        if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED") {
            now.kind = name == "STRAIGHT_FEED" ? CanonicalKind::line : CanonicalKind::rapid;
            place = {n[0], n[1], n[2]};
            now.rotary = {n[3], n[4], n[5]};
        } else if (name == "ARC_FEED") {
            now.kind = CanonicalKind::arc;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            place[u] = n[0];
            place[v] = n[1];
            place[axis] = n[5];
            now.centre = glm::dvec3(0.0);
            now.centre[u] = n[2] + shift[u] / now.unit;
            now.centre[v] = n[3] + shift[v] / now.unit;
            now.turns = static_cast<int>(n[4]);
            now.axis = axis;
        } else if (name == "DWELL") {
            now.kind = CanonicalKind::dwell;
            now.seconds = n[0];
        } else {
            isMove = false;
            if (name == "SET_SPINDLE_SPEED") speed = n.back();
            if (name.startsWith("START_SPINDLE")) turns = true;
            if (name == "STOP_SPINDLE_TURNING") turns = false;
            if (name.startsWith("MIST_")) now.mist = name == "MIST_ON";
            if (name.startsWith("FLOOD_")) now.flood = name == "FLOOD_ON";
            if (name == "SET_FEED_RATE") now.feed = n[0] * now.unit;
            if (name == "SET_G92_OFFSET") {
                shift = glm::dvec3(n[0], n[1], n[2]) * now.unit;
                shiftDoubt = shift == glm::dvec3(0.0) ? 0.0 : 0.5e-4 * now.unit;
            }
            if (name == "USE_LENGTH_UNITS") {
                now.unit = arguments == "CANON_UNITS_INCHES" ? 25.4 : 1.0;
            }
            if (name == "SELECT_PLANE") axis = arguments.endsWith("XY") ? 2 : arguments.endsWith("XZ") ? 1 : 0;
        }
        if (!isMove) continue;
        now.spindleSpeed = turns ? speed : 0.0;
        now.doubt = 1e-4 + shiftDoubt / now.unit;
        now.to = place + shift / now.unit;
        moves.push_back(now);
    }
}

} // namespace burin
