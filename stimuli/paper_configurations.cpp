// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/paper_configurations.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/base/error.h"

namespace obscura::stimuli {
namespace {

using renderer::Variant;

std::vector<PaperConfiguration> made() {
    const std::string performance = "Hussain 2021, performance";
    const std::string of_performance =
        "Hussain 2021, Table 3: chosen for speed, after a blur of 4 x 4";
    const std::string quality = "Hussain 2021, quality";
    const std::string of_quality = "Hussain 2021, Table 5: many samples and no blur";
    std::vector<PaperConfiguration> all = {
        {performance, of_performance, {"crytek", 16, {}, "box4"}},
        {performance, of_performance, {"hbao", 36, {{"steps", 6}, {"bias", 0.3}}, "box4"}},
        {performance, of_performance, {"alchemy", 12, {}, "box4"}},
        {quality, of_quality, {"crytek", 64, {}, "none"}},
        {quality,
         of_quality + "; the paper's 20 steps are 16 here, the most there are",
         {"hbao", 256, {{"steps", 16}, {"bias", 0.3}}, "none"}},
        {quality, of_quality, {"alchemy", 64, {}, "none"}},
    };
    for (const int samples : {4, 8, 16, 32, 64, 128}) {
        all.push_back({fmt::format("Whinham 2017, {} samples", samples),
                       "Whinham 2017, 4.1: one of the numbers of samples that it times",
                       {"hemisphere", samples, {}, "box4"}});
    }
    // The chapter gives details and no numbers of samples.
    const auto filion = [&all](const char* name, const char* meaning,
                               std::map<std::string, double> parameters) {
        all.push_back({fmt::format("Filion 2008, {}", name),
                       fmt::format("Filion and McNaughton 2008, 1.2: {}", meaning),
                       {"starcraft2", 16, std::move(parameters), "gaussian_nd"}});
    };
    filion("one radius", "all samples within one radius", {{"small_radius", 0}});
    filion("two radii", "a quarter of the samples close by, for creases", {});
    filion("depth of a quarter", "two radii, on depth of a quarter of the image's sides",
           {{"depth_halvings", 2}});
    return all;
}

}  // namespace

const std::vector<PaperConfiguration>& paper_configurations() {
    static const std::vector<PaperConfiguration> all = made();
    return all;
}

const Variant& paper_variant(const std::string& name, const std::string& technique) {
    const auto& all = paper_configurations();
    const auto found = std::find_if(all.begin(), all.end(), [&](const PaperConfiguration& one) {
        return one.name == name && one.variant.technique == technique;
    });
    if (found == all.end()) {
        throw base::failure("no paper's configuration \"{}\" of {}", name, technique);
    }
    return found->variant;
}

}  // namespace obscura::stimuli
