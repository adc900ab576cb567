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

/// The setups of a job: which there are and which one is worked in. All that the other controllers show is of that one.
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
    /// One is being added, or a stock taken anew.
    bool adding() const { return adding_ || retaken_ || desk_.tasks.running(TaskKind::furtherSetup); }
    QString title(SetupId id) const; ///< its name; "Setup 2" where it has none
    /// Asked before another setup is used: ends recordings and what is being typed.
    void setRest(std::function<void(std::function<void()>)> rest) { rest_ = std::move(rest); }

    /// What a project holds.
    void load(const ProjectContents& contents);
    void use(SetupId id);
    /// A further one behind the one in use, which is then used itself. Its stock is what this one leaves as it stands:
    /// behind the program where one was checked and still holds, else behind the recordings; or a new one.
    /// @param name empty: none @param turn of the part, from how it lies now
    void add(const QString& name, const Placement& turn, bool leftStock);
    void rename(const QString& name); ///< the one in use
    /// The one in use, for the one before it. Refused (failed) while it holds what somebody made.
    void remove();
    /// Takes the stock of the one in use anew from the setup that leaves it.
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
    void reread(const Result<std::vector<SetupName>>& setups);

    Neighbours neighbours_;
    std::vector<SetupName> setups_{{firstSetup, {}}};
    SetupId used_ = firstSetup;
    /// Whose stock is being taken anew, and as it was.
    struct Retaken {
        SetupId id = firstSetup;
        Setup setup;
        bool begun = false; ///< the workpiece that it comes from is being made, or there
    };
    std::optional<Retaken> retaken_;
    std::function<void()> again_; ///< starts the task that reads the workpiece once more; null: none is under way
    bool interrupted_ = false;    ///< the workpiece changed while it was read
    quint64 generation_ = 0;      ///< counts projects
    bool stockOutOfDate_ = false, adding_ = false;
    std::function<void(std::function<void()>)> rest_ = [](const std::function<void()>& then) { then(); };
};

} // namespace burin
