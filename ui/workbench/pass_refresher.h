// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/computed_pass.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// Finds the passes of the path in force that are out of date, as strokes that lead them have changed since they were
/// computed, and computes those again on request, both in the background.
class PassRefresher final : public Controller {
    Q_OBJECT
public:
    PassRefresher(const Desk& desk, const WorkpieceController& workpiece, PathController& path,
                  const ToolController& tools, std::shared_ptr<KeptLeads> leads, QObject* parent);

    /// Ids of passes of the path in force, in its order; empty while they are being found.
    const std::vector<std::int64_t>& outdated() const noexcept { return outdated_; }
    bool busy() const noexcept { return refreshing_ || waiting_; }
    bool possible() const; ///< some are out of date, and can be computed now
    /// Computes the passes that are out of date, each behind those before it; all others stay as they are. When
    /// complete, one entry of the undo stack; errors are reported by `failed`, and nothing has changed then. Can be
    /// cancelled as a task. Does nothing unless `possible`. If another pass has begun or the workpiece changes
    /// meanwhile, it is started again afterwards; if another tool was loaded, that is reported.
    void refresh();
    void forget(); ///< another project

private:
    struct Matter;
    using Key = std::pair<std::int64_t, quint64>; ///< path, and version of the paths
    bool ready() const;
    void look();
    void readersStop();
    void find(LedPasses led);
    void know(std::vector<std::int64_t> outdated);
    void putOff();
    void proceed();
    void drop();
    void compute(std::vector<Matter> matters);
    void end();
    void stopReading();

    const WorkpieceController& workpiece_;
    PathController& path_;
    const ToolController& tools_;
    std::shared_ptr<KeptLeads> leads_;
    std::shared_ptr<Progress> looking_, collecting_; ///< takes are read for these; null: never begun
    std::optional<Key> looked_;                      ///< what `outdated_` belongs to, or will
    std::vector<std::int64_t> outdated_;
    bool refreshing_ = false;
    bool waiting_ = false;     ///< for another pass or for the workpiece, to refresh then
    std::string tool_, title_; ///< id of the tool whose passes are computed again, and the title of the first one
    quint64 questions_ = 0, loads_ = 0;
};

} // namespace burin
