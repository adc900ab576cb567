// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/workpiece_actors.h"

#include "ui/scene/actors.h"
#include "ui/scene/glass_prop.h"
#include "ui/scene/view_lights.h"
#include "ui/scene/workpiece_mesher.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace burin {

namespace {

/// Triangles that one paint may newly upload to the graphics driver (about 20 ms in software).
constexpr std::size_t uploadsPerPaint = 60'000;
/// While something moves, full detail is added up to this number; it is below the limit to shorten the time from cut to
/// screen.
constexpr std::size_t comfortableTriangles = 45'000;
/// The maximum drawn at rest, regardless of the size of the workpiece: no paint may take 100 ms.
constexpr std::size_t restTriangles = 250'000;

vtkSmartPointer<vtkActor> groupActor() {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetColorModeToDirectScalars();
    mapper->SetStatic(1); // the data are complete: no pipeline to update
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    shadeSimply(*actor);
    actor->GetProperty()->BackfaceCullingOn(); // closed surface: back faces would cost time and are never visible
    actor->VisibilityOff();
    return actor;
}

/// One of the two surfaces of a group.
struct LayerActor {
    vtkSmartPointer<vtkActor> actor = groupActor();
    std::optional<SurfaceUpdate> next; ///< newer than the actor's data
    std::size_t triangles = 0;         ///< of the actor's data
    std::vector<SurfaceBrick> bare;    ///< where bare part is left out
    bool loaded = false;               ///< whether the actor has data

    void load() {
        static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(next->data);
        triangles = next->triangles;
        bare = std::move(next->bare);
        loaded = true;
        next.reset();
    }
    std::size_t coming() const { return next ? next->triangles : triangles; }
};

struct Group {
    glm::dvec3 centre{0.0};
    LayerActor moving, rest;
    bool restCurrent = false; ///< whether the surface at rest shows the newest cut
    LayerActor* drawn = nullptr;
};

} // namespace

class WorkpieceActors::Impl {
public:
    Impl(vtkRenderer& solids, vtkRenderer& films, std::function<void()> ready)
        : renderer_(solids), films_(films), ready_(ready), mesher_({movingTriangles, restTriangles}, std::move(ready)) {
        glass_->VisibilityOff();
        films_.AddViewProp(glass_);
    }
    ~Impl() {
        removeGroups();
        films_.RemoveViewProp(glass_);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    WorkpieceMesher& mesher() { return mesher_; }
    const WorkpieceMesher& mesher() const { return mesher_; }

    void setVisible(bool visible) {
        visible_ = visible;
        for (Group& group : groups_) draw(group);
        showGlass();
    }

    void setOpacity(double opacity) {
        opacity_ = opacity;
        for (Group& group : groups_) {
            dress(group);
            draw(group);
        }
        showGlass();
    }
    bool isGlass() const noexcept { return visible_ && opacity_ < 1.0; }

    void setClip(vtkPlane* clip) {
        clip_ = clip;
        for (Group& group : groups_) dress(group);
    }

    void update(bool moving, const glm::dvec3& focus) {
        mesher_.setFocus(focus);
        takeDelivery();
        std::vector<Group*> nearest;
        for (Group& group : groups_) nearest.push_back(&group);
        std::sort(nearest.begin(), nearest.end(), [&](const Group* a, const Group* b) {
            return glm::length(a->centre - focus) < glm::length(b->centre - focus);
        });
        load(nearest, choose(nearest, moving));
        for (Group& group : groups_) draw(group);
        showGlass();
        findBare();
        if (waiting_)
            ready_();
        else if (cut_)
            cutShown_ = std::exchange(cut_, std::nullopt);
    }

    void setDepthCue(const DepthCue& cue) {
        for (const Group& group : groups_)
            if (group.drawn != nullptr) burin::setDepthCue(*group.drawn->actor, cue);
    }

    const std::shared_ptr<const BareBricks>& bare() const noexcept { return bare_; }
    std::uint64_t volume() const noexcept { return volume_; }
    std::size_t triangles() const {
        return std::accumulate(groups_.begin(), groups_.end(), std::size_t{0}, [](std::size_t sum, const Group& group) {
            return sum + (group.drawn != nullptr ? group.drawn->triangles : 0);
        });
    }
    bool fullDetail() const {
        return !mesher_.busy() && !groups_.empty() && std::all_of(groups_.begin(), groups_.end(), [](const Group& g) {
            return g.restCurrent && g.drawn == &g.rest && !g.rest.next;
        });
    }
    bool waiting() const { return waiting_; }
    std::optional<CutTime> takeCutShown() { return std::exchange(cutShown_, std::nullopt); }

private:
    void removeGroups() {
        for (Group& group : groups_) {
            renderer_.RemoveActor(group.moving.actor);
            renderer_.RemoveActor(group.rest.actor);
        }
        groups_.clear();
    }

    void takeDelivery() {
        SurfaceDelivery delivery = mesher_.take();
        if (delivery.volume != volume_) {
            removeGroups();
            volume_ = delivery.volume;
            grid_ = delivery.grid;
            groups_.resize(delivery.groups.size());
            for (std::size_t i = 0; i < groups_.size(); ++i) {
                groups_[i].centre = delivery.groups[i];
                dress(groups_[i]);
                renderer_.AddActor(groups_[i].moving.actor);
                renderer_.AddActor(groups_[i].rest.actor);
            }
        }
        for (SurfaceUpdate& update : delivery.updates) {
            Group& group = groups_[update.group];
            const bool rest = update.layer == SurfaceLayer::rest;
            group.restCurrent = rest;
            (rest ? group.rest : group.moving).next = std::move(update);
        }
        if (delivery.cut && (!cut_ || *delivery.cut < *cut_)) cut_ = delivery.cut;
    }

    /// The groups that show their surface at rest: all, or while something moves as many as the limit allows, those
    /// near the focus first.
    std::vector<bool> choose(const std::vector<Group*>& nearest, bool moving) const {
        std::size_t all = 0;
        for (const Group* group : nearest) all += group->moving.coming();
        std::vector<bool> rest;
        for (const Group* group : nearest) {
            const std::size_t with = all - group->moving.coming() + group->rest.coming();
            rest.push_back(group->restCurrent && (!moving || with <= comfortableTriangles));
            if (rest.back()) all = with;
        }
        return rest;
    }

    /// Uploads what is chosen and not loaded yet, within the budget; groups beyond it keep showing their current
    /// surface.
    void load(const std::vector<Group*>& nearest, const std::vector<bool>& rest) {
        std::size_t budget = uploadsPerPaint;
        waiting_ = false;
        for (std::size_t i = 0; i < nearest.size(); ++i) {
            LayerActor& chosen = rest[i] ? nearest[i]->rest : nearest[i]->moving;
            if (chosen.next) {
                const std::size_t cost = std::min(chosen.next->triangles, uploadsPerPaint);
                if (cost > budget) {
                    waiting_ = true;
                    budget = 0;
                    continue;
                }
                budget -= cost;
                chosen.load();
            }
            if (chosen.loaded) nearest[i]->drawn = &chosen;
        }
    }

    void findBare() {
        if (groups_.empty() || std::any_of(groups_.begin(), groups_.end(), [](const Group& g) { return !g.drawn; }))
            return bare_.reset();
        BareBricks bare(grid_);
        for (const Group& group : groups_) bare.mark(group.drawn->bare);
        if (!bare_ || bare != *bare_) bare_ = std::make_shared<const BareBricks>(std::move(bare));
    }

    void draw(Group& group) const {
        for (LayerActor* one : {&group.moving, &group.rest})
            one->actor->SetVisibility(visible_ && opacity_ >= 1.0 && one == group.drawn && one->triangles > 0);
    }

    void dress(Group& group) const {
        for (LayerActor* one : {&group.moving, &group.rest}) {
            setBlended(*one->actor, opacity_);
            clipBy(*one->actor, clip_);
            // At a section, the cut face and the surface may be slightly apart; the back faces then close the gap.
            one->actor->GetProperty()->SetBackfaceCulling(clip_ == nullptr);
        }
    }

    void showGlass() {
        glass_->SetVisibility(isGlass());
        std::vector<vtkActor*> drawn;
        if (isGlass())
            for (const Group& group : groups_)
                if (group.drawn != nullptr && group.drawn->triangles > 0) drawn.push_back(group.drawn->actor);
        glass_->set(std::move(drawn));
    }

    vtkRenderer &renderer_, &films_;
    vtkNew<GlassProp> glass_;
    vtkSmartPointer<vtkPlane> clip_;
    double opacity_ = 1.0;
    std::function<void()> ready_;
    std::vector<Group> groups_;
    std::shared_ptr<const BareBricks> bare_;
    Grid grid_;
    std::uint64_t volume_ = 0;
    bool visible_ = true, waiting_ = false;
    std::optional<CutTime> cut_, cutShown_;
    WorkpieceMesher mesher_; ///< last member: its thread ends before the other members are destroyed
};

WorkpieceActors::WorkpieceActors(vtkRenderer& solids, vtkRenderer& films, std::function<void()> ready)
    : impl_(std::make_unique<Impl>(solids, films, std::move(ready))) {}
WorkpieceActors::~WorkpieceActors() = default;

void WorkpieceActors::show(const VolumeSnapshot& workpiece, std::optional<CutTime> oldestCut) {
    impl_->mesher().show(workpiece, oldestCut);
}
void WorkpieceActors::setVisible(bool visible) {
    impl_->setVisible(visible);
}
void WorkpieceActors::setOpacity(double opacity) {
    impl_->setOpacity(opacity);
}
bool WorkpieceActors::filmsVisible() const noexcept {
    return impl_->isGlass();
}
void WorkpieceActors::setClip(vtkPlane* clip) {
    impl_->setClip(clip);
}
void WorkpieceActors::setPartDrawn(bool drawn) {
    impl_->mesher().setPartDrawn(drawn);
}
void WorkpieceActors::setPartColour(const std::array<std::uint8_t, 3>& colour) {
    impl_->mesher().setPartColour(colour);
}
void WorkpieceActors::setExcess(std::optional<ExcessColours> left) {
    impl_->mesher().setExcess(std::move(left));
}
void WorkpieceActors::update(bool moving, const glm::dvec3& focus) {
    impl_->update(moving, focus);
}
void WorkpieceActors::setDepthCue(const DepthCue& cue) {
    impl_->setDepthCue(cue);
}
const std::shared_ptr<const BareBricks>& WorkpieceActors::bare() const noexcept {
    return impl_->bare();
}
std::uint64_t WorkpieceActors::volume() const {
    return impl_->volume();
}
std::size_t WorkpieceActors::triangles() const {
    return impl_->triangles();
}
bool WorkpieceActors::fullDetail() const {
    return impl_->fullDetail();
}
bool WorkpieceActors::busy() const {
    return impl_->mesher().busy() || impl_->waiting();
}
std::optional<CutTime> WorkpieceActors::takeCutShown() {
    return impl_->takeCutShown();
}

} // namespace burin
