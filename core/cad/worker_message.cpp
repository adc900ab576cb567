// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/worker_message.h"

#include "core/cad/byte_stream.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr std::uint32_t frameMark = 0x46525542; // "BURF"

enum class FrameKind : std::uint32_t { progress, error, model, distances, edges, face, preview, measure, patches };

struct FrameHead {
    std::uint32_t mark = frameMark;
    std::uint32_t version = workerMessageVersion;
    FrameKind kind = FrameKind::progress;
    std::uint32_t reserved = 0;
    std::uint64_t size = 0;     // bytes after the header
    std::uint64_t checksum = 0; // of those bytes
};

/// FNV-1a over words of eight bytes: detects a truncated or overwritten answer, not an attack.
std::uint64_t checksum(std::string_view bytes) noexcept {
    std::uint64_t hash = 14695981039346656037ULL;
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t size = std::min(bytes.size(), sizeof word);
        std::memcpy(&word, bytes.data(), size);
        hash = (hash ^ word) * 1099511628211ULL;
        hash ^= hash >> 32;
        bytes.remove_prefix(size);
    }
    return hash;
}

void write(ByteWriter& to, const Error& error) {
    to.value(error.code);
    to.text(error.subject);
    to.text(error.place);
    to.text(error.detail);
}

void write(ByteWriter& to, const BodyColour& colour) {
    to.value(static_cast<std::uint8_t>(colour.has_value()));
    to.value(colour.value_or(std::array<std::uint8_t, 3>{}));
}

void write(ByteWriter& to, const FaceColours& colours) {
    to.value(static_cast<std::uint64_t>(colours.size()));
    for (const ColouredTriangles& part : colours) {
        to.value(part.first);
        to.value(part.count);
        to.value(part.colour);
    }
}

void write(ByteWriter& to, const Body& body) {
    to.text(body.name);
    write(to, body.colour);
    to.value(body.volume);
    to.value(body.area);
    to.value(body.box);
    to.list(body.mesh.vertices);
    to.list(body.mesh.triangles);
    to.value(static_cast<std::uint64_t>(body.openEdges));
    to.value(static_cast<std::uint64_t>(body.faceCount));
    write(to, body.faceColours);
}

void write(ByteWriter& to, const Model& model) {
    to.text(model.sourceFile);
    to.text(model.format);
    to.text(model.lengthUnit);
    to.value(model.unitScale);
    to.value(model.statedUnit);
    to.value(model.meshChord);
    to.value(static_cast<std::uint64_t>(model.bodies.size()));
    for (const Body& body : model.bodies) write(to, body);
    to.value(static_cast<std::uint64_t>(model.notes.size()));
    for (const ImportNote& note : model.notes) {
        to.value(static_cast<std::uint8_t>(note.kind));
        to.text(note.text);
    }
    to.text(model.brep);
}

void write(ByteWriter& to, const ModelPreview& preview) {
    to.text(preview.sourceFile);
    to.value(static_cast<std::uint64_t>(preview.bodies.size()));
    for (const PreviewBody& body : preview.bodies) {
        to.text(body.name);
        write(to, body.colour);
        to.list(body.mesh.vertices);
        to.list(body.mesh.triangles);
        write(to, body.faceColours);
    }
}

void write(ByteWriter& to, const std::vector<PartEdge>& edges) {
    to.value(static_cast<std::uint64_t>(edges.size()));
    for (const PartEdge& edge : edges) {
        to.list(edge.points);
        to.list(edge.tangents);
        to.value(edge.length);
    }
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Whether all vertices are finite points and all triangles refer to existing ones.
template <class Mesh>
bool isSoundMesh(const Mesh& mesh) {
    const std::size_t count = mesh.vertices.size();
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isFinite) &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                       [count](const auto& t) { return t[0] < count && t[1] < count && t[2] < count; });
}

bool isSound(const Body& body) {
    return std::isfinite(body.volume) && std::isfinite(body.area) && isFinite(body.box.low) &&
           isFinite(body.box.high) && isSoundMesh(body.mesh) && areSound(body.faceColours, body.mesh.triangles.size());
}

Error readError(ByteReader& from) {
    Error error;
    error.code = from.value<ErrorCode>();
    error.subject = from.text();
    error.place = from.text();
    error.detail = from.text();
    return error;
}

BodyColour readColour(ByteReader& from) {
    const bool coloured = from.value<std::uint8_t>() != 0;
    const auto colour = from.value<std::array<std::uint8_t, 3>>();
    return coloured ? std::optional(colour) : std::nullopt;
}

FaceColours readFaceColours(ByteReader& from) {
    constexpr std::size_t size = 11; // bytes
    FaceColours colours;
    for (std::uint64_t left = from.count(size); left > 0; --left) {
        ColouredTriangles& part = colours.emplace_back();
        part.first = from.value<std::uint32_t>();
        part.count = from.value<std::uint32_t>();
        part.colour = from.value<std::array<std::uint8_t, 3>>();
    }
    return colours;
}

Body readBody(ByteReader& from) {
    Body body;
    body.name = from.text();
    body.colour = readColour(from);
    body.volume = from.value<double>();
    body.area = from.value<double>();
    body.box = from.value<Box>();
    body.mesh.vertices = from.list<glm::dvec3>();
    body.mesh.triangles = from.list<std::array<std::uint32_t, 3>>();
    body.openEdges = from.value<std::uint64_t>();
    body.faceCount = from.value<std::uint64_t>();
    body.faceColours = readFaceColours(from);
    return body;
}

std::optional<Model> readModel(ByteReader& from) {
    Model model;
    model.sourceFile = from.text();
    model.format = from.text();
    model.lengthUnit = from.text();
    model.unitScale = from.value<double>();
    model.statedUnit = from.value<double>();
    model.meshChord = from.value<double>();
    constexpr std::size_t leastBody = 72, leastNote = 9; // bytes
    for (std::uint64_t left = from.count(leastBody); left > 0; --left) {
        model.bodies.push_back(readBody(from));
        if (!from.good() || !isSound(model.bodies.back())) return std::nullopt;
    }
    for (std::uint64_t left = from.count(leastNote); left > 0; --left) {
        constexpr auto last = static_cast<std::uint8_t>(ImportNote::Kind::leftOut);
        const auto kind = std::min<std::uint8_t>(from.value<std::uint8_t>(), last);
        model.notes.push_back({static_cast<ImportNote::Kind>(kind), from.text()});
    }
    model.brep = from.text();
    if (!from.finished()) return std::nullopt;
    return model;
}

std::optional<ModelPreview> readPreview(ByteReader& from) {
    constexpr std::size_t leastBody = 36; // bytes
    ModelPreview preview;
    preview.sourceFile = from.text();
    for (std::uint64_t left = from.count(leastBody); left > 0; --left) {
        PreviewBody& body = preview.bodies.emplace_back();
        body.name = from.text();
        body.colour = readColour(from);
        body.mesh.vertices = from.list<glm::vec3>();
        body.mesh.triangles = from.list<std::array<std::uint32_t, 3>>();
        body.faceColours = readFaceColours(from);
        if (!from.good() || !isSoundMesh(body.mesh)) return std::nullopt;
        if (!areSound(body.faceColours, body.mesh.triangles.size())) return std::nullopt;
    }
    if (!from.finished()) return std::nullopt;
    return preview;
}

bool isSound(const PartEdge& edge) {
    return edge.points.size() >= 2 && edge.tangents.size() == edge.points.size() && std::isfinite(edge.length) &&
           std::all_of(edge.points.begin(), edge.points.end(), isFinite) &&
           std::all_of(edge.tangents.begin(), edge.tangents.end(), isFinite);
}

std::optional<std::vector<PartEdge>> readEdges(ByteReader& from) {
    constexpr std::size_t leastEdge = 24; // bytes
    std::vector<PartEdge> edges;
    for (std::uint64_t left = from.count(leastEdge); left > 0; --left) {
        PartEdge edge;
        edge.points = from.list<glm::dvec3>();
        edge.tangents = from.list<glm::dvec3>();
        edge.length = from.value<double>();
        if (!from.good() || !isSound(edge)) return std::nullopt;
        edges.push_back(std::move(edge));
    }
    if (!from.finished()) return std::nullopt;
    return edges;
}

std::optional<PartFace> readFace(ByteReader& from) {
    PartFace face;
    face.kind = from.value<PartFace::Kind>();
    face.place = from.value<glm::dvec3>();
    face.direction = from.value<glm::dvec3>();
    face.corner = from.value<glm::dvec3>();
    const bool sound =
        face.kind <= PartFace::Kind::other && isFinite(face.place) && isFinite(face.direction) && isFinite(face.corner);
    if (!from.finished() || !sound) return std::nullopt;
    return face;
}

void write(ByteWriter& to, const MeasuredFace& face) {
    to.value(face.kind);
    for (const glm::dvec3& each : {face.place, face.corner, face.normal, face.axis, face.axisPlace}) to.value(each);
    for (const double each : {face.radius, face.taper, face.area, face.thickness.value_or(-1.0)}) to.value(each);
}

MeasuredFace readMeasuredFace(ByteReader& from, bool& sound) {
    MeasuredFace face;
    face.kind = from.value<MeasuredFace::Kind>();
    sound = sound && face.kind <= MeasuredFace::Kind::other;
    for (glm::dvec3* each : {&face.place, &face.corner, &face.normal, &face.axis, &face.axisPlace}) {
        *each = from.value<glm::dvec3>();
        sound = sound && isFinite(*each);
    }
    double thickness = 0.0;
    for (double* each : {&face.radius, &face.taper, &face.area, &thickness}) {
        *each = from.value<double>();
        sound = sound && std::isfinite(*each);
    }
    if (thickness >= 0.0) face.thickness = thickness;
    return face;
}

void write(ByteWriter& to, const PartMeasure& measure) {
    write(to, measure.from);
    to.value(static_cast<std::uint8_t>(measure.to && measure.pair));
    if (!measure.to || !measure.pair) return;
    write(to, *measure.to);
    to.value(measure.pair->faces.value_or(-1.0));
    to.value(measure.pair->nearestFrom);
    to.value(measure.pair->nearestTo);
}

std::optional<PartMeasure> readMeasure(ByteReader& from) {
    bool sound = true;
    PartMeasure measure;
    measure.from = readMeasuredFace(from, sound);
    if (from.value<std::uint8_t>() != 0) {
        measure.to = readMeasuredFace(from, sound);
        MeasuredPair pair = pairOf(measure.from, *measure.to);
        const auto apart = from.value<double>();
        if (apart >= 0.0) pair.faces = apart;
        pair.nearestFrom = from.value<glm::dvec3>();
        pair.nearestTo = from.value<glm::dvec3>();
        sound = sound && std::isfinite(apart) && isFinite(pair.nearestFrom) && isFinite(pair.nearestTo);
        measure.pair = pair;
    }
    if (!from.finished() || !sound) return std::nullopt;
    return measure;
}

void write(ByteWriter& to, const std::vector<PartFacePatch>& patches) {
    to.value(static_cast<std::uint64_t>(patches.size()));
    for (const PartFacePatch& patch : patches) {
        to.value(patch.kind);
        to.value(patch.radius);
        to.value(patch.area);
        to.list(patch.mesh.vertices);
        to.list(patch.mesh.triangles);
    }
}

bool isSound(const PartFacePatch& patch) {
    return patch.kind <= MeasuredFace::Kind::other && std::isfinite(patch.radius) && std::isfinite(patch.area) &&
           isSoundMesh(patch.mesh);
}

std::optional<std::vector<PartFacePatch>> readPatches(ByteReader& from) {
    constexpr std::size_t leastPatch = 33; // bytes
    std::vector<PartFacePatch> patches;
    for (std::uint64_t left = from.count(leastPatch); left > 0; --left) {
        PartFacePatch& patch = patches.emplace_back();
        patch.kind = from.value<MeasuredFace::Kind>();
        patch.radius = from.value<double>();
        patch.area = from.value<double>();
        patch.mesh.vertices = from.list<glm::dvec3>();
        patch.mesh.triangles = from.list<std::array<std::uint32_t, 3>>();
        if (!from.good() || !isSound(patch)) return std::nullopt;
    }
    if (!from.finished()) return std::nullopt;
    return patches;
}

std::optional<WorkerFrame> readFrame(FrameKind kind, std::string_view bytes) {
    ByteReader from(bytes);
    switch (kind) {
    case FrameKind::progress: {
        WorkerProgress progress;
        progress.fraction = from.value<double>();
        progress.stage = from.value<ImportStage>();
        progress.done = from.value<double>();
        progress.total = from.value<double>();
        const bool sound = std::isfinite(progress.fraction) && progress.stage <= ImportStage::meshing &&
                           std::isfinite(progress.done) && std::isfinite(progress.total);
        if (from.finished() && sound) return progress;
        return std::nullopt;
    }
    case FrameKind::error: {
        Error error = readError(from);
        if (from.finished()) return WorkerAnswer(std::move(error));
        return std::nullopt;
    }
    case FrameKind::model: {
        std::optional<Model> model = readModel(from);
        if (model) return WorkerAnswer(std::move(*model));
        return std::nullopt;
    }
    case FrameKind::distances: {
        std::vector<double> distances = from.list<double>();
        const bool finite = std::all_of(distances.begin(), distances.end(), [](double d) { return std::isfinite(d); });
        if (from.finished() && finite) return WorkerAnswer(std::move(distances));
        return std::nullopt;
    }
    case FrameKind::edges: {
        std::optional<std::vector<PartEdge>> edges = readEdges(from);
        if (edges) return WorkerAnswer(std::move(*edges));
        return std::nullopt;
    }
    case FrameKind::face: {
        std::optional<PartFace> face = readFace(from);
        if (face) return WorkerAnswer(*face);
        return std::nullopt;
    }
    case FrameKind::measure: {
        std::optional<PartMeasure> measure = readMeasure(from);
        if (measure) return WorkerAnswer(*measure);
        return std::nullopt;
    }
    case FrameKind::patches: {
        std::optional<std::vector<PartFacePatch>> patches = readPatches(from);
        if (patches) return WorkerAnswer(std::move(*patches));
        return std::nullopt;
    }
    case FrameKind::preview: {
        std::optional<ModelPreview> preview = readPreview(from);
        if (preview) return std::move(*preview);
        return std::nullopt;
    }
    }
    return std::nullopt;
}

FrameKind writeFrame(ByteWriter& to, const WorkerFrame& frame) {
    if (const auto* progress = std::get_if<WorkerProgress>(&frame)) {
        to.value(progress->fraction);
        to.value(progress->stage);
        to.value(progress->done);
        to.value(progress->total);
        return FrameKind::progress;
    }
    if (const auto* preview = std::get_if<ModelPreview>(&frame)) {
        write(to, *preview);
        return FrameKind::preview;
    }
    const auto& answer = *std::get_if<WorkerAnswer>(&frame);
    if (const auto* error = std::get_if<Error>(&answer)) {
        write(to, *error);
        return FrameKind::error;
    }
    if (const auto* model = std::get_if<Model>(&answer)) {
        write(to, *model);
        return FrameKind::model;
    }
    if (const auto* edges = std::get_if<std::vector<PartEdge>>(&answer)) {
        write(to, *edges);
        return FrameKind::edges;
    }
    if (const auto* face = std::get_if<PartFace>(&answer)) {
        to.value(face->kind);
        to.value(face->place);
        to.value(face->direction);
        to.value(face->corner);
        return FrameKind::face;
    }
    if (const auto* measure = std::get_if<PartMeasure>(&answer)) {
        write(to, *measure);
        return FrameKind::measure;
    }
    if (const auto* patches = std::get_if<std::vector<PartFacePatch>>(&answer)) {
        write(to, *patches);
        return FrameKind::patches;
    }
    to.list(*std::get_if<std::vector<double>>(&answer));
    return FrameKind::distances;
}

} // namespace

std::string encodeFrame(const WorkerFrame& frame) {
    ByteWriter payload;
    FrameHead head;
    head.kind = writeFrame(payload, frame);
    const std::string bytes = payload.take();
    head.size = bytes.size();
    head.checksum = checksum(bytes);
    ByteWriter whole;
    whole.value(head);
    return whole.take() + bytes;
}

std::optional<WorkerFrame> FrameReader::next() {
    if (damaged_ || waiting_.size() < sizeof(FrameHead)) return std::nullopt;
    FrameHead head;
    std::memcpy(&head, waiting_.data(), sizeof head);
    if (head.mark != frameMark || head.version != workerMessageVersion || head.kind > FrameKind::patches) {
        damaged_ = true;
        return std::nullopt;
    }
    const std::string_view bytes = std::string_view(waiting_).substr(sizeof head);
    if (bytes.size() < head.size) return std::nullopt;
    const std::string_view payload = bytes.substr(0, head.size);
    std::optional<WorkerFrame> frame;
    if (checksum(payload) == head.checksum) frame = readFrame(head.kind, payload);
    damaged_ = !frame;
    waiting_.erase(0, sizeof head + head.size);
    return frame;
}

} // namespace burin
