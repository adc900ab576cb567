// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/array_file.h"

#include "core/base/available_memory.h"
#include "core/base/file.h"
#include "core/base/json_object.h"
#include "core/base/numbers.h"
#include "core/base/trimmed.h"
#include "core/volume/runs/grid.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <sstream>

namespace burin {

namespace {

namespace fs = std::filesystem;

enum class Encoding { raw, gzip };

/// The description of the data in a header.
struct Layout {
    glm::ivec3 count{0};
    double edge = 1.0;
    glm::dvec3 first{0.0}; ///< mm, centre of the first voxel, or its low corner
    bool cornerGiven = false, unitKnown = true;
    std::size_t type = 0; ///< index in VoxelArray::Values
    Encoding encoding = Encoding::raw;
    bool bigEndian = false;
    std::string dataFile;      ///< empty if the data follow the header
    std::size_t dataBegin = 0; ///< offset in the content behind the header
};

constexpr std::array<std::size_t, 10> typeSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};

/// Names of types and their index in VoxelArray::Values.
const std::map<std::string, std::size_t, std::less<>> typeNames{
    {"signed char", 0},
    {"int8", 0},
    {"int8_t", 0},
    {"uchar", 1},
    {"unsigned char", 1},
    {"uint8", 1},
    {"uint8_t", 1},
    {"short", 2},
    {"short int", 2},
    {"signed short", 2},
    {"int16", 2},
    {"int16_t", 2},
    {"ushort", 3},
    {"unsigned short", 3},
    {"unsigned short int", 3},
    {"uint16", 3},
    {"uint16_t", 3},
    {"int", 4},
    {"signed int", 4},
    {"int32", 4},
    {"int32_t", 4},
    {"uint", 5},
    {"unsigned int", 5},
    {"uint32", 5},
    {"uint32_t", 5},
    {"longlong", 6},
    {"long long", 6},
    {"int64", 6},
    {"int64_t", 6},
    {"ulonglong", 7},
    {"unsigned long long", 7},
    {"uint64", 7},
    {"uint64_t", 7},
    {"float", 8},
    {"double", 9},
};

/// mm per unit of length.
const std::map<std::string, double, std::less<>> lengthUnits{
    {"mm", 1.0},  {"millimeter", 1.0}, {"millimeters", 1.0}, {"cm", 10.0}, {"m", 1000.0},  {"meter", 1000.0},
    {"um", 1e-3}, {"micron", 1e-3},    {"\xC2\xB5m", 1e-3},  {"in", 25.4}, {"inch", 25.4}, {"inches", 25.4}};

Error damaged(const std::string& file, std::string place, std::string why) {
    return {ErrorCode::fileDamaged, file, std::move(place), std::move(why)};
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

/// "(1,0,0)"
std::optional<glm::dvec3> vectorOf(const std::string& text) {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')') return std::nullopt;
    glm::dvec3 vector(0.0);
    std::istringstream parts(text.substr(1, text.size() - 2));
    std::string part;
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::getline(parts, part, ',')) return std::nullopt;
        const std::optional<double> number = parseNumber(trimmed(part));
        if (!number) return std::nullopt;
        vector[axis] = *number;
    }
    return std::getline(parts, part) ? std::nullopt : std::optional(vector);
}

/// The fields of a NRRD header, each with its line.
class NrrdHeader {
public:
    NrrdHeader(std::string_view content, std::string file) : file_(std::move(file)) { split(content); }

    Result<Layout> read() {
        Layout layout;
        for (Result<void> done : {readSizes(layout), readType(layout), readEncoding(layout), readUnit(layout),
                                  readSpacing(layout), readOrigin(layout), readPlace(layout)})
            if (!done) return std::move(done).error();
        return layout;
    }

private:
    struct Field {
        std::string value;
        int line = 0;
    };

    void split(std::string_view content) {
        int line = 0;
        for (std::size_t at = 0; at < content.size();) {
            const std::size_t end = std::min(content.find('\n', at), content.size());
            const std::string text(trimmed(content.substr(at, end - at)));
            at = std::min(end + 1, content.size());
            ++line;
            if (line == 1 || text.starts_with('#')) continue;
            if (text.empty()) { // the data follow
                end_ = at;
                return;
            }
            const std::size_t colon = text.find(':');
            if (colon == std::string::npos || text.substr(colon).starts_with(":=")) continue; // a key-value pair
            std::string key = text.substr(0, colon);
            std::ranges::transform(key, key.begin(),
                                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            fields_.try_emplace(std::move(key),
                                Field{std::string(trimmed(std::string_view(text).substr(colon + 1))), line});
        }
        end_ = content.size();
    }

    const Field* field(std::string_view key) const {
        const auto found = fields_.find(key);
        return found == fields_.end() ? nullptr : &found->second;
    }
    Error wrong(const Field& field, std::string why) const {
        return damaged(file_, "line " + std::to_string(field.line), std::move(why));
    }
    Error lacks(const char* key) const { return damaged(file_, key, "the header does not say it"); }

    Result<void> readSizes(Layout& layout) const {
        const Field* dimension = field("dimension");
        if (dimension == nullptr) return lacks("dimension");
        if (dimension->value != "3")
            return Error{
                ErrorCode::notSupported, "an array of " + dimension->value + " dimensions", "three dimensions", {}};
        const Field* sizes = field("sizes");
        if (sizes == nullptr) return lacks("sizes");
        const std::vector<std::string> words = wordsOf(sizes->value);
        if (words.size() != 3) return wrong(*sizes, "three sizes are needed");
        for (int axis = 0; axis < 3; ++axis) {
            const std::optional<double> count = parseNumber(words[static_cast<std::size_t>(axis)]);
            if (!count || !(*count >= 1.0) || *count != std::floor(*count))
                return wrong(*sizes, "a size has to be a whole number above 0");
            if (*count > Grid::maximumVoxelsPerAxis)
                return Error{ErrorCode::volumeTooLarge,
                             formatFixed(*count, 0) + " voxels on one axis",
                             std::to_string(Grid::maximumVoxelsPerAxis) + " voxels",
                             {}};
            layout.count[axis] = static_cast<int>(*count);
        }
        return {};
    }

    Result<void> readType(Layout& layout) const {
        const Field* type = field("type");
        if (type == nullptr) return lacks("type");
        const auto found = typeNames.find(type->value);
        if (found == typeNames.end()) return wrong(*type, "not a type of number: " + type->value);
        layout.type = found->second;
        const Field* endian = field("endian");
        if (endian != nullptr && endian->value != "little" && endian->value != "big")
            return wrong(*endian, "little or big");
        if (endian == nullptr && typeSizes[layout.type] > 1) return lacks("endian");
        layout.bigEndian = endian != nullptr && endian->value == "big";
        return {};
    }

    Result<void> readEncoding(Layout& layout) const {
        const Field* encoding = field("encoding");
        if (encoding == nullptr) return lacks("encoding");
        if (encoding->value == "raw")
            layout.encoding = Encoding::raw;
        else if (encoding->value == "gzip" || encoding->value == "gz")
            layout.encoding = Encoding::gzip;
        else
            return Error{ErrorCode::notSupported, "the encoding " + encoding->value, "raw or gzip", {}};
        return {};
    }

    /// Stated once per axis; all have to be equal.
    Result<void> readUnit(Layout& layout) {
        const Field* units = field("space units");
        if (units == nullptr) units = field("units");
        layout.unitKnown = false;
        if (units == nullptr) return {};
        const std::size_t open = units->value.find('"');
        const std::size_t close = open == std::string::npos ? open : units->value.find('"', open + 1);
        if (close == std::string::npos) return wrong(*units, "a unit in quotation marks");
        const std::string unit = units->value.substr(open + 1, close - open - 1);
        const auto found = lengthUnits.find(unit);
        if (found == lengthUnits.end()) return wrong(*units, "not a unit of length: " + unit);
        unit_ = found->second;
        layout.unitKnown = true;
        return {};
    }

    Result<void> readSpacing(Layout& layout) const {
        glm::dvec3 spacing(1.0);
        const Field* directions = field("space directions");
        const Field* spacings = field("spacings");
        if (directions != nullptr) {
            const std::vector<std::string> words = wordsOf(directions->value);
            if (words.size() != 3) return wrong(*directions, "three directions are needed");
            for (int axis = 0; axis < 3; ++axis) {
                const std::optional<glm::dvec3> direction = vectorOf(words[static_cast<std::size_t>(axis)]);
                if (!direction) return wrong(*directions, "a direction has to be three numbers in brackets");
                glm::dvec3 across = *direction;
                across[axis] = 0.0;
                if (glm::length(across) > 1e-9 * glm::length(*direction) || !((*direction)[axis] > 0.0))
                    return Error{ErrorCode::notSupported,
                                 "an array whose axes are turned or mirrored",
                                 "axes along +X, +Y and +Z",
                                 {}};
                spacing[axis] = (*direction)[axis];
            }
        } else if (spacings != nullptr) {
            const std::vector<std::string> words = wordsOf(spacings->value);
            if (words.size() != 3) return wrong(*spacings, "three spacings are needed");
            for (int axis = 0; axis < 3; ++axis) {
                const std::optional<double> number = parseNumber(words[static_cast<std::size_t>(axis)]);
                if (!number || !(*number > 0.0)) return wrong(*spacings, "a spacing has to be above 0");
                spacing[axis] = *number;
            }
        }
        if (!(std::abs(spacing.y / spacing.x - 1.0) < 1e-6) || !(std::abs(spacing.z / spacing.x - 1.0) < 1e-6))
            return Error{ErrorCode::notSupported, "voxels that are no cubes", "the same spacing along all axes", {}};
        layout.edge = spacing.x * unit_;
        if (!std::isfinite(layout.edge) || !(layout.edge > 0.0)) return lacks("space directions");
        return {};
    }

    /// The centre of the first voxel, as NRRD defines it for cell-centred values.
    Result<void> readOrigin(Layout& layout) const {
        const Field* origin = field("space origin");
        if (origin == nullptr) {
            layout.cornerGiven = true;
            return {};
        }
        const std::optional<glm::dvec3> place = vectorOf(origin->value);
        if (!place) return wrong(*origin, "three numbers in brackets");
        layout.first = *place * unit_;
        return {};
    }

    Result<void> readPlace(Layout& layout) const {
        for (const char* key : {"line skip", "byte skip"})
            if (const Field* skip = field(key); skip != nullptr && skip->value != "0")
                return Error{ErrorCode::notSupported, key, "data that begin at once", {}};
        const Field* data = field("data file");
        if (data == nullptr) data = field("datafile");
        if (data != nullptr) layout.dataFile = data->value;
        layout.dataBegin = end_;
        return {};
    }

    std::string file_;
    std::map<std::string, Field, std::less<>> fields_;
    std::size_t end_ = 0;
    double unit_ = 1.0; ///< mm
};

/// Raw data with Burin's own header.
Result<Layout> readJsonHeader(const std::string& content, const std::string& file) {
    Result<JsonObject> header = JsonObject::parse(content, file);
    if (!header) return std::move(header).error();
    Layout layout;
    layout.dataFile = header->text("data_file");
    const std::string type = header->text("type");
    const std::vector<double> sizes =
        header->numbers("sizes", 3, {1.0, static_cast<double>(Grid::maximumVoxelsPerAxis)});
    layout.edge = header->number("spacing_mm", {1e-6, 1e6});
    layout.cornerGiven = true;
    if (header->has("low_corner_mm")) {
        const std::vector<double> low = header->numbers("low_corner_mm", 3, {-1e6, 1e6});
        layout.first = {low[0], low[1], low[2]};
    }
    if (header->has("endian")) layout.bigEndian = header->choice("endian", {"little", "big"}) == 1;
    const auto found = typeNames.find(type);
    if (found == typeNames.end()) header->fail("type", "is not a type of number");
    for (int axis = 0; axis < 3; ++axis) {
        const double size = sizes[static_cast<std::size_t>(axis)];
        if (size != std::floor(size)) header->fail("sizes", "have to be whole numbers");
        layout.count[axis] = static_cast<int>(size);
    }
    if (Result<void> read = header->finish(); !read) return std::move(read).error();
    layout.type = found->second;
    return layout;
}

/// Decompresses data of known size. Empty if they are damaged, or of another size.
std::optional<std::string> inflated(std::string_view packed, std::size_t size) {
    std::string data(size, '\0');
    z_stream stream{};
    constexpr int gzipWindow = 15 + 32; // gzip or zlib
    if (inflateInit2(&stream, gzipWindow) != Z_OK) return std::nullopt;
    std::size_t read = 0, written = 0;
    int state = Z_OK;
    constexpr std::size_t most = 1U << 30U; // per call: zlib counts in unsigned int
    while (state == Z_OK) {
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read)); // NOLINT: zlib reads it
        stream.avail_in = static_cast<uInt>(std::min(most, packed.size() - read));
        stream.next_out = reinterpret_cast<Bytef*>(data.data() + written);
        stream.avail_out = static_cast<uInt>(std::min(most, data.size() - written));
        const uInt in = stream.avail_in, out = stream.avail_out;
        state = inflate(&stream, Z_NO_FLUSH);
        read += in - stream.avail_in;
        written += out - stream.avail_out;
        if (in == stream.avail_in && out == stream.avail_out) break; // no progress
    }
    inflateEnd(&stream);
    if (state != Z_STREAM_END || written != size) return std::nullopt;
    return data;
}

template <class Number>
std::vector<Number> numbersOf(std::string_view data, bool swapped) {
    std::vector<Number> numbers(data.size() / sizeof(Number));
    std::memcpy(numbers.data(), data.data(), numbers.size() * sizeof(Number));
    if (!swapped || sizeof(Number) == 1) return numbers;
    for (Number& number : numbers) {
        std::array<char, sizeof(Number)> bytes;
        std::memcpy(bytes.data(), &number, sizeof(Number));
        std::ranges::reverse(bytes);
        std::memcpy(&number, bytes.data(), sizeof(Number));
    }
    return numbers;
}

VoxelArray::Values valuesOf(std::size_t type, std::string_view data, bool swapped) {
    switch (type) {
    case 0:
        return numbersOf<std::int8_t>(data, swapped);
    case 1:
        return numbersOf<std::uint8_t>(data, swapped);
    case 2:
        return numbersOf<std::int16_t>(data, swapped);
    case 3:
        return numbersOf<std::uint16_t>(data, swapped);
    case 4:
        return numbersOf<std::int32_t>(data, swapped);
    case 5:
        return numbersOf<std::uint32_t>(data, swapped);
    case 6:
        return numbersOf<std::int64_t>(data, swapped);
    case 7:
        return numbersOf<std::uint64_t>(data, swapped);
    case 8:
        return numbersOf<float>(data, swapped);
    default:
        return numbersOf<double>(data, swapped);
    }
}

/// Accepts only a file name in the folder of the header: files from untrusted sources must not name others.
Result<std::string> dataOf(const Layout& layout, const fs::path& file, std::string& content) {
    if (layout.dataFile.empty()) return content.substr(std::min(layout.dataBegin, content.size()));
    const fs::path name(layout.dataFile);
    if (name.has_parent_path() || name.empty() || name == ".." || layout.dataFile.find('%') != std::string::npos ||
        layout.dataFile.starts_with("LIST"))
        return Error{ErrorCode::notSupported, "data in " + layout.dataFile, "one file beside the header", {}};
    return readFile(file.parent_path() / name);
}

Result<VoxelArray> arrayOf(const Layout& layout, const fs::path& file, std::string content) {
    const double voxels = 1.0 * layout.count.x * layout.count.y * layout.count.z;
    const double bytes = voxels * static_cast<double>(typeSizes[layout.type]);
    if (const double room = 0.4 * static_cast<double>(availableMemory()); 2.0 * bytes > room)
        return Error{
            ErrorCode::volumeTooLarge, formatFixed(2e-6 * bytes, 0) + " MB", formatFixed(1e-6 * room, 0) + " MB", {}};
    Result<std::string> data = dataOf(layout, file, content);
    if (!data) return std::move(data).error();
    content = {};
    const auto size = static_cast<std::size_t>(bytes);
    if (layout.encoding == Encoding::gzip) {
        std::optional<std::string> unpacked = inflated(*data, size);
        if (!unpacked)
            return damaged(file.string(), "data",
                           "they do not unpack to the " + std::to_string(size) + " bytes that the header says");
        *data = std::move(*unpacked);
    }
    if (data->size() != size)
        return damaged(file.string(), "data",
                       "there are " + std::to_string(data->size()) + " bytes, the header says " + std::to_string(size));
    VoxelArray array;
    array.count = layout.count;
    array.edge = layout.edge;
    array.low = layout.cornerGiven ? layout.first : layout.first - 0.5 * layout.edge;
    array.unitKnown = layout.unitKnown;
    array.file = file.string();
    const bool bigHere = std::endian::native == std::endian::big;
    array.values = valuesOf(layout.type, *data, layout.bigEndian != bigHere);
    return array;
}

} // namespace

double VoxelArray::at(std::size_t place) const {
    return std::visit([place](const auto& numbers) { return static_cast<double>(numbers[place]); }, values);
}

Result<VoxelArray> readArrayFile(const fs::path& file) {
    Result<std::string> content = readFile(file);
    if (!content) return std::move(content).error();
    return readArray(std::move(*content), file);
}

Result<VoxelArray> readArray(std::string content, const fs::path& file) try {
    if (content.empty()) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    Result<Layout> layout = [&]() -> Result<Layout> {
        if (content.starts_with("NRRD000")) return NrrdHeader(content, file.string()).read();
        if (content.starts_with('{')) return readJsonHeader(content, file.string());
        return Error{ErrorCode::fileFormatUnknown, file.string(), {}, {}};
    }();
    if (!layout) return std::move(layout).error();
    return arrayOf(*layout, file, std::move(content));
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, file.string(), {}, {}};
}

std::string nrrdOf(const glm::ivec3& count, double edge, const glm::dvec3& low,
                   const std::vector<std::uint8_t>& values) {
    const auto number = [](double value) { return formatShortest(value); };
    const std::string size = number(edge);
    const glm::dvec3 first = low + 0.5 * edge;
    std::string text =
        "NRRD0004\n# voxels of a workpiece; Burin\ntype: uint8\ndimension: 3\nspace dimension: 3\nsizes: " +
        std::to_string(count.x) + " " + std::to_string(count.y) + " " + std::to_string(count.z) +
        "\nspace directions: (" + size + ",0,0) (0," + size + ",0) (0,0," + size +
        ")\nspace units: \"mm\" \"mm\" \"mm\"\nspace origin: (" + number(first.x) + "," + number(first.y) + "," +
        number(first.z) + ")\nkinds: domain domain domain\nencoding: raw\n\n";
    text.append(reinterpret_cast<const char*>(values.data()), values.size());
    return text;
}

} // namespace burin
