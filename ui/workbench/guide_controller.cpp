// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/guide_controller.h"

#include "core/cad/part_edge.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

constexpr double edgeChord = 0.01; // mm, chord error between an edge and the polyline of its guide

} // namespace

GuideController::GuideController(const Desk& desk, WorkpieceController& workpiece, MillController& mill,
                                 SessionRunner& session, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), mill_(mill), session_(session) {
    connect(&mill_, &MillController::entered, this, [this] {
        apply();
        emit changed();
    });
    connect(&mill_, &MillController::left, this, &Controller::changed);
}

bool GuideController::hasEdges() const {
    return workpiece_.milling() && !workpiece_.milling()->partModel->brep.empty();
}

void GuideController::addNearestEdge() {
    if (!hasEdges() || desk_.tasks.running(TaskKind::edges)) return;
    const std::shared_ptr<const Model> model = workpiece_.milling()->partModel;
    if (model == followed_) return addEdge();
    desk_.tasks.start(
        TaskKind::edges, tr("Following the part's edges"),
        [model](Progress& progress) -> Result<Curves> {
            Result<std::vector<PartEdge>> edges = partEdges(*model, edgeChord, ImportOptions{}, progress);
            if (!edges) return std::move(edges).error();
            Curves curves;
            for (PartEdge& edge : *edges) {
                Result<GuideCurve> curve = GuideCurve::make(std::move(edge.points), std::move(edge.tangents));
                if (!curve) return std::move(curve).error();
                curves.push_back(std::make_shared<const GuideCurve>(std::move(*curve)));
            }
            return curves;
        },
        [this, model](Result<Curves> curves) {
            if (!curves) {
                emit failed(curves.error());
                return;
            }
            followed_ = model;
            edges_ = std::move(*curves);
            addEdge();
        });
}

/// The edge nearest to the tool, or to the middle of the stock's top if there is no tool.
void GuideController::addEdge() {
    if (full() || edges_.empty() || !workpiece_.milling()) return;
    const Box& stock = workpiece_.milling()->setup.stock;
    const glm::dvec3 place = mill_.active() ? session_.state().sample.proxy.tip
                                            : glm::dvec3(stock.centre().x, stock.centre().y, stock.high.z);
    const auto distance = [&place](const std::shared_ptr<const GuideCurve>& curve) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& point : curve->points()) nearest = std::min(nearest, glm::distance(point, place));
        return nearest;
    };
    const auto nearest = std::min_element(edges_.begin(), edges_.end(), [&](const auto& one, const auto& other) {
        return distance(one) < distance(other);
    });
    Guide guide;
    guide.kind = GuideKind::curve;
    guide.on = true;
    guide.curve = nearest->get();
    used_.push_back(*nearest);
    std::vector<Guide> guides = guides_;
    guides.push_back(guide);
    set(tr("new guide"), std::move(guides));
}

void GuideController::add(GuideKind kind) {
    if (full()) return;
    if (kind == GuideKind::curve) return addNearestEdge();
    Guide guide;
    guide.kind = kind;
    guide.on = true;
    if (workpiece_.milling()) {
        const Box& stock = workpiece_.milling()->setup.stock;
        const bool alongAxis = kind == GuideKind::plane || kind == GuideKind::levels;
        guide.point = alongAxis ? glm::dvec3(stock.centre().x, stock.centre().y, stock.high.z) : stock.centre();
    }
    if (kind == GuideKind::line) guide.direction = {1.0, 0.0, 0.0};
    if (kind == GuideKind::surface) guide.distance = 0.5;
    if (kind == GuideKind::axis) guide.onSurface = true;
    std::vector<Guide> guides = guides_;
    guides.push_back(guide);
    set(tr("new guide"), std::move(guides));
}

void GuideController::change(std::size_t place, const Guide& guide) {
    if (place >= guides_.size() || guides_[place] == guide) return;
    std::vector<Guide> guides = guides_;
    guides[place] = guide;
    // Raising one field step by step is one entry.
    set(tr("guide"), std::move(guides), guideValue + static_cast<int>(place));
}

void GuideController::remove(std::size_t place) {
    if (place >= guides_.size()) return;
    std::vector<Guide> guides = guides_;
    guides.erase(guides.begin() + static_cast<std::ptrdiff_t>(place));
    set(tr("guide deleted"), std::move(guides));
}

void GuideController::set(const QString& title, std::vector<Guide> guides, int kind) {
    desk_.undo.push(new ValueCommand<std::vector<Guide>>(title, kind, guides_, std::move(guides),
                                                         [this](const std::vector<Guide>& wanted) {
                                                             guides_ = wanted;
                                                             keep();
                                                             apply();
                                                             emit changed();
                                                         }));
}

void GuideController::load(const KeptGuides& guides) {
    guides_ = guides.guides;
    keptStepButtons_ = guides.stepButton;
    used_.insert(used_.end(), guides.curves.begin(), guides.curves.end());
    apply();
    emit changed();
}

void GuideController::keep() {
    KeptGuides kept;
    kept.guides = guides_;
    kept.stepButton = keptStepButtons_;
    for (const std::shared_ptr<const GuideCurve>& curve : used_)
        if (std::ranges::find(guides_, curve.get(), &Guide::curve) != guides_.end()) kept.curves.push_back(curve);
    store([kept](Project& project) { return project.setGuides(kept); });
}

void GuideController::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    apply();
    emit changed();
}

void GuideController::stepLevel(int levels) {
    if (!mill_.active()) return;
    session_.stepGuides(levels);
    emit levelStepped();
}

void GuideController::apply() {
    if (!mill_.active()) return;
    GuideSettings settings = guideSettings(guides_, stepButtons_);
    for (Guide& guide : settings.guides) guide.on = guide.on && on_;
    if (const Result<void> set = session_.setGuides(settings); !set) emit failed(set.error());
}

void GuideController::setStepButtons(std::uint32_t buttons) {
    if (std::exchange(stepButtons_, buttons) != buttons) apply();
}

} // namespace burin
