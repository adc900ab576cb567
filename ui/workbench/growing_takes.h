// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/session_runner.h"

#include <QElapsedTimer>

#include <utility>
#include <vector>

namespace burin {

/// A take of the session: under way, or ended since.
struct GrowingTake {
    std::int64_t take = 0;
    double seconds = 0.0;                           ///< so far
    std::vector<std::pair<double, double>> strokes; ///< s from its start: begin and end, as seen in each picture
};

/// The takes of the session under way, as far as they are recorded, for the timeline, whose takes are read when the
/// session has ended. Costs nothing but a look at each picture's state; `changed` is emitted at most ten times a
/// second.
class GrowingTakes final : public Controller {
    Q_OBJECT
public:
    GrowingTakes(const Desk& desk, const SessionRunner& session, QObject* parent);

    const std::vector<GrowingTake>& takes() const noexcept { return takes_; }
    bool underWay(std::int64_t take) const; ///< whether it is being recorded
    /// Drops them: they were read, or the project is another one.
    void clear();

private:
    void follow();

    const SessionRunner& session_;
    std::vector<GrowingTake> takes_;
    bool cutting_ = false, due_ = false; ///< `due_`: something has changed that was not reported
    QElapsedTimer sinceReport_;
};

} // namespace burin
