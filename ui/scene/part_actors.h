// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "ui/scene/part_cells.h"
#include "ui/scene/shaded_mesh.h"
#include "ui/scene/sight.h"
#include "ui/scene/view_lights.h"

#include <vtkActor.h>
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
    std::optional<QColor> colour;           ///< the file's; none: the part's blue
};

/// @param crease rad, as in `shaded`
ShadedBody shadedBody(const TriangleMesh& mesh, const std::optional<std::array<std::uint8_t, 3>>& colour,
                      double crease = creaseAngle);
/// Takes some tenths of a second for a large model: for a worker thread.
std::vector<ShadedBody> shadedBodies(const Model& model);

/// What is drawn of bodies while things move and from afar.
struct CoarseBodies {
    std::vector<vtkSmartPointer<vtkPolyData>> surfaces; ///< one a body; null: the body itself is coarse enough
    double error = 0.0;                                 ///< how far they may lie from the bodies, mm
};
/// Takes about half a second for sixty thousand triangles: for a worker thread, when the part is to be seen already.
/// @param size the part's diagonal, mm
CoarseBodies coarseBodies(const std::vector<ShadedBody>& bodies, double size);

/// The bare part: bodies in their colours, smooth, with feature edges. And its ghost, seen through the stock.
class PartActors {
public:
    /// @param solids draws the workpiece, @param marks what nothing hides
    PartActors(vtkRenderer& solids, vtkRenderer& marks) : solids_(solids), marks_(marks) {}

    void setBodies(std::vector<ShadedBody> bodies);
    /// Of the bodies that are set; until then these are always drawn in full.
    void setCoarse(const CoarseBodies& coarse);
    void setColours(const QColor& part, const QColor& edges);
    void setVisible(bool visible);
    void setHidden(std::vector<bool> hidden); ///< by body; those that it does not name are drawn
    /// Drawn in the part's blue where the workpiece is bare, whether visible or not; not picked for that.
    void setInWorkpiece(bool drawn);
    /// Where that is; null: it may be bare anywhere.
    void setBare(const std::shared_ptr<const BareBricks>& bare);
    /// Draws only what a plane doesn't cut off; null: all. The plane may be moved.
    void setClip(vtkPlane* clip);
    /// Of a part with very many triangles, the edges alone.
    void setGhost(bool visible);
    bool ghostVisible() const noexcept { return ghost_ && !bodies_.empty(); }
    /// Something else is drawn where the surfaces are: edges and picking stay.
    void setCovered(bool covered);
    /// Behind what was added to the renderer so far: what hides much of the part is drawn before it, which spares most
    /// of its pixels.
    void drawLast();
    /// Chooses how fine the surfaces are drawn: coarsely while something moves, or where nobody could see the
    /// difference.
    /// @param pixel what a screen pixel covers, mm
    void setDetail(bool moving, double pixel);
    void setLineWidth(double screenPixels);
    void setDepthCue(const DepthCue& cue);
    /// The nearest place that a sight meets; nothing: it misses, or the part isn't shown.
    std::optional<glm::dvec3> pick(const Sight& sight) const;
    std::size_t triangles() const;

private:
    /// Of the part's cells, those that are chosen.
    struct Piece {
        PartCells cells;
        vtkSmartPointer<vtkActor> actor;
    };
    struct Drawn {
        Piece surface;
        std::optional<Piece> coarse; ///< none: as the surface
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
    bool drawn() const noexcept { return visible_ || inWorkpiece_; }
    bool hides(std::size_t body) const noexcept { return body < hidden_.size() && hidden_[body]; }
    void add(ShadedBody body);
    void refresh();
    void showSolids();

    vtkRenderer &solids_, &marks_;
    std::vector<Drawn> bodies_;
    std::vector<bool> hidden_; ///< by body
    vtkSmartPointer<vtkPlane> clip_;
    QColor part_, edges_;
    double lineWidth_ = 1.0;
    std::shared_ptr<const BareBricks> bare_;
    std::size_t triangles_ = 0; ///< of all bodies in full
    double coarseError_ = 0.0;  ///< mm
    bool coarse_ = false, visible_ = true, inWorkpiece_ = false, ghost_ = false, covered_ = false;
};

} // namespace burin
