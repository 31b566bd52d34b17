// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "renderer/denoise/denoise.h"
#include "renderer/gl/context.h"
#include "renderer/gl/embedded_shaders.h"
#include "renderer/hard_cases/hard_case.h"
#include "tests/support/temporary_folder.h"

namespace obscura::renderer {
namespace {

/// A mistake as one makes it: some text of a shader became another.
struct Fault {
    std::string name;
    std::string technique;
    std::string file;
    std::string right;
    std::string wrong;
};

/// Every shader of the program in a folder, where the program reads them while this lives.
class ShaderFolder {
  public:
    ShaderFolder() {
        for (const std::string_view name : shaders::embedded_names()) {
            std::filesystem::create_directories(path_of(name).parent_path());
            write(name, std::string(shaders::embedded(name)));
        }
        setenv("OBSCURA_SHADERS", folder_.path().c_str(), 1);
    }
    ~ShaderFolder() { unsetenv("OBSCURA_SHADERS"); }
    ShaderFolder(const ShaderFolder&) = delete;
    ShaderFolder& operator=(const ShaderFolder&) = delete;

    void write(std::string_view name, const std::string& text) const {
        std::ofstream(path_of(name)) << text;
    }

  private:
    [[nodiscard]] std::filesystem::path path_of(std::string_view name) const {
        return folder_ / std::string(name);
    }

    tests::TemporaryFolder folder_;
};

/// While it lives, one of the folder's shaders has the fault.
class Faulty {
  public:
    Faulty(const ShaderFolder& folder, const Fault& fault)
        : folder_(folder), file_(fault.file), sound_(shaders::embedded(fault.file)) {
        std::string text = sound_;
        const std::size_t at = text.find(fault.right);
        EXPECT_NE(at, std::string::npos) << fault.file << " has no " << fault.right;
        if (at != std::string::npos) text.replace(at, fault.right.size(), fault.wrong);
        folder.write(file_, text);
    }
    ~Faulty() { folder_.write(file_, sound_); }
    Faulty(const Faulty&) = delete;
    Faulty& operator=(const Faulty&) = delete;

  private:
    const ShaderFolder& folder_;
    std::string file_;
    std::string sound_;
};

/// The rows that hold shaders against definitions and do not hold.
std::vector<HardCaseResult> numerical_failures(const std::string& technique,
                                               const std::vector<int>& cases, int size_px) {
    HardCaseOptions options;
    options.techniques = {technique};
    options.cases = cases;
    options.size_px = size_px;
    options.timing = false;
    std::vector<HardCaseResult> failures;
    for (const HardCaseResult& row : run_hard_cases(options)) {
        if (row.against == Against::kDefinition && row.outcome != Outcome::kHolds) {
            failures.push_back(row);
        }
    }
    return failures;
}

/// One context and one folder for all: making them takes longer than finding a fault.
class ShaderFaults : public testing::TestWithParam<Fault> {
  protected:
    ShaderFaults() {
        static const HeadlessContext context;
        static const ShaderFolder folder;
        folder_ = &folder;
    }

    const ShaderFolder* folder_;
};

TEST_P(ShaderFaults, AreFoundByTheRowsThatNothingExcuses) {
    const Faulty faulty(*folder_, GetParam());
    // Filters are met in case 11, frusta that are off their centre in case 10.
    const bool of_filter = GetParam().file.starts_with("denoise/");
    const bool of_lens = GetParam().right.find("ray_offset") != std::string::npos ||
                         GetParam().right.find("axis_px") != std::string::npos;
    const int hard_case = of_filter ? 11 : of_lens ? 10 : 4;
    // Most show in small images.
    const auto found_at = [&](int size_px) {
        return !numerical_failures(GetParam().technique, {hard_case}, size_px).empty();
    };
    EXPECT_TRUE(found_at(32) || found_at(64));
}

// At the other size the hard cases say so of the program's own shaders.
TEST_F(ShaderFaults, AreNotSeenWhereThereAreNone) {
    for (const Technique& technique : techniques()) {
        if (!technique.makes_accessibility()) continue;
        for (const HardCaseResult& row : numerical_failures(technique.name, {4, 10, 11}, 32)) {
            ADD_FAILURE() << row.name << ", " << row.technique << ", " << row.quantity
                          << ": definition " << row.expected << ", measured " << row.measured
                          << ", tolerance " << row.tolerance << "; " << row.note;
        }
    }
}

std::vector<Fault> all_faults() {
    const std::string view_space = "technique/view_space.glsl";
    std::vector<Fault> faults;
    for (const std::string technique : {"blizzard", "raymarch"}) {
        const std::string own = "technique/" + technique + ".glsl";
        const auto add = [&](const char* name, const std::string& file, const char* right,
                             const char* wrong) {
            faults.push_back({technique + '_' + name, technique, file, right, wrong});
        };
        add("RadiusOnePercentOff", view_space, "* p_radius_m", "* (1.01 * p_radius_m)");
        add("MeanOfFewer", own, "float(SAMPLES)", "float(SAMPLES - 1)");
        add("KernelScaled", view_space, "reflect(point", "reflect(0.99 * point");
        add("HemisphereTurnedOver", view_space, "dot(o, n) < 0.0", "dot(o, n) > 0.0");
        add("NormalDecodedOneCodeOff", "passes/normal_codec.glsl", "255.0 - 128.0",
            "255.0 - 127.0");
        add("SquaredOnceTooOften", view_space, "i < SQUARINGS", "i <= SQUARINGS");
        add("FullThresholdIgnored", view_space, "delta < p_full_threshold_m", "delta < 0.0");
        add("NoThresholdTheOtherWay", view_space, "delta > p_no_threshold_m",
            "delta < p_no_threshold_m");
        add("ClampBecameAbs", view_space, "max(0.0, difference)", "abs(difference)");
        add("RayHalfAPixelOff", "passes/accessibility.glsl", "gl_FragCoord.xy / u_size",
            "(gl_FragCoord.xy - 0.5) / u_size");
        add("RayWithoutLensShift", "passes/view.glsl", "u_ray_scale + u_ray_offset", "u_ray_scale");
        add("ProjectedWithoutLensShift", "passes/view.glsl", "+ u_axis_px", "+ 0.5 * u_size");
        add("ProjectedOneThousandthWide", "passes/view.glsl", "* (u_ray_to_px /",
            "* (1.001 * u_ray_to_px /");
        add("DepthOneTexelOff", "passes/view.glsl", "inside ? px",
            "inside ? min(px + vec2(1.0, 0.0), u_size - 1.0)");
        add("OutsideIsTheBorder", "passes/view.glsl", "inside ? px : vec2(0.0)), 0).r",
            "clamp(px, vec2(0.0), u_size - 1.0)), 0).r; inside = true");
    }
    const auto add = [&](const char* technique, const char* name, const char* file,
                         const char* right, const char* wrong) {
        faults.push_back({std::string(technique) + '_' + name, technique, file, right, wrong});
    };
    const char* const march = "technique/raymarch.glsl";
    add("raymarch", "DroppedStep", march, "k <= kSteps", "k < kSteps");
    add("raymarch", "StopsTooEarly", march, "delta >= p_full_threshold_m",
        "delta >= 0.5 * p_full_threshold_m");
    const char* const crytek = "technique/crytek.glsl";
    add("crytek", "OffsetOnePercentOff", crytek, "* p_offset_scale", "* (1.01 * p_offset_scale)");
    add("crytek", "MeanOfFewer", crytek, "float(SAMPLES)", "float(SAMPLES - 1)");
    add("crytek", "NoLastClamp", crytek, "return clamp(mean * mean + mean, 0.0, 1.0)",
        "return mean * mean + mean");
    add("crytek", "NoClampOfWhatIsInvalid", crytek, "clamp(d - ds, 0.0, 1.0)", "abs(d - ds)");
    add("crytek", "ComparedWithItsOwnDepth", crytek, "ds > point.z", "ds > d");
    add("crytek", "InvalidIsLessThanHalf", crytek, "0.5, clamp", "0.45, clamp");
    add("crytek", "RotationTransposed", crytek, "rotation * point", "point * rotation");
    const std::string slices = "technique/slices.glsl";
    for (const std::string technique : {"hbao", "gtao", "bitmask"}) {
        const std::string own = "technique/" + technique + ".glsl";
        const auto add_to = [&](const char* name, const std::string& file, const char* right,
                                const char* wrong) {
            faults.push_back({technique + '_' + name, technique, file, right, wrong});
        };
        add_to("RadiusOnePercentOff", own, "p_radius_m * p_reach", "1.01 * p_radius_m * p_reach");
        add_to("DroppedStep", own, "< kSteps", "< kSteps - 1");
        add_to("PowerOnePercentOff", own, "1.0e-9), p_power", "1.0e-9), 1.01 * p_power");
        add_to("NormalDecodedOneCodeOff", "passes/normal_codec.glsl", "255.0 - 128.0",
               "255.0 - 127.0");
        add_to("RayHalfAPixelOff", "passes/accessibility.glsl", "gl_FragCoord.xy / u_size",
               "(gl_FragCoord.xy - 0.5) / u_size");
        add_to("RayWithoutLensShift", "passes/view.glsl", "u_ray_scale + u_ray_offset",
               "u_ray_scale");
        add_to("SlopeIgnored", slices, "clamp(z * dot", "0.0 * clamp(z * dot");
        add_to("DepthOneTexelOff", slices, "ivec2(inside ? px : p.px)",
               "min(ivec2(inside ? px : p.px) + ivec2(1, 0), ivec2(u_size) - 1)");
        add_to("SamplesLieOtherwise", slices, "1.0 + radius_px", "1.5 + radius_px");
        add_to("JitterIgnored", slices, "float(i) + jitter", "float(i) + 0.5");
        add_to("DirectionTurnedTheOtherWay", own, "turn.x * by.x - turn.y",
               "turn.x * by.x + turn.y");
    }
    add("hbao", "BiasIgnored", "technique/hbao.glsl", "s.cosine * p_bias", "0.0");
    add("hbao", "NoAttenuation", "technique/hbao.glsl", "weight * max", "max");
    add("hbao", "StrengthOnePercentOff", "technique/hbao.glsl", "p_strength *",
        "1.01 * p_strength *");
    add("gtao", "FalloffIgnored", "technique/gtao.glsl", "radius_m * p_falloff", "radius_m * 0.1");
    add("gtao", "OneSideTwice", "technique/gtao.glsl", "p, s, -1.0", "p, s, 1.0");
    add("gtao", "ArcWithoutTilt", slices.c_str(), "+ across *", "+ 0.9 * across *");
    add("bitmask", "ThicknessOnePercentOff", "technique/bitmask.glsl", "* p_thickness",
        "* 1.01 * p_thickness");
    add("bitmask", "CutOffIgnored", "technique/bitmask.glsl", "farthest_m * farthest_m", "1.0e30");
    add("bitmask", "OneSectorTooMany", "technique/bitmask.glsl", "lowest(uint(int(ends.y)))",
        "lowest(uint(ends.y) + 1u)");
    const char* const hemisphere = "technique/hemisphere.glsl";
    add("hemisphere", "RadiusTwoPercentOff", hemisphere, "point * p_radius_m",
        "point * 1.02 * p_radius_m");
    add("hemisphere", "MeanOfFewer", hemisphere, "float(SAMPLES)", "float(SAMPLES - 1)");
    add("hemisphere", "BiasIgnored", hemisphere, "> p_bias * p_radius_m", "> 0.0");
    add("hemisphere", "RangeAlwaysChecked", hemisphere, "p_range_check < 0.5 ||", "");
    add("hemisphere", "FrameTransposed", hemisphere, "frame * point", "point * frame");
    add("hemisphere", "FrameLeftHanded", "technique/tangent_frame.glsl", "cross(n, t)",
        "cross(t, n)");
    add("hemisphere", "TangentNotAtRightAngles", "technique/tangent_frame.glsl",
        "r - n * dot(r, n)", "r - 0.9 * n * dot(r, n)");
    const char* const starcraft2 = "technique/starcraft2.glsl";
    add("starcraft2", "RadiusTwoPercentOff", starcraft2, "min(p_radius_m", "min(1.02 * p_radius_m");
    add("starcraft2", "HemisphereTurnedOver", starcraft2, "dot(o, n) < 0.0", "dot(o, n) > 0.0");
    add("starcraft2", "EpsilonIgnored", starcraft2, "delta <= p_epsilon * radius_m",
        "delta <= 0.0");
    add("starcraft2", "PowerTwoPercentOff", starcraft2, "1.0), power)", "1.0), 1.02 * power)");
    add("starcraft2", "BrighterWins", starcraft2, "max(wide, small)", "min(wide, small)");
    add("starcraft2", "SmallSetWide", starcraft2, "radius_m *= p_small_radius;", "");
    add("starcraft2", "ComparedWithP", starcraft2, "occlusion(-s.z - ", "occlusion(-p.z - ");
    const char* const box = "denoise/box4.glsl";
    add("blizzard", "Box4OneTexelOff", box, "- kTileSize / 2;", "- kTileSize / 2 + 1;");
    add("blizzard", "Box4DroppedRow", box, "y < kTileSize;", "y < kTileSize - 1;");
    const char* const separable = "denoise/separable.glsl";
    add("blizzard", "SeparableToleranceOff", separable, "0.004", "0.0042");
    add("blizzard", "SeparableWeightOff", separable, "(4.0 - distance_px)", "(3.9 - distance_px)");
    add("blizzard", "SeparableDroppedTap", separable, "j == 0", "j == 0 || j == kReach");
    add("blizzard", "SeparablePacksDepth", separable, "-both.g", "-1.0 / both.g");
    add("blizzard", "SeparableSlopeOfOneSide", separable, "abs(before) < abs(after)", "true");
    add("blizzard", "SeparableIgnoresSlope", separable, "w + slope * float(j)", "w");
    const char* const bilateral = "denoise/bilateral.glsl";
    add("blizzard", "BilateralToleranceOff", bilateral, "0.004", "0.0042");
    add("blizzard", "BilateralWeightOff", bilateral, "(4.0 - abs(float(x)))",
        "(4.1 - abs(float(x)))");
    add("blizzard", "BilateralIgnoresSlope", bilateral, "w + across * float(x)", "w");
    const char* const gaussian = "denoise/gaussian_nd.glsl";
    add("blizzard", "GaussianWeightOff", gaussian, "0.882496903", "0.87");
    add("blizzard", "GaussianIgnoresNormals", gaussian, ">= kLeastCosine", ">= -2.0");
    add("blizzard", "GaussianToleranceOff", gaussian, "<= kTolerance * w",
        "<= 0.5 * kTolerance * w");
    return faults;
}

INSTANTIATE_TEST_SUITE_P(All, ShaderFaults, testing::ValuesIn(all_faults()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace obscura::renderer
