// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/volume_file.h"
#include "tests/core/volume/volume_fixtures.h"

#include <cstdio>
#include <filesystem>

/// Writes the volumes of tests/fixtures/volumes/v<version>; run once for each released form, never again.
int main(int count, char** arguments) {
    using namespace burin;
    if (count != 2) {
        std::fputs("usage: burin_write_volume_fixtures FOLDER\n", stderr);
        return 2;
    }
    for (const fixture::VolumeFixture& fixture : {fixture::severalBricks(), fixture::manyProperties()}) {
        RunVolume volume = fixture::volumeOf(fixture);
        Progress progress;
        const std::filesystem::path file =
            std::filesystem::path(arguments[1]) / (fixture.name + std::string(".volume"));
        if (!writeVolumeFile(file, volume.snapshot(), progress)) return 1;
    }
    return 0;
}
