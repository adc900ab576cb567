// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/geometry/placement.h"
#include "ui/scene/part_cells.h"
#include "ui/scene/shaded_mesh.h"
#include "ui/scene/sight.h"
#include "ui/scene/view_lights.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// A body of the part, ready to be drawn.
struct ShadedBody {
    std::shared_ptr<const ShadedMesh> mesh; ///< not null
    std::optional<QColor> colour;           ///< from the file; empty: the part's blue
};

/// @param crease rad, as in `shaded`
ShadedBody shadedBody(const TriangleMesh& mesh, const std::optional<std::array<std::uint8_t, 3>>& colour,
                      const FaceColours& faces, double crease = creaseAngle);
/// Takes some tenths of a second for a large model: call on a worker thread.
std::vector<ShadedBody> shadedBodies(const Model& model);

/// The simplified bodies that are drawn while things move and from a distance.
struct CoarseBodies {
    std::vector<vtkSmartPointer<vtkPolyData>> surfaces; ///< one per body; null: the body itself is coarse enough
    double error = 0.0;                                 ///< maximum deviation from the bodies, mm
};
/// Takes about half a second for sixty thousand triangles: call on a worker thread once the part is visible.
/// @param size the part's diagonal, mm
CoarseBodies coarseBodies(const std::vector<ShadedBody>& bodies, double size);

/// The bare part: bodies in their colours, smoothly shaded, with feature edges. Also draws the ghost of the part that
/// is visible through the stock.
class PartActors {
public:
    /// @param solids draws the workpiece, @param marks draws what is never hidden
    PartActors(vtkRenderer& solids, vtkRenderer& marks) : solids_(solids), marks_(marks) {}

    void setBodies(std::vector<ShadedBody> bodies);
    /// For the current bodies; until this is called they are always drawn in full.
    void setCoarse(const CoarseBodies& coarse);
    void setColours(const QColor& part, const QColor& edges);
    void setVisible(bool visible);
    void setHidden(std::vector<bool> hidden); ///< by body; bodies beyond its size are drawn
    /// By body, instead of those in ShadedBody; empty: the part's blue. Bodies beyond its size keep their own. Faces
    /// with a colour of their own keep it.
    void setBodyColours(std::vector<std::optional<QColor>> colours);
    /// Whether the part is drawn in its blue where the workpiece is bare, whether visible or not; this doesn't make it
    /// pickable.
    void setInWorkpiece(bool drawn);
    /// Sets where the workpiece is bare; null: it may be bare anywhere.
    void setBare(const std::shared_ptr<const BareBricks>& bare);
    /// Draws only what a plane doesn't cut off; null: everything. The plane may be moved.
    void setClip(vtkPlane* clip);
    /// Shows the ghost; for a part with very many triangles, only the edges.
    void setGhost(bool visible);
    bool ghostVisible() const noexcept { return ghost_ && !bodies_.empty(); }
    /// Whether something else is drawn in place of the surfaces: edges and picking remain.
    void setCovered(bool covered);
    /// Draws the part after everything added to the renderer so far: what hides much of the part is then drawn first,
    /// which saves most of the part's pixels.
    void drawLast();
    /// Chooses the detail of the surfaces: coarse while something moves, or if the difference would not be visible.
    /// @param pixel length that a screen pixel covers, mm
    void setDetail(bool moving, double pixel);
    /// Draws the bodies moved from their positions. Picking doesn't follow.
    void setMotion(const Placement& motion);
    void setLineWidth(double screenPixels);
    void setDepthCue(const DepthCue& cue);
    /// The nearest point on a sight line; std::nullopt if it misses the part or the part isn't shown.
    std::optional<glm::dvec3> pick(const Sight& sight) const;
    std::size_t triangles() const;

private:
    /// The chosen subset of the part's cells.
    struct Piece {
        PartCells cells;
        vtkSmartPointer<vtkActor> actor;
        std::optional<QColor> coloured{}; ///< the body's colour for which its points were coloured last
    };
    struct Drawn {
        Piece surface;
        std::optional<Piece> coarse; ///< empty: as the surface
        Piece edges;
        vtkSmartPointer<vtkActor> ghostSurface, ghostEdges;
        ShadedBody body;
        Piece& shown(bool coarsely) { return coarsely && coarse ? *coarse : surface; }
        const Piece& shown(bool coarsely) const { return coarsely && coarse ? *coarse : surface; }
    };
    template <class Visit>
    static void eachSolid(const Drawn& body, Visit visit) {
        visit(*body.surface.actor);
        if (body.coarse) visit(*body.coarse->actor);
        visit(*body.edges.actor);
    }
    void show(Piece& piece, bool shown) const;
    void colour(Piece& piece, const QColor& body) const;
    bool drawn() const noexcept { return visible_ || inWorkpiece_; }
    bool hides(std::size_t body) const noexcept { return body < hidden_.size() && hidden_[body]; }
    QColor colourOf(std::size_t body) const;
    void add(ShadedBody body);
    void refresh();
    void showSolids();

    vtkRenderer &solids_, &marks_;
    std::vector<Drawn> bodies_;
    std::vector<bool> hidden_;                   ///< by body
    std::vector<std::optional<QColor>> colours_; ///< by body, instead of their own
    vtkSmartPointer<vtkPlane> clip_;
    vtkNew<vtkMatrix4x4> motion_; ///< shared by all actors
    QColor part_, edges_;
    double lineWidth_ = 1.0;
    std::shared_ptr<const BareBricks> bare_;
    std::size_t triangles_ = 0; ///< of all bodies in full
    double coarseError_ = 0.0;  ///< mm
    bool coarse_ = false, visible_ = true, inWorkpiece_ = false, ghost_ = false, covered_ = false;
};

} // namespace burin
