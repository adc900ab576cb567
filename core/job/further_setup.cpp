// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/further_setup.h"

#include "core/base/steps.h"

#include <optional>
#include <utility>

namespace burin {

namespace {

/// Returns the setup with a new stock that has the same margins around the part in its present placement: a stated
/// stock belonged to the previous placement.
Setup withNewStock(Setup setup) {
    if (setup.form == StockForm::file || setup.stated) setup.form = StockForm::box;
    setup.stated = false;
    setup.volume = nullptr;
    setup.leftBy.reset();
    return setup;
}

} // namespace

Result<Setup> furtherSetup(const Setup& before, const Placement& turn, const std::shared_ptr<const Model>& model,
                           const LeftStock* stock) {
    Setup setup = stock ? withStock(before, *stock) : withNewStock(before);
    setup.placement = combined(before.placement, turn);
    setup.zero = moved(setup.zero, turn);
    return placeStock(*placed(model, setup.placement), std::move(setup));
}

Result<SetupId> storeFurtherSetup(Project& project, const std::string& name, const Setup& setup,
                                  const ProgramTarget& target) {
    const Result<SetupId> id = project.addSetup(name);
    if (!id) return id;
    const Result<void> stored =
        inOrder([&] { return project.setSetup(setup, *id); }, [&] { return project.setProgramTarget(target, *id); });
    if (stored) return id;
    static_cast<void>(project.removeSetup(*id)); // on a full disk, possibly only its row was written
    return stored.error();
}

Result<AddedSetup> addFurtherSetup(Project& project, const FurtherSetup& further, Progress& progress) {
    const SetupId after = further.after == setupInUse ? project.usedSetup() : further.after;
    const Result<Setup> before = project.setup(after);
    if (!before) return before.error();
    const Result<ProgramTarget> target = project.programTarget(after);
    if (!target) return target.error();
    Result<Model> model = project.model();
    if (!model) return std::move(model).error();
    std::optional<LeftStock> stock;
    if (further.leftStock) {
        Result<LeftStock> left = leftStock(project, after, combined(before->placement, further.turn), progress);
        if (!left) return std::move(left).error();
        stock = std::move(*left);
    }
    const Result<Setup> setup = furtherSetup(*before, further.turn, std::make_shared<const Model>(std::move(*model)),
                                             stock ? &*stock : nullptr);
    if (!setup) return setup.error();
    const Result<SetupId> id = storeFurtherSetup(project, further.name, *setup, *target);
    if (!id) return id.error();
    return AddedSetup{*id, stock && stock->byProgram, stock ? stock->greatestDisplacement : 0.0};
}

Result<bool> isStockOutOfDate(const Project& project, SetupId id) {
    const Result<Setup> setup = project.setup(id);
    if (!setup) return setup.error();
    if (!setup->leftBy) return false;
    const Result<std::int64_t> digest = project.jobDigest(setup->leftBy->setup);
    if (!digest) return digest.error();
    return *digest != setup->leftBy->digest;
}

Result<AddedSetup> takeStockAnew(Project& project, SetupId id, Progress& progress) {
    Result<Setup> setup = project.setup(id);
    if (!setup) return std::move(setup).error();
    const Result<std::vector<TakeInfo>> takes = project.takes(id);
    if (!takes) return takes.error();
    const Result<std::vector<GeneratedInfo>> passes = project.generated(id);
    if (!passes) return passes.error();
    if (!setup->leftBy || !takes->empty() || !passes->empty())
        return Error{ErrorCode::argumentInvalid, "stock",
                     std::to_string(takes->size() + passes->size()) + " recordings and passes",
                     "a setup whose stock another one left, and in which nothing is milled yet"};
    const Result<LeftStock> stock = leftStock(project, setup->leftBy->setup, setup->placement, progress);
    if (!stock) return stock.error();
    const Result<std::shared_ptr<const Model>> model = project.placedModel(id);
    if (!model) return model.error();
    const Result<Setup> complete = placeStock(**model, withStock(std::move(*setup), *stock));
    if (!complete) return complete.error();
    if (Result<void> stored = project.setSetup(*complete, id); !stored) return std::move(stored).error();
    return AddedSetup{id == setupInUse ? project.usedSetup() : id, stock->byProgram, stock->greatestDisplacement};
}

} // namespace burin
