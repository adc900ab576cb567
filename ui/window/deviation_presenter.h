// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_map.h"
#include "ui/panels/deviation_card.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"
#include "ui/window/scene_presenter.h"

namespace burin {

/// The deviation map of the newest program: on the part in the viewport, as shares in the panel, and as a value at the
/// pointer.
class DeviationPresenter final : public Presenter {
    Q_OBJECT
public:
    DeviationPresenter(Workbench& workbench, Viewport& viewport, DeviationCard& card, ScenePresenter& scene,
                       QObject* parent);
    void setShown(bool shown); ///< whether the program step is shown
    void pointAt(const QPointF& position);
    void setUnit(LengthUnit unit) override;

private:
    void present() override;
    /// A map and the program whose samples it refers to.
    struct Mapped {
        Mapped(std::shared_ptr<const CheckedProgram> of, double cell);
        std::shared_ptr<const CheckedProgram> program;
        DeviationMap map;
    };
    /// @return whether the picture must change
    bool take(std::shared_ptr<const CheckedProgram> program);
    void makeMap();
    void adopt(std::shared_ptr<const Mapped> made);

    double voxel() const; ///< mm; requires a program that is up to date

    Viewport& viewport_;
    DeviationCard& card_;
    ScenePresenter& scene_;
    std::shared_ptr<const CheckedProgram> program_; ///< whose map is requested; null: none is up to date
    std::shared_ptr<const Mapped> mapped_;          ///< the newest finished map
    DeviationTolerance tolerance_;                  ///< for shares and colour bands
    bool shown_ = false, on_ = false, drawn_ = false;
    bool otherMap_ = false; ///< the map differs from the one drawn
};

} // namespace burin
