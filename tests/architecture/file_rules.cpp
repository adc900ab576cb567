// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

namespace burin::architecture {

namespace fs = std::filesystem;

namespace {

// Written in two pieces, so that this file does not contain what it searches for.
const std::array<std::string, 6> machinePlaces{std::string("/wo") + "rk/",    std::string("/tmp/") + "burin",
                                               std::string("../sha") + "red", std::string("/ho") + "me/",
                                               std::string("/ro") + "ot/",    std::string("C:\\Us") + "ers"};

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool isSource(const std::string& file, const std::string& content) {
    const fs::path path(file);
    constexpr std::array<std::string_view, 10> endings{".h",  ".cpp", ".c",    ".hpp",  ".cmake",
                                                       ".py", ".sh",  ".frag", ".vert", ".glsl"};
    return path.filename() == "CMakeLists.txt" || content.starts_with("#!") ||
           std::ranges::find(endings, path.extension().string()) != endings.end();
}

std::string firstLines(const std::string& content, int count) {
    std::size_t end = 0;
    for (int line = 0; line < count && end != std::string::npos; ++line) end = content.find('\n', end + 1);
    return content.substr(0, end);
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string outputOf(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), &::pclose);
    std::string output;
    std::array<char, 4096> block{};
    while (pipe) {
        const std::size_t size = std::fread(block.data(), 1, block.size(), pipe.get());
        if (size == 0) break;
        output.append(block.data(), size);
    }
    return output;
}

bool isBuilt(const fs::path& file) {
    constexpr std::array<std::string_view, 4> folders{"build", "out", ".git", ".cache"};
    return std::ranges::find(folders, file.begin()->string()) != folders.end();
}

} // namespace

std::vector<std::string> projectFiles(const fs::path& root) {
    if (fs::exists(root / ".git")) {
        std::vector<std::string> files = linesOf(outputOf("git -C '" + root.string() + "' ls-files 2>/dev/null"));
        std::erase_if(files, [&](const std::string& file) { return !fs::is_regular_file(root / file); });
        if (!files.empty()) return files;
    }
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        const fs::path file = fs::relative(entry.path(), root);
        if (entry.is_regular_file() && !isBuilt(file)) files.push_back(file.generic_string());
    }
    return files;
}

std::vector<std::string> missingLicences(const fs::path& root, const std::vector<std::string>& files) {
    std::vector<std::string> faults;
    for (const std::string& file : files) {
        const std::string content = contentOf(root / file);
        if (!isSource(file, content)) continue;
        const std::string top = firstLines(content, 4);
        if (top.find("SPDX-FileCopyrightText: ") == std::string::npos ||
            top.find("SPDX-License-Identifier: Apache-2.0") == std::string::npos)
            faults.push_back(file);
    }
    return faults;
}

std::vector<std::string> namedMachines(const fs::path& root, const std::vector<std::string>& files) {
    std::vector<std::string> faults;
    for (const std::string& file : files) {
        const std::string content = contentOf(root / file);
        for (const std::string& place : machinePlaces)
            if (content.find(place) != std::string::npos) faults.push_back(file + ": " + place);
    }
    return faults;
}

} // namespace burin::architecture
