// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/stylus_editor.h"

#include "core/path/hand_interval.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// Share of the reach by which a hand that only presses the button may move the tool.
constexpr double steadyShare = 0.1;
constexpr double ledClose = 0.02; // mm: the stylus is where the pointer led it
constexpr double sideways = 0.05; // mm: it has left the point at which it descended

Moment momentOf(const EvaluatedPath& path, const PlaceOnPath& at) {
    return momentAt(path.path.points[at.piece], path.path.points[at.piece + 1], at.share);
}

} // namespace

StylusEditor::StylusEditor(const Desk& desk, WorkpieceController& workpiece, MillController& mill,
                           SessionRunner& session, StylusController& styluses, HandController& hand,
                           PathController& path, QObject* parent)
    : Controller(desk, parent)
    , workpiece_(workpiece)
    , mill_(mill)
    , session_(session)
    , styluses_(styluses)
    , hand_(hand)
    , paths_(path) {
    connect(&session_, &SessionRunner::ticked, this, &StylusEditor::follow);
    connect(&session_, &SessionRunner::ended, this, &StylusEditor::noteEnd);
    connect(&session_, &SessionRunner::endedByItself, this, [this] {
        if (active_) leave(); // a fault, which is reported when the session ends
    });
    connect(&paths_, &Controller::changed, this, &StylusEditor::takePath);
    connect(&paths_, &PathController::evaluatedAnew, this, &StylusEditor::takePath);
}

/// While a device is being connected, mill mode is about to begin; another connection would replace that one.
bool StylusEditor::possible() const {
    return !active_ && !session_.running() && !desk_.tasks.running(TaskKind::device) && workpiece_.ready() &&
           paths_.stored() != nullptr && paths_.evaluated();
}

void StylusEditor::enter() {
    if (!possible()) return;
    if (!styluses_.mouse()) return enterWithDevice();
    const MillingContext& milling = *workpiece_.milling();
    const glm::dvec3 centre = milling.setup.stock.centre();
    auto stylus = std::make_unique<SimulatedStylus>(glm::dvec3(centre.x, centre.y, milling.safeHeight()));
    SimulatedStylus* mouse = stylus.get();
    begin(std::move(stylus), mouse, {});
}

void StylusEditor::enterWithDevice() {
    styluses_.connectDevice(
        [this, assignment = styluses_.axisMap(styluses_.choice().id)](std::unique_ptr<AnyStylus> stylus) {
            if (!stylus || !possible()) { // the reason for the request may be gone
                emit changed();
                return;
            }
            const StylusDevice& connected = StylusHandle(*stylus).device();
            const HandDevice device = handDevice(connected, *workpiece_.milling(), assignment);
            if (device.description.buttons == 0) {
                emit refused(tr("“%1” has no button that could take a point of the path. Choose another device, or "
                                "drag the point with the mouse.")
                                 .arg(QString::fromStdString(device.description.name)));
                emit changed();
                return;
            }
            begin(std::move(*stylus), nullptr, device);
        });
}

/// Without a take the spindle stays off: nothing is cut, and the stock does not hold the tool.
void StylusEditor::begin(AnyStylus stylus, SimulatedStylus* mouse, const std::optional<HandDevice>& device) {
    SessionRequest request;
    request.allowance = mill_.allowance();
    request.felt = mill_.felt();
    request.undoable = false;
    request.cutsOnButton = true;
    if (device) request.mapping = device->mapping;
    if (device) request.forceButtons = mill_.forceButtons();
    if (device) request.gains = mill_.gains();
    session_.begin({workpiece_.milling(), workpiece_.bounds(), &workpiece_.strokes()}, std::move(stylus), request,
                   [this, mouse, device](bool well) {
                       if (!well) return;
                       active_ = true;
                       mouse_ = mouse;
                       down_ = true;
                       hand_.useDevice(device);
                       takePath();
                       emit entered();
                       emit changed();
                   });
}

void StylusEditor::leave(std::function<void()> then) {
    if (!active_) {
        if (then) then();
        return;
    }
    giveUp();
    session_.end([then = std::move(then)](bool) {
        if (then) then();
    });
}

void StylusEditor::noteEnd() {
    if (!std::exchange(active_, false)) return;
    mouse_ = nullptr;
    held_.reset();
    within_.reset();
    search_.reset();
    inserted_.clear();
    path_.reset();
    hand_.useDevice({});
    emit left();
    emit changed();
}

/// A point is taken only while the path is that of the present edits: otherwise it may be elsewhere by now.
void StylusEditor::takePath() {
    if (!active_) return;
    const auto path = paths_.outdated() ? nullptr : paths_.evaluated();
    if (path == path_) return;
    giveUp(); // it was a point of the previous path
    within_.reset();
    search_.reset();
    inserted_.clear();
    path_ = path;
    if (path_) {
        search_.emplace(path_->path.points);
        inserted_ = insertedPoints(*path_, paths_.stored()->edits);
    }
    emit moved();
}

void StylusEditor::setReach(double millimetres) {
    const double wanted = std::clamp(millimetres, smallestReach, largestReach);
    if (std::exchange(reach_, wanted) != wanted) emit changed();
}

void StylusEditor::setAlong(MovePoints::Along along) {
    along_ = along;
}

void StylusEditor::follow() {
    if (!active_) return;
    const Sample& sample = session_.state().sample;
    if ((sample.flags & sampleStylusInvalid) != 0) return; // the hand is not known at present
    const bool down = (sample.buttons & 1U) != 0, wasDown = std::exchange(down_, down);
    tip_ = sample.proxy.tip;
    commanded_ = sample.stylusTip;
    if (held_ && down) drag();
    if (mouse_ == nullptr) {
        if (held_ && !down) drop();
        if (!held_) look();
        if (down && !wasDown && within_) take(*within_);
    } else if (held_ && released_ && down && glm::distance(commanded_, goal_) < ledClose) { // it is where it was led
        drop();
        steer(tip_, false, true);
    }
    emit moved();
}

/// An inserted point goes before the path at the same position.
void StylusEditor::look() {
    within_.reset();
    if (!search_) return;
    if (const auto found = search_->nearest(tip_, reach_)) within_ = PathGrip{*found, std::nullopt};
    if (!within_ || along_ == MovePoints::Along::surface) return;
    for (const InsertedPoint& point : inserted_)
        if (glm::distance(point.place, within_->at.place) <= steadyShare * reach_) {
            within_->at.place = point.place;
            within_->insertedBy = point.edit;
        }
}

void StylusEditor::take(const PathGrip& grip) {
    held_ = grip;
    within_.reset();
    arrived_ = mouse_ == nullptr;
    moves_ = released_ = false;
    takenAt_ = commanded_;
    by_ = glm::dvec3(0.0);
    emit changed();
}

/// The point follows the tip, which part, fixtures and travel hold. The stylus of the mouse first descends to the
/// point.
void StylusEditor::drag() {
    const glm::dvec3& place = held_->at.place;
    by_ = tip_ - place;
    if (mouse_ == nullptr)
        moves_ = moves_ || glm::distance(commanded_, takenAt_) > steadyShare * reach_;
    else
        arrived_ = arrived_ || commanded_.z < place.z + ledClose ||
                   glm::distance(glm::dvec2(commanded_), glm::dvec2(place)) > sideways;
}

/// As the mouse does: a press without a motion selects the point.
void StylusEditor::drop() {
    const PathGrip grip = *std::exchange(held_, std::nullopt);
    released_ = false;
    emit changed();
    const Moment moment = momentOf(*path_, grip.at);
    if (!moves_ && !grip.insertedBy)
        paths_.select(moment);
    else if (!moves_)
        return;
    else if (grip.insertedBy)
        paths_.moveInserted(*grip.insertedBy, by_);
    else
        paths_.movePlace(moment, by_, along_);
}

/// The stylus of the mouse reaches a point from above.
void StylusEditor::steer(const glm::dvec3& tip, bool held, bool finish) {
    StylusTarget target;
    target.tip = tip;
    target.cutting = held;
    target.finishStroke = finish;
    target.clearHeight = workpiece_.milling()->safeHeight();
    if (!held) target.tip.z = std::max(tip.z, target.clearHeight);
    mouse_->request(target);
}

void StylusEditor::lead(const PathGrip& grip, const glm::dvec3& by) {
    if (!usesMouse() || !path_ || released_) return;
    if (!held_) {
        if (grip.at.piece + 1 >= path_->path.points.size()) return; // of an older path, which is still drawn
        take(grip);
        steer(grip.at.place, true, false);
    }
    moves_ = moves_ || by != glm::dvec3(0.0);
    goal_ = held_->at.place + by;
    steer(goal_, true, false);
}

void StylusEditor::letGo() {
    if (held_) released_ = true;
}

void StylusEditor::giveUp() {
    released_ = false;
    if (!std::exchange(held_, std::nullopt)) return;
    if (usesMouse()) steer(tip_, false, false);
    emit moved();
    emit changed();
}

} // namespace burin
