// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/history.h"
#include "ui/workbench/project_thread.h"
#include "ui/workbench/task_runner.h"

#include <QObject>

namespace burin {

/// What all controllers of one window share. Outlives them.
struct Desk {
    ProjectThread& project;
    TaskRunner& tasks;
    History& undo;
};

/// Controls one subject of the work: holds its state, changes it, stores it in the project and reports changes.
/// Controllers do not word errors, they pass them on. User interface's thread.
class Controller : public QObject {
    Q_OBJECT
public:
    Controller(const Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {}

signals:
    void changed();
    void failed(const burin::Error& error);

protected:
    /// Changes the project in the background if one is open, unless an undo or redo restores its rows; errors are
    /// reported by `failed`.
    template <class Work>
    void store(Work work) {
        desk_.project.postToPlace(
            [work = std::move(work), &project = desk_.project](std::optional<Project>& place) mutable -> Result<void> {
                return place && !project.restoring() ? work(*place) : Result<void>();
            },
            [this](const Result<void>& stored) {
                if (!stored) emit failed(stored.error());
                emit desk_.project.worked();
            });
    }
    Desk desk_;
};

} // namespace burin
