// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QString>
#include <QStringList>

#include <cstdint>

/// A command of Burin with its outputs, in a folder that `prepareFolder` made.
struct FaultCommand {
    const char* name;
    QStringList arguments;
    QStringList outputs;           ///< files besides the project
    bool records = false;          ///< what it made before a fault is kept as unsaved work
    bool replaces = false;         ///< recreates the project; an incomplete one is set aside by the next run
    const char* program = "burin"; ///< or another program of the build
    bool earlier = false;          ///< its project is of an earlier format
};
QList<FaultCommand> faultCommands();

/// The outcome of a run of a command.
struct FaultRun {
    int status = -1; ///< exit status; -1: killed
    QByteArray messages;
    std::uint64_t calls = 0; ///< number of counted calls
    bool lasting = false;    ///< all calls failed from the n-th on
};

/// Runs `command` in `folder` with its n-th call failing. @param at  n from 1; 0: none @param kind  as in
/// failing_calls.cpp
FaultRun runWithFault(const FaultCommand& command, const QString& folder, std::uint64_t at, const QString& kind);

/// The content of a project as read by SQLite.
struct ProjectContent {
    bool sound = false;
    QMap<QString, qint64> rows; ///< by table; "samples" for those of all takes
    bool operator==(const ProjectContent&) const = default;
};
ProjectContent contentOfProject(const QString& file);

/// Prepares model, project with a recording, a path and a program, and older outputs. Returns an error text or an empty
/// string.
QString prepareFolder(const QString& folder);
/// Prepares a project of an earlier format. Returns an error text or an empty string.
QString prepareEarlierFolder(const QString& folder);
/// Makes the content of `folder` equal to that of `from`.
void copyFolder(const QString& from, const QString& folder);
/// The files of a folder with their content.
QMap<QString, QByteArray> filesIn(const QString& folder);

/// A folder before a command and after it without a fault.
struct Expected {
    QMap<QString, QByteArray> before, after;
    ProjectContent projectBefore, projectAfter;
};

/// What is wrong with a folder after a run; empty if nothing is. See README.md.
QString judge(const FaultCommand& command, const QString& folder, const FaultRun& run, const Expected& expected);
