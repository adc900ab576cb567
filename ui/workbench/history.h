// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/setup_id.h"
#include "core/geometry/plan_region.h"
#include "core/setup/setup.h"
#include "ui/workbench/project_thread.h"

#include <QUndoStack>

#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace burin {

/// What the window works on, as far as the project doesn't keep it.
struct WorkState {
    SetupId setup = firstSetup;    ///< in use
    std::string tool;              ///< id of the tool in the spindle
    double allowance = 0.0;        ///< mm
    PlanRegion area;               ///< painted
    std::optional<Setup> unstored; ///< as edited, if it can't be embedded and is not stored therefore
    bool embedded = false;         ///< whether there is a workpiece, or is one being made
};

/// The undo stack of a project, from its opening to its closing. An entry that must be undone in another setup, or
/// reads the project again, takes a moment; what is requested meanwhile follows in order. The index is that of the last
/// request; it returns to the state reached if an entry can't be undone or redone. What was done of a macro then is
/// reverted. User interface's thread.
class History final : public QUndoStack {
    Q_OBJECT
public:
    /// What undo and redo need besides the entries.
    struct Window {
        std::function<WorkState()> state;
        std::function<bool()> atRest;                     ///< whether no session is running
        std::function<void(std::function<void()>)> rest;  ///< ends the session, then calls its argument
        std::function<void(std::int64_t, bool)> hideTake; ///< hides or restores a take
        /// Turns a step, if one is given, and shows the project in that state; then reports whether it succeeded.
        std::function<void(const WorkState& to, const std::optional<SharedStep>& step, std::function<void(bool)> then)>
            go;
        std::function<void()> embed; ///< makes the workpiece unless there is one
    };
    explicit History(ProjectThread& project, QObject* parent = nullptr) : QUndoStack(parent), project_(project) {}
    void serve(Window window) { window_ = std::move(window); } ///< call it first

    /// Adds a change of values that is stored through Controller::store, and makes it. It is refused while `busy`,
    /// which the failed() of the project's thread reports.
    void push(QUndoCommand* change);
    /// The same for a change that the project has stored already as `step`; making it here stores nothing new.
    void pushStored(QUndoCommand* change, const SharedStep& step);
    /// The same as `push` for a change of part or stock: a session is ended before it is undone or redone.
    void pushForming(QUndoCommand* change);
    /// Adds a change that was made already, and whose undo and redo change the project by themselves.
    void pushDone(QUndoCommand* change);
    /// The same for a part of a recording. Before what was done earlier than the first one is undone, the take is
    /// hidden.
    void pushRecorded(QUndoCommand* change, std::int64_t take);
    /// Adds a step that was made already, which undo and redo make by reading the project again.
    void pushStep(const QString& title, const SharedStep& step, const WorkState& before);
    /// Makes such a step, of changes through Controller::store.
    void makeStep(const QString& title, const std::function<void()>& change);
    void clear(); ///< for another project

    WorkState present() const { return window_.state(); }
    /// Whether an undo or redo is under way.
    bool busy() const noexcept { return current_.has_value(); }

signals:
    void settled(); ///< everything that was requested is done, or has failed

private:
    class Entry;
    struct Request {
        Entry* entry = nullptr;
        bool undo = true;
        bool restoring = false; ///< of a part of a macro, as a later part failed
    };
    void add(Entry* entry);
    void addMade(Entry* entry);
    void put(Entry* entry);
    void request(Entry& entry, bool undo);
    void workOff();
    void begin();
    void reach();
    void make();
    void finish();
    void fail();
    void hideRecording();
    int placeOf(const Entry* entry) const;
    bool holdsRecording(std::int64_t take) const;

    ProjectThread& project_;
    Window window_;
    std::deque<Request> queue_;
    std::optional<Request> current_;
    std::vector<Request> parts_;    ///< done last: of one entry, or of a macro so far; some may be deleted
    std::vector<Entry*> waiting_;   ///< entries made while `busy`
    std::set<std::int64_t> hidden_; ///< takes
    bool resting_ = false;          ///< the session is being ended
    bool working_ = false;          ///< `workOff` is running
    bool aligning_ = false;         ///< the index returns to the state reached
    quint64 generation_ = 0;        ///< counts withdrawn requests and projects
};

} // namespace burin
