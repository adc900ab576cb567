// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/fault_run.h"

#include <sqlite3.h>

namespace {

const QString project = "p.burin";

qint64 count(sqlite3* database, const QString& sql) {
    sqlite3_stmt* statement = nullptr;
    qint64 value = -1;
    if (sqlite3_prepare_v2(database, sql.toUtf8().constData(), -1, &statement, nullptr) == SQLITE_OK &&
        sqlite3_step(statement) == SQLITE_ROW)
        value = sqlite3_column_int64(statement, 0);
    sqlite3_finalize(statement);
    return value;
}

bool isSound(sqlite3* database) {
    sqlite3_stmt* statement = nullptr;
    const bool sound = sqlite3_prepare_v2(database, "PRAGMA quick_check(1)", -1, &statement, nullptr) == SQLITE_OK &&
                       sqlite3_step(statement) == SQLITE_ROW &&
                       QByteArray(reinterpret_cast<const char*>(sqlite3_column_text(statement, 0))) == "ok";
    sqlite3_finalize(statement);
    return sound;
}

/// Names that should not be in the folder, without those that a command is allowed to leave.
QStringList leftBehind(const FaultCommand& command, const FaultRun& run, const QMap<QString, QByteArray>& files,
                       const Expected& expected, bool cleaned) {
    QStringList names;
    for (const QString& name : files.keys()) {
        if (expected.before.contains(name) || (run.status == 0 && expected.after.contains(name))) continue;
        if (command.records && run.status != 0 && name.startsWith(".p.burin.working")) continue;
        if (command.replaces && cleaned && name.startsWith("p.kept-")) continue;
        names << name;
    }
    return names;
}

QString judgeSuccess(const FaultCommand& command, const QString& folder, const QMap<QString, QByteArray>& files,
                     const Expected& expected) {
    const ProjectContent content = contentOfProject(folder + "/" + project);
    if (content != expected.projectAfter) return "it succeeded, but the project holds something else";
    for (const QString& output : command.outputs)
        if (files[output] != expected.after[output]) return "it succeeded, but " + output + " holds something else";
    return {};
}

QString judgeFailure(const FaultCommand& command, const FaultRun& run, const QMap<QString, QByteArray>& files,
                     const Expected& expected) {
    if (run.status != 4) return QString("its status is %1: %2").arg(run.status).arg(QString::fromUtf8(run.messages));
    const QByteArray words = run.messages.trimmed();
    if (words.isEmpty() || words.contains('\n')) return "it is not one sentence: " + QString::fromUtf8(words);
    if (words.contains("Success") || words.contains("damaged") || words.contains("No such file"))
        return "it states a wrong reason: " + QString::fromUtf8(words);
    if (files[project] != expected.before[project]) return "it failed, but the project was changed";
    for (const QString& output : command.outputs) {
        if (files[output] == expected.before[output]) continue;
        // If no output can be renamed back any more, the user has to be told.
        const bool told = words.contains("\"" + output.toUtf8() + "\" was written already");
        if (!run.lasting || !told || files[output] != expected.after[output])
            return "it failed, but " + output + " was changed";
    }
    return {};
}

/// A killed command: the project is intact, and the next run of the same command is not obstructed.
QString judgeKilled(const FaultCommand& command, const QString& folder, const Expected& expected) {
    const QMap<QString, QByteArray> files = filesIn(folder);
    const ProjectContent content = contentOfProject(folder + "/" + project);
    if (files[project] != expected.before[project] && content != expected.projectAfter)
        return "it was killed, and the project is neither the old nor the new one";
    for (const QString& output : command.outputs)
        if (files[output] != expected.before[output] && files[output] != expected.after[output])
            return "it was killed, and " + output + " is neither the old nor the new one";
    const FaultRun looked = runWithFault({"info", {"info", "p.burin"}, {}}, folder, 0, {});
    if (looked.status != 0) return "after a kill info says: " + QString::fromUtf8(looked.messages);
    const FaultRun again = runWithFault(command, folder, 0, {});
    if (again.status != 0) return "after a kill the command says: " + QString::fromUtf8(again.messages);
    const QStringList left = leftBehind(command, again, filesIn(folder), expected, true);
    return left.isEmpty() ? QString() : "after a kill and another run there is " + left.join(", ");
}

} // namespace

ProjectContent contentOfProject(const QString& file) {
    ProjectContent content;
    sqlite3* database = nullptr;
    if (sqlite3_open_v2(file.toUtf8().constData(), &database, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK) {
        content.sound = isSound(database);
        for (const char* table : {"model", "body", "setup", "material", "obstacle", "milling_setting", "setup_setting",
                                  "stock_volume", "tool", "take", "path", "path_edit", "program"})
            content.rows[table] = count(database, QString("SELECT count(*) FROM ") + table);
        content.rows["samples"] = count(database, "SELECT coalesce(sum(count), 0) FROM sample_chunk");
    }
    sqlite3_close(database);
    return content;
}

QString judge(const FaultCommand& command, const QString& folder, const FaultRun& run, const Expected& expected) {
    if (run.status == -1) return judgeKilled(command, folder, expected);
    const QMap<QString, QByteArray> files = filesIn(folder);
    if (const QStringList left = leftBehind(command, run, files, expected, false); !left.isEmpty())
        return QString("status %1, left behind: ").arg(run.status) + left.join(", ");
    return run.status == 0 ? judgeSuccess(command, folder, files, expected)
                           : judgeFailure(command, run, files, expected);
}
