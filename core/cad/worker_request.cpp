// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/byte_stream.h"
#include "core/cad/worker_message.h"

#include <tuple>
#include <type_traits>
#include <utility>

namespace burin {

namespace {

constexpr std::uint32_t requestMark = 0x51525542; // "BURQ"

/// The fields of a request in the order of their bytes, to be written or read.
template <class Of>
auto fieldsOf(Of& of) {
    using Request = std::remove_const_t<Of>;
    if constexpr (std::is_same_v<Request, ReadRequest>)
        return std::tie(of.file, of.meshChord, of.fileUnit, of.unitInstead, of.careful, of.preview);
    else if constexpr (std::is_same_v<Request, DistanceRequest>)
        return std::tie(of.brep, of.solids, of.points);
    else if constexpr (std::is_same_v<Request, EdgeRequest>)
        return std::tie(of.brep, of.solids, of.chord);
    else if constexpr (std::is_same_v<Request, FaceRequest>)
        return std::tie(of.brep, of.solids, of.place);
    else if constexpr (std::is_same_v<Request, MeasureRequest>)
        return std::tie(of.brep, of.solids, of.places);
    else if constexpr (std::is_same_v<Request, PatchRequest>)
        return std::tie(of.brep, of.solids, of.chord, of.careful);
}

void writeField(ByteWriter& to, const std::string& field) {
    to.text(field);
}
void writeField(ByteWriter& to, bool field) {
    to.value(static_cast<std::uint8_t>(field));
}
template <class T>
void writeField(ByteWriter& to, const std::vector<T>& field) {
    to.list(field);
}
template <class T>
void writeField(ByteWriter& to, const T& field) {
    to.value(field);
}

void readField(ByteReader& from, std::string& field) {
    field = from.text();
}
void readField(ByteReader& from, bool& field) {
    field = from.value<std::uint8_t>() != 0; // no byte but 0 and 1 is a bool
}
template <class T>
void readField(ByteReader& from, std::vector<T>& field) {
    field = from.list<T>();
}
template <class T>
void readField(ByteReader& from, T& field) {
    field = from.value<T>();
}

/// The request of a kind with its defaults; empty if there is no such kind.
template <std::size_t... kinds>
std::optional<WorkerRequest> requestOf(std::uint8_t kind, std::index_sequence<kinds...>) {
    std::optional<WorkerRequest> request;
    ((kind == kinds ? static_cast<void>(request.emplace(std::in_place_index<kinds>)) : void()), ...);
    return request;
}

} // namespace

std::string encodeRequest(const WorkerRequest& request) {
    ByteWriter to;
    to.value(requestMark);
    to.value(workerMessageVersion);
    to.value(static_cast<std::uint8_t>(request.index()));
    std::visit(
        [&](const auto& of) {
            std::apply([&](const auto&... fields) { (writeField(to, fields), ...); }, fieldsOf(of));
        },
        request);
    return to.take();
}

std::optional<WorkerRequest> decodeRequest(std::string_view bytes) {
    ByteReader from(bytes);
    if (from.value<std::uint32_t>() != requestMark || from.value<std::uint32_t>() != workerMessageVersion)
        return std::nullopt;
    std::optional<WorkerRequest> request =
        requestOf(from.value<std::uint8_t>(), std::make_index_sequence<std::variant_size_v<WorkerRequest>>());
    if (!request) return std::nullopt;
    std::visit([&](auto& of) { std::apply([&](auto&... fields) { (readField(from, fields), ...); }, fieldsOf(of)); },
               *request);
    if (!from.finished()) return std::nullopt;
    return request;
}

} // namespace burin
