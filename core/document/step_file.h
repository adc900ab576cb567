// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>

namespace burin {

/// Consecutive bytes of a file.
struct FilePart {
    std::uint64_t at = 0, size = 0;
};

/// A file without a name that several owners of bytes share, so that they take up one descriptor. Its space is given
/// back as they leave, where the file system can do that, at the latest with the last one. Any thread.
class StepFile {
public:
    /// The file of a folder; made if nobody has it. Null where that is not possible. @param beside a file in the folder
    static std::shared_ptr<StepFile> in(const std::filesystem::path& beside);

    explicit StepFile(int descriptor) noexcept : descriptor_(descriptor) {} ///< takes ownership
    ~StepFile();
    StepFile(const StepFile&) = delete;
    StepFile& operator=(const StepFile&) = delete;

    /// Appends bytes. @return their part; of size 0 if they could not be written
    FilePart append(std::string_view bytes);
    std::size_t read(std::uint64_t at, std::span<char> into) const noexcept; ///< @return the number of bytes read
    void release(const FilePart& part) noexcept;                             ///< nobody reads it any more

private:
    int descriptor_;
    std::mutex mutex_; ///< of `end_`
    std::uint64_t end_ = 0;
};

} // namespace burin
