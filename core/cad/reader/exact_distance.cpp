// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/exact_distance.h"

#include "core/cad/reader/measure.h"
#include "core/cad/reader/occt_vectors.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <Extrema_ExtPS.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt2d.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace burin {

namespace {

double distanceTo(const Box& box, const glm::dvec3& point) {
    return glm::length(glm::max(glm::max(box.low - point, point - box.high), glm::dvec3(0.0)));
}

/// The side of a surface on which a point lies; empty if the surface does not determine it.
using Side = std::optional<double>;

/// The nearest point found so far.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Side side; ///< -1 inside, +1 outside
};

class FacePart {
public:
    explicit FacePart(const TopoDS_Face& face) : surface_(face), normal_(face), domain_(face, Precision::PConfusion()) {
        extrema_.Initialize(surface_, surface_.FirstUParameter(), surface_.LastUParameter(), surface_.FirstVParameter(),
                            surface_.LastVParameter(), Precision::Confusion(), Precision::Confusion());
        extrema_.SetFlag(Extrema_ExtFlag_MIN);
    }
    FacePart(const FacePart&) = delete;
    FacePart& operator=(const FacePart&) = delete;

    void search(const glm::dvec3& point, Nearest& nearest) {
        extrema_.Perform(toPoint(point));
        if (!extrema_.IsDone()) return;
        for (int i = 1; i <= extrema_.NbExt(); ++i) {
            const double distance = std::sqrt(extrema_.SquareDistance(i));
            if (distance >= nearest.distance) continue;
            double u = 0.0, v = 0.0;
            extrema_.Point(i).Parameter(u, v);
            const TopAbs_State state = domain_.Perform(gp_Pnt2d(u, v));
            if (state == TopAbs_OUT || state == TopAbs_UNKNOWN) continue;
            nearest = {distance, side(point, u, v, state)};
        }
    }

private:
    /// At a face's border the neighbour also matters: the normal is trusted only inside the face.
    Side side(const glm::dvec3& point, double u, double v, TopAbs_State state) const {
        gp_Pnt foot;
        gp_Vec normal;
        normal_.Normal(u, v, foot,
                       normal); // points out of the material; its length is that of the derivatives' product
        const glm::dvec3 away = point - toVector(foot.XYZ()), direction = toVector(normal.XYZ());
        const double along = glm::dot(away, direction), lengths = glm::length(away) * glm::length(direction);
        if (state != TopAbs_IN || lengths < 1e-12 || std::abs(along) < 0.99 * lengths) return std::nullopt;
        return along < 0.0 ? -1.0 : 1.0;
    }

    BRepAdaptor_Surface surface_;
    BRepGProp_Face normal_;
    BRepTopAdaptor_FClass2d domain_;
    Extrema_ExtPS extrema_;
};

class EdgePart {
public:
    explicit EdgePart(const TopoDS_Edge& edge) : curve_(edge) {
        extrema_.Initialize(curve_, curve_.FirstParameter(), curve_.LastParameter());
    }
    EdgePart(const EdgePart&) = delete;
    EdgePart& operator=(const EdgePart&) = delete;

    void search(const glm::dvec3& point, Nearest& nearest) {
        // A seam is both an edge and inside its face: then the side found by the face is kept.
        constexpr double same = 1e-7;
        extrema_.Perform(toPoint(point));
        if (!extrema_.IsDone()) return;
        for (int i = 1; i <= extrema_.NbExt(); ++i) {
            const double distance = std::sqrt(extrema_.SquareDistance(i));
            if (distance < nearest.distance)
                nearest = {distance, distance > nearest.distance - same ? nearest.side : Side()};
        }
    }

private:
    BRepAdaptor_Curve curve_;
    Extrema_ExtPC extrema_;
};

} // namespace

class ExactDistance::Parts {
public:
    explicit Parts(const TopoDS_Shape& shape) {
        addFaces(shape);
        addEdges(shape);
        TopTools_IndexedMapOfShape corners;
        TopExp::MapShapes(shape, TopAbs_VERTEX, corners);
        for (int i = 1; i <= corners.Extent(); ++i)
            corners_.push_back(toVector(BRep_Tool::Pnt(TopoDS::Vertex(corners(i))).XYZ()));
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
            classifiers_.push_back(std::make_unique<BRepClass3d_SolidClassifier>(solids.Current()));
    }

    double signedDistance(const glm::dvec3& point) {
        Nearest nearest;
        for (const glm::dvec3& corner : corners_)
            nearest.distance = std::min(nearest.distance, glm::distance(point, corner));
        order_.clear();
        for (std::size_t i = 0; i < boxes_.size(); ++i) order_.emplace_back(distanceTo(boxes_[i], point), i);
        std::sort(order_.begin(), order_.end());
        for (const auto& [least, part] : order_) {
            if (least > nearest.distance) break;
            if (part < faces_.size())
                faces_[part]->search(point, nearest);
            else
                edges_[part - faces_.size()]->search(point, nearest);
        }
        return nearest.distance * (nearest.side ? *nearest.side : classify(point));
    }

private:
    void addFaces(const TopoDS_Shape& shape) {
        for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
            faces_.push_back(std::make_unique<FacePart>(TopoDS::Face(faces.Current())));
            addBox(faces.Current());
        }
    }
    void addEdges(const TopoDS_Shape& shape) {
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(shape, TopAbs_EDGE, edges);
        for (int i = 1; i <= edges.Extent(); ++i) {
            const TopoDS_Edge edge = TopoDS::Edge(edges(i));
            if (BRep_Tool::Degenerated(edge)) continue;
            edges_.push_back(std::make_unique<EdgePart>(edge));
            addBox(edge);
        }
    }
    void addBox(const TopoDS_Shape& part) {
        // The optimal box is computed numerically and may be too small by this margin.
        constexpr double margin = 1e-3;
        boxes_.push_back(exactBox(part).grown(margin));
    }
    double classify(const glm::dvec3& point) {
        for (const auto& classifier : classifiers_) {
            classifier->Perform(toPoint(point), Precision::Confusion());
            if (classifier->State() == TopAbs_IN) return -1.0;
        }
        return 1.0;
    }

    std::vector<std::unique_ptr<FacePart>> faces_;
    std::vector<std::unique_ptr<EdgePart>> edges_;
    std::vector<Box> boxes_; // of the faces, then of the edges
    std::vector<glm::dvec3> corners_;
    std::vector<std::unique_ptr<BRepClass3d_SolidClassifier>> classifiers_;
    std::vector<std::pair<double, std::size_t>> order_;
};

ExactDistance::ExactDistance(const TopoDS_Shape& solids) : parts_(std::make_unique<Parts>(solids)) {}

ExactDistance::~ExactDistance() = default;

double ExactDistance::signedDistance(const glm::dvec3& point) {
    return parts_->signedDistance(point);
}

} // namespace burin
