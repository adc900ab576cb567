// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

namespace burin {

namespace {

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

/// A ZIP archive in memory, read-only.
class ZipArchive {
public:
    explicit ZipArchive(std::string_view content) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* source = zip_source_buffer_create(content.data(), content.size(), 0, &error);
        if (source != nullptr) archive_ = zip_open_from_source(source, ZIP_RDONLY, &error);
        if (archive_ == nullptr && source != nullptr) zip_source_free(source);
        zip_error_fini(&error);
    }
    ~ZipArchive() {
        if (archive_ != nullptr) zip_discard(archive_);
    }
    ZipArchive(const ZipArchive&) = delete;
    ZipArchive& operator=(const ZipArchive&) = delete;

    bool isOpen() const noexcept { return archive_ != nullptr; }

    std::optional<zip_uint64_t> find(std::string_view ending) const {
        const zip_int64_t count = archive_ != nullptr ? zip_get_num_entries(archive_, 0) : 0;
        for (zip_int64_t i = 0; i < count; ++i) {
            const char* name = zip_get_name(archive_, static_cast<zip_uint64_t>(i), 0);
            if (name != nullptr && lowered(name).ends_with(ending)) return static_cast<zip_uint64_t>(i);
        }
        return std::nullopt;
    }

    std::optional<std::string> read(zip_uint64_t entry, std::size_t most) const {
        zip_file_t* file = zip_fopen_index(archive_, entry, 0);
        if (file == nullptr) return std::nullopt;
        std::string content;
        std::array<char, 65536> part;
        zip_int64_t count = 0;
        while (content.size() <= most && (count = zip_fread(file, part.data(), part.size())) > 0)
            content.append(part.data(), static_cast<std::size_t>(count));
        zip_fclose(file);
        return count < 0 || content.size() > most ? std::nullopt : std::optional(std::move(content));
    }

private:
    zip_t* archive_ = nullptr;
};

using Source = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;

std::optional<std::string> contentOf(zip_source_t* source) {
    if (zip_source_open(source) != 0) return std::nullopt;
    zip_source_seek(source, 0, SEEK_END);
    const zip_int64_t size = zip_source_tell(source);
    zip_source_seek(source, 0, SEEK_SET);
    std::string content(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    const zip_int64_t read = zip_source_read(source, content.data(), content.size());
    zip_source_close(source);
    return size > 0 && read == size ? std::optional(std::move(content)) : std::nullopt;
}

} // namespace

std::optional<std::string> unzippedFile(std::string_view archive, std::string_view ending, std::size_t most) {
    const ZipArchive zip(archive);
    const std::optional<zip_uint64_t> entry = zip.find(ending);
    return entry ? zip.read(*entry, most) : std::nullopt;
}

bool isArchiveWith(std::string_view content, std::string_view ending) {
    if (!content.starts_with("PK\x03\x04")) return false;
    const ZipArchive zip(content);
    if (zip.isOpen()) return zip.find(ending).has_value();
    return lowered(content.substr(0, 65536)).find(ending) != std::string::npos; // the end of the archive is missing
}

std::optional<std::string> zippedFile(const std::string& name, std::string_view content) {
    const Source whole(zip_source_buffer_create(nullptr, 0, 0, nullptr), &zip_source_free);
    if (!whole) return std::nullopt;
    zip_source_keep(whole.get()); // closing the archive releases one reference, the owner here the other
    zip_t* archive = zip_open_from_source(whole.get(), ZIP_TRUNCATE, nullptr);
    if (archive == nullptr) {
        zip_source_free(whole.get());
        return std::nullopt;
    }
    zip_source_t* file = zip_source_buffer(archive, content.data(), content.size(), 0);
    if (file == nullptr || zip_file_add(archive, name.c_str(), file, ZIP_FL_ENC_UTF_8) < 0) {
        if (file != nullptr) zip_source_free(file);
        zip_discard(archive);
        return std::nullopt;
    }
    if (zip_close(archive) != 0) {
        zip_discard(archive);
        return std::nullopt;
    }
    return contentOf(whole.get());
}

} // namespace burin
