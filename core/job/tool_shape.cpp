// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/tool_shape.h"

#include "core/base/numbers.h"
#include "core/tool/hollow_tip.h"
#include "core/tool/revolution_envelope.h"
#include "core/tool/tool_solid.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

// A tick sweeps each piece of a profile: more pieces would take too long.
constexpr std::size_t mostLines = 48;

/// Returns all bodies of a model as one mesh.
Result<TriangleMesh> closedMesh(const std::filesystem::path& file, const ImportOptions& options, Progress& progress) {
    const Result<Model> model = importModel(file, options, progress);
    if (!model) return model.error();
    TriangleMesh mesh;
    for (const Body& body : model->bodies) append(mesh, body.mesh);
    if (countOpenEdges(weldIdenticalVertices(mesh)) > 0)
        return Error{ErrorCode::argumentInvalid, file.filename().string(), {}, "a closed surface; close its holes"};
    return mesh;
}

void lift(TriangleMesh& mesh, double height) {
    for (glm::dvec3& vertex : mesh.vertices) vertex.z += height;
}

/// Returns the finest profile that does not have too many lines, starting at the given tolerance.
Result<RevolutionEnvelope> profileOf(const TriangleMesh& mesh, double tolerance) {
    for (;; tolerance *= 2.0) {
        Result<RevolutionEnvelope> envelope = revolutionEnvelope(mesh, tolerance);
        if (!envelope || envelope->profile.size() <= mostLines) return envelope;
    }
}

double widestOf(const TriangleMesh& mesh) {
    double widest = 0.0;
    for (const glm::dvec3& vertex : mesh.vertices) widest = std::max(widest, std::hypot(vertex.x, vertex.y));
    return widest;
}

/// Returns the smallest radius of a profile from a height on, mm; 0 if the height is below the tip.
double narrowestFrom(double height, const std::vector<ProfileElement>& profile) {
    if (height < 0.0) return 0.0;
    double narrowest = profile.back().radius;
    ProfileElement before;
    for (const ProfileElement& line : profile) {
        if (line.height > height) narrowest = std::min({narrowest, line.radius, before.radius}); // entire lines: safe
        before = line;
    }
    return narrowest;
}

Result<void> takeShank(const TriangleMesh& shank, const RevolutionEnvelope& flutes, Cutter& cutter) {
    const Box box = boundingBox(shank);
    if (box.high.z < cutter.fluteLength)
        return Error{ErrorCode::argumentInvalid, "shank", formatShortest(box.high.z) + " mm",
                     "one that ends above the flutes"};
    cutter.shankDiameter = 2.0 * widestOf(shank);
    if (box.low.z < cutter.fluteLength - 1e-6 && cutter.shankDiameter > 2.0 * narrowestFrom(box.low.z, flutes.profile))
        return Error{ErrorCode::argumentInvalid, "shank", formatShortest(box.low.z) + " mm",
                     "one that begins where the flutes end, or lies within them below that"};
    cutter.stickOut = box.high.z;
    return {};
}

} // namespace

Result<ShapedTool> shapedTool(const ToolShapeRequest& request, Progress& progress) {
    Result<TriangleMesh> flutes = [&] {
        const ProgressPart reading(progress, 0.0, request.shank.empty() ? 1.0 : 0.5);
        return closedMesh(request.flutes, request.import, progress);
    }();
    if (!flutes) return flutes.error();
    ShapedTool shaped{request.like, 0.0 - boundingBox(*flutes).low.z}; // never -0
    shaped.tool.presets.clear();                                       // feeds of another shape
    lift(*flutes, shaped.lift);
    const Result<RevolutionEnvelope> envelope = profileOf(*flutes, request.tolerance);
    if (!envelope) return envelope.error();
    shaped.excess = envelope->excess;
    shaped.coarser = shaped.excess > request.tolerance;

    Tool& tool = shaped.tool;
    tool.id = request.id;
    tool.name = request.name;
    tool.source = "profile of " + request.flutes.filename().string() + ", at most " + formatShortest(shaped.excess) +
                  " mm wider; other values like " + request.like.id + ": " + request.like.source;
    Cutter& cutter = tool.cutter;
    const double free = std::max(0.0, request.like.cutter.stickOut - request.like.cutter.fluteLength);
    cutter.type = CutterType::profile;
    cutter.profile = envelope->profile;
    cutter.diameter = 2.0 * envelope->widest;
    cutter.cornerRadius = cutter.tipDiameter = cutter.taperAngle = 0.0;
    cutter.fluteLength = envelope->profile.back().height;
    cutter.stickOut = cutter.fluteLength + free;
    tool.maximumDepthOfCut = std::min(tool.maximumDepthOfCut, cutter.fluteLength);
    ToolSolid solid{weldIdenticalVertices(*flutes), {}, request.angle};
    if (!request.shank.empty()) {
        const ProgressPart reading(progress, 0.5, 1.0);
        Result<TriangleMesh> shank = closedMesh(request.shank, request.import, progress);
        if (!shank) return shank.error();
        lift(*shank, shaped.lift);
        if (Result<void> taken = takeShank(*shank, *envelope, cutter); !taken) return taken.error();
        solid.shank = weldIdenticalVertices(*shank);
    }
    if (!request.turns) {
        cutter.solid = std::make_shared<const ToolSolid>(std::move(solid));
        tool.source = "models of " + tool.source;
    } else if (const auto hollow =
                   hollowSection(solid.flutes, cutter.profile, std::max(request.tolerance, shaped.excess), progress)) {
        cutter.solid = std::make_shared<const ToolSolid>(turningSolid(hollow->section, cutter.profile));
        shaped.hollowExcess = hollow->excess;
        tool.source = "section and " + tool.source;
    }
    if (progress.cancelled()) return Error{ErrorCode::cancelled, request.flutes.filename().string(), {}, {}};
    if (Result<void> valid = validate(tool); !valid) return valid.error();
    return shaped;
}

} // namespace burin
