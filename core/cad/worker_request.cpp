// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/byte_stream.h"
#include "core/cad/worker_message.h"

#include <utility>

namespace burin {

namespace {

constexpr std::uint32_t requestMark = 0x51525542; // "BURQ"

} // namespace

std::string encodeRequest(const WorkerRequest& request) {
    ByteWriter to;
    to.value(requestMark);
    to.value(workerMessageVersion);
    to.value(static_cast<std::uint8_t>(request.index()));
    if (const auto* read = std::get_if<ReadRequest>(&request)) {
        to.text(read->file);
        to.value(read->meshChord);
        to.value(read->fileUnit);
        to.value(read->unitInstead);
        to.value(static_cast<std::uint8_t>(read->careful));
        to.value(static_cast<std::uint8_t>(read->preview));
    } else if (const auto* distance = std::get_if<DistanceRequest>(&request)) {
        to.text(distance->brep);
        to.list(distance->solids);
        to.list(distance->points);
    } else if (const auto* edges = std::get_if<EdgeRequest>(&request)) {
        to.text(edges->brep);
        to.list(edges->solids);
        to.value(edges->chord);
    } else if (const auto* face = std::get_if<FaceRequest>(&request)) {
        to.text(face->brep);
        to.list(face->solids);
        to.value(face->place);
    } else if (const auto* measure = std::get_if<MeasureRequest>(&request)) {
        to.text(measure->brep);
        to.list(measure->solids);
        to.list(measure->places);
    } else if (const auto* patches = std::get_if<PatchRequest>(&request)) {
        to.text(patches->brep);
        to.list(patches->solids);
        to.value(patches->chord);
        to.value(static_cast<std::uint8_t>(patches->careful));
    }
    return to.take();
}

std::optional<WorkerRequest> decodeRequest(std::string_view bytes) {
    ByteReader from(bytes);
    if (from.value<std::uint32_t>() != requestMark || from.value<std::uint32_t>() != workerMessageVersion)
        return std::nullopt;
    WorkerRequest request;
    const auto kind = from.value<std::uint8_t>();
    if (kind == 0) {
        ReadRequest read;
        read.file = from.text();
        read.meshChord = from.value<double>();
        read.fileUnit = from.value<double>();
        read.unitInstead = from.value<double>();
        read.careful = from.value<std::uint8_t>() != 0;
        read.preview = from.value<std::uint8_t>() != 0;
        request = std::move(read);
    } else if (kind == 1) {
        DistanceRequest distance;
        distance.brep = from.text();
        distance.solids = from.list<std::uint32_t>();
        distance.points = from.list<glm::dvec3>();
        request = std::move(distance);
    } else if (kind == 2) {
        EdgeRequest edges;
        edges.brep = from.text();
        edges.solids = from.list<std::uint32_t>();
        edges.chord = from.value<double>();
        request = std::move(edges);
    } else if (kind == 4) {
        MeasureRequest measure;
        measure.brep = from.text();
        measure.solids = from.list<std::uint32_t>();
        measure.places = from.list<glm::dvec3>();
        request = std::move(measure);
    } else if (kind == 5) {
        PatchRequest patches;
        patches.brep = from.text();
        patches.solids = from.list<std::uint32_t>();
        patches.chord = from.value<double>();
        patches.careful = from.value<std::uint8_t>() != 0;
        request = std::move(patches);
    } else if (kind == 3) {
        FaceRequest face;
        face.brep = from.text();
        face.solids = from.list<std::uint32_t>();
        face.place = from.value<glm::dvec3>();
        request = std::move(face);
    } else {
        return std::nullopt;
    }
    if (!from.finished()) return std::nullopt;
    return request;
}

} // namespace burin
