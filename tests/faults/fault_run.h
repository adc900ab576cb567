// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QString>
#include <QStringList>

#include <cstdint>

/// A command of Burin with what it writes, in a folder that `prepareFolder` made.
struct FaultCommand {
    const char* name;
    QStringList arguments;
    QStringList outputs;           ///< files besides the project
    bool records = false;          ///< what it made before a fault is kept as unsaved work
    bool replaces = false;         ///< makes the project anew; one that it left half made is set aside by the next
    const char* program = "burin"; ///< or another of the build
    bool earlier = false;          ///< its project is of an earlier format
};
QList<FaultCommand> faultCommands();

/// What happened to a run of a command.
struct FaultRun {
    int status = -1; ///< exit status; -1: killed
    QByteArray messages;
    std::uint64_t calls = 0; ///< that were counted
    bool lasting = false;    ///< all calls failed from the n-th on
};

/// Runs `command` in `folder` with its n-th call failing. @param at from 1; 0: none @param kind as failing_calls.cpp
FaultRun runWithFault(const FaultCommand& command, const QString& folder, std::uint64_t at, const QString& kind);

/// What a project holds, as SQLite reads it.
struct ProjectContent {
    bool sound = false;
    QMap<QString, qint64> rows; ///< by table; "samples" for those of all takes
    bool operator==(const ProjectContent&) const = default;
};
ProjectContent contentOfProject(const QString& file);

/// Model, project with a recording, a path and a program, and older outputs. Empty: done; else what went wrong.
QString prepareFolder(const QString& folder);
/// A project of an earlier format. Empty: done; else what went wrong.
QString prepareEarlierFolder(const QString& folder);
/// Makes `folder` hold what `from` does.
void copyFolder(const QString& from, const QString& folder);
/// The files of a folder with their content.
QMap<QString, QByteArray> filesIn(const QString& folder);

/// A folder before a command, and after it without a fault.
struct Expected {
    QMap<QString, QByteArray> before, after;
    ProjectContent projectBefore, projectAfter;
};

/// What is wrong with a folder after a run; empty: nothing. See README.md.
QString judge(const FaultCommand& command, const QString& folder, const FaultRun& run, const Expected& expected);
