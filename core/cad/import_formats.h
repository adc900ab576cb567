// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace burin {

struct Model;
struct ModelSource;

/// The result of checking whether a file's content is of a format.
struct FormatMatch {
    bool known = false;  ///< the content is of this format
    std::string missing; ///< what the file lacks or where it ends too early; empty: it is complete
};

// The table of the formats that can be imported, one row each. The window uses only the suffixes; the functions that
// recognise and read a content exist in the import program (core/cad/reader), each in the file of its format.

struct StepFormat {
    static constexpr std::string_view name = "STEP";
    static constexpr std::array<std::string_view, 2> suffixes{"step", "stp"};
};
FormatMatch matchFormat(StepFormat format, std::string_view content);
Result<Model> readFormat(StepFormat format, ModelSource& source);

struct BrepFormat {
    static constexpr std::string_view name = "BREP";
    static constexpr std::array<std::string_view, 2> suffixes{"brep", "brp"};
};
FormatMatch matchFormat(BrepFormat format, std::string_view content);
Result<Model> readFormat(BrepFormat format, ModelSource& source);

struct IgesFormat {
    static constexpr std::string_view name = "IGES";
    static constexpr std::array<std::string_view, 2> suffixes{"iges", "igs"};
};
FormatMatch matchFormat(IgesFormat format, std::string_view content);
Result<Model> readFormat(IgesFormat format, ModelSource& source);

struct ThreeMfFormat {
    static constexpr std::string_view name = "3MF";
    static constexpr std::array<std::string_view, 1> suffixes{"3mf"};
};
FormatMatch matchFormat(ThreeMfFormat format, std::string_view content);
Result<Model> readFormat(ThreeMfFormat format, ModelSource& source);

struct AmfFormat {
    static constexpr std::string_view name = "AMF";
    static constexpr std::array<std::string_view, 1> suffixes{"amf"};
};
FormatMatch matchFormat(AmfFormat format, std::string_view content);
Result<Model> readFormat(AmfFormat format, ModelSource& source);

struct PlyFormat {
    static constexpr std::string_view name = "PLY";
    static constexpr std::array<std::string_view, 1> suffixes{"ply"};
};
FormatMatch matchFormat(PlyFormat format, std::string_view content);
Result<Model> readFormat(PlyFormat format, ModelSource& source);

struct OffFormat {
    static constexpr std::string_view name = "OFF";
    static constexpr std::array<std::string_view, 1> suffixes{"off"};
};
FormatMatch matchFormat(OffFormat format, std::string_view content);
Result<Model> readFormat(OffFormat format, ModelSource& source);

struct ObjFormat {
    static constexpr std::string_view name = "OBJ";
    static constexpr std::array<std::string_view, 1> suffixes{"obj"};
};
FormatMatch matchFormat(ObjFormat format, std::string_view content);
Result<Model> readFormat(ObjFormat format, ModelSource& source);

struct StlFormat {
    static constexpr std::string_view name = "STL";
    static constexpr std::array<std::string_view, 1> suffixes{"stl"};
};
FormatMatch matchFormat(StlFormat format, std::string_view content);
Result<Model> readFormat(StlFormat format, ModelSource& source);

/// In the order in which a file's content is checked. STL comes last: a binary STL file can be recognised only by its
/// length.
using ImportFormats = std::tuple<StepFormat, BrepFormat, IgesFormat, ThreeMfFormat, AmfFormat, PlyFormat, OffFormat,
                                 ObjFormat, StlFormat>;

namespace import_formats {

template <class... Formats>
std::vector<std::string_view> suffixesOf(const std::tuple<Formats...>*) {
    std::vector<std::string_view> suffixes;
    (suffixes.insert(suffixes.end(), Formats::suffixes.begin(), Formats::suffixes.end()), ...);
    return suffixes;
}

} // namespace import_formats

/// Returns the suffixes of all formats, in lower case and without a dot, for file dialogs only: the format of a file is
/// decided by its content.
inline std::vector<std::string_view> importSuffixes() {
    return import_formats::suffixesOf(static_cast<const ImportFormats*>(nullptr));
}

} // namespace burin
