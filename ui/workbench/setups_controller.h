// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/further_setup.h"
#include "ui/workbench/document_controller.h"
#include "ui/workbench/program_controller.h"
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/target_controller.h"
#include "ui/workbench/workpiece_controller.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// The setups of a job: the list of them, and the one in use, to which everything in the other controllers belongs.
class SetupsController final : public Controller {
    Q_OBJECT
public:
    /// All outlive it.
    struct Neighbours {
        DocumentController& document;
        SetupController& setup;
        WorkpieceController& workpiece;
        ProgramController& program;
        TargetController& target;
    };
    SetupsController(const Desk& desk, const Neighbours& neighbours, QObject* parent);

    const std::vector<SetupName>& setups() const noexcept { return setups_; }
    SetupId used() const noexcept { return used_; }
    bool stockOutOfDate() const noexcept { return stockOutOfDate_; } ///< of the one in use
    /// Whether a setup is being added, or a stock is being taken again.
    bool adding() const { return adding_ || retaken_ || desk_.tasks.running(TaskKind::furtherSetup); }
    QString title(SetupId id) const; ///< its name; "Setup 2" where it has none
    /// Sets the function called before another setup is used; it ends recordings and collects text that is being typed.
    void setRest(std::function<void(std::function<void()>)> rest) { rest_ = std::move(rest); }

    /// Loads the setups of a project.
    void load(const ProjectContents& contents);
    void use(SetupId id);
    /// Adds a setup after the one in use and switches to it. Its stock is the workpiece that the present setup leaves:
    /// after its program if one was checked and is still valid, else after its recordings; or a new stock.
    /// @param name empty: none @param turn of the part, relative to its present placement
    void add(const QString& name, const Placement& turn, bool leftStock);
    void rename(const QString& name); ///< the one in use
    /// Removes the one in use and switches to the one before it, or to the next one if it is the first. Refused
    /// (failed) while it holds user work.
    void remove();
    /// Takes the stock of the setup in use again from the setup that leaves it.
    void takeStockAnew();

signals:
    void added(); ///< a further setup is there, and in use

private:
    using MakeSetup = std::function<Result<Setup>(const Setup& before, const LeftStock& stock)>;
    void startTask(const Placement& to, std::int64_t digest, const MakeSetup& make,
                   const std::function<void(const Result<Setup>&)>& done);
    void forget();
    void goOnRetaking();
    void tellRetaken(const Result<Setup>& setup);
    void endRetaking();
    void keep(const QString& name, const Result<Setup>& setup);
    void useAfter(const QString& title, SetupId id, const SharedStep& step, const WorkState& before,
                  std::function<void()> then);
    void reread(const Result<std::vector<SetupName>>& setups);

    Neighbours neighbours_;
    std::vector<SetupName> setups_{{firstSetup, {}}};
    SetupId used_ = firstSetup;
    /// The setup whose stock is being taken again, and its previous state.
    struct Retaken {
        SetupId id = firstSetup;
        Setup setup;
        bool begun = false;               ///< whether the workpiece that it comes from is being made, or is ready
        WorkState before;                 ///< of the window
        std::optional<SharedStep> step{}; ///< once the stock is stored
    };
    std::optional<Retaken> retaken_;
    std::function<void()> again_; ///< restarts the task that reads the workpiece; null if none is under way
    bool interrupted_ = false;    ///< the workpiece changed while it was being read
    quint64 generation_ = 0;      ///< counts projects
    bool stockOutOfDate_ = false, adding_ = false;
    std::function<void(std::function<void()>)> rest_ = [](const std::function<void()>& then) { then(); };
};

} // namespace burin
