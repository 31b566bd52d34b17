// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The front of speed against error on the built-in study's three views of moderate and low light:
// RMSE of the mean square of the three, signed mean, and time over that of the first setting, all
// settings in turn. Lengths are in the R of each scene.
//   front_bench [--study FILE] [--size WxH] [--rays N] [--runs N] [--steps] [--fit EVALUATIONS]
//               SETTING...
// A SETTING is one argument: `layered 16 denoise=separable preset=fitted reach=1.2 ao_scale=0.5`.
// `--runs 0` times nothing; `--steps` names each step's median. With --fit the last one's
// parameters that it does not set, and those it gives a start (`reach~1.2`), are fitted, one set
// for all scenes, on the cameras that no view of the study has. Figures of different views are no
// more comparable than their errors without any technique (`none`): tests/bench/a623740.toml has
// the views of that commit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include "analysis/fit/minimise.h"
#include "analysis/image_error/accessibility_error.h"
#include "app/commands/image_size.h"
#include "app/commands/variant_arguments.h"
#include "app/measure/fit_settings.h"
#include "app/measure/measured_scene.h"
#include "app/measure/sweep.h"
#include "renderer/gl/context.h"

namespace {

using namespace obscura;
using namespace obscura::app;

struct Asked {
    std::string text;
    renderer::Variant variant;
    std::set<std::string> set;  ///< parameters with values of their own
};

Asked parse(const std::string& text) {
    std::istringstream words(text);
    VariantArguments arguments;
    Asked asked{text, {}, {}};
    words >> arguments.technique;
    const renderer::Technique* technique = renderer::find_technique(arguments.technique);
    if (technique != nullptr) arguments.denoise = renderer::standard_denoise(*technique);
    for (std::string word; words >> word;) {
        const bool starts = word.find('~') != std::string::npos;
        if (starts) word[word.find('~')] = '=';
        const std::size_t equals = word.find('=');
        const std::string key = word.substr(0, equals);
        if (equals == std::string::npos) {
            arguments.samples = std::atoi(word.c_str());
        } else if (key == "denoise") {
            arguments.denoise = word.substr(equals + 1);
        } else if (key == "preset") {
            arguments.preset = word.substr(equals + 1);
        } else {
            arguments.settings.push_back(word);
            if (!starts) asked.set.insert(key);
        }
    }
    asked.variant = variant_from(arguments);
    return asked;
}

struct Errors {
    double square = 0.0;
    double bias = 0.0;
    double p99 = 0.0;
};

Errors errors_on(MeasuredScene& stage, const MeasuredView& view, const renderer::Variant& variant,
                 int width, int height, int rays) {
    const renderer::ReferenceImage& truth = stage.truth(view, view.radius_m, width, height, rays);
    const renderer::Frame frame = stage.render_plainly(view, variant, width, height);
    const auto error = analysis::accessibility_error(
        frame.read_accessibility(), truth.accessibility, surface_mask(frame, truth));
    return {error->rmse * error->rmse, error->bias, error->p99};
}

/// On a GPU by timestamps, but for what the processor has a part in.
double ms_of(const renderer::PassTime& pass) {
    static const bool by_clock = renderer::is_software_renderer();
    return by_clock ? pass.milliseconds : pass.query_milliseconds;
}

double ms_of(const std::vector<renderer::PassTime>& passes) {
    double sum = 0.0;
    for (const renderer::PassTime& pass : passes) {
        if (is_of_the_variant(pass.phase)) sum += ms_of(pass);
    }
    return sum;
}

double layer_ms_of(const renderer::Frame& frame) {
    double sum = 0.0;
    for (const renderer::PassTime& pass : frame.times) {
        if (pass.phase == renderer::Phase::kSecondLayer) sum += ms_of(pass);
    }
    return sum;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

struct Wanted {
    ImageSize size{640, 360};
    int rays = 512;
    int runs = 9;
    int evaluations = 0;
    bool steps = false;
    std::string study;
    std::vector<Asked> asked;
};

Wanted options_of(int count, char** arguments) {
    Wanted options;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] { return std::string(arguments[++i]); };
        if (word == "--steps") {
            options.steps = true;
        } else if (word == "--study") {
            options.study = value();
        } else if (word == "--size") {
            options.size = parse_size(value());
        } else if (word == "--rays") {
            options.rays = std::stoi(value());
        } else if (word == "--runs") {
            options.runs = std::stoi(value());
        } else if (word == "--fit") {
            options.evaluations = std::stoi(value());
        } else {
            options.asked.push_back(parse(word));
        }
    }
    return options;
}

void fit(const Wanted& options, const MeasureRequest& request, const stimuli::Study& study,
         const std::vector<MeasuredView>& views) {
    Asked last = options.asked.back();
    std::vector<std::unique_ptr<MeasuredScene>> stages;
    std::vector<std::vector<MeasuredView>> training;
    for (const MeasuredView& view : views) {
        stages.push_back(std::make_unique<MeasuredScene>(request));
        std::vector<MeasuredView>& of_scene = training.emplace_back();
        for (const std::string& camera : view.scene->cameras) {
            if (camera == view.camera) continue;
            of_scene.push_back(view);
            of_scene.back().camera = camera;
        }
    }
    std::vector<analysis::Unknown> unknowns = unknowns_of(last.variant);
    std::erase_if(unknowns, [&](const auto& unknown) { return last.set.contains(unknown.name); });
    const auto error_of = [&](std::span<const double> values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            last.variant.parameters[unknowns[i].name] = values[i];
        }
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < training.size(); ++i) {
            for (const MeasuredView& view : training[i]) {
                sum +=
                    errors_on(*stages[i], view, on_view(last.variant, view, study), 320, 180, 128)
                        .square;
                count += 1.0;
            }
        }
        return std::sqrt(sum / count);
    };
    const analysis::Minimum found = analysis::minimise(
        unknowns, error_of, {.starts = 1, .evaluations = options.evaluations, .tolerance = 2e-3});
    fmt::print("{}\n  trained {:.4f} -> {:.4f} in {}:", last.text, found.at_start, found.smallest,
               found.evaluations);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        fmt::print(" {}={:.4g}", unknowns[i].name, found.values[i]);
        last.variant.parameters[unknowns[i].name] = found.values[i];
    }
    double sum = 0.0;
    fmt::print("\n  reported");
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Errors errors =
            errors_on(*stages[i], views[i], on_view(last.variant, views[i], study),
                      options.size.width, options.size.height, options.rays);
        sum += errors.square / static_cast<double>(views.size());
        fmt::print(" {:.4f} ({:+.3f})", std::sqrt(errors.square), errors.bias);
    }
    fmt::print(" all {:.4f}\n", std::sqrt(sum));
}

void measure_front(const Wanted& options, const MeasureRequest& request,
                   const stimuli::Study& study, const std::vector<MeasuredView>& views) {
    MeasuredScene stage(request);
    std::vector<Errors> sums(options.asked.size());
    std::vector<std::string> each(options.asked.size());
    std::vector<double> ms(options.asked.size(), 0.0);
    std::vector<double> layer_ms(options.asked.size(), 0.0);
    std::vector<std::map<std::string, std::vector<double>>> by_step(options.asked.size());
    const auto [width, height] = options.size;
    const double share = 1.0 / static_cast<double>(views.size());
    for (const MeasuredView& view : views) {
        std::vector<renderer::Frame> frames;
        std::vector<std::vector<double>> times(options.asked.size());
        for (std::size_t i = 0; i < options.asked.size(); ++i) {
            const renderer::Variant variant = on_view(options.asked[i].variant, view, study);
            const Errors errors = errors_on(stage, view, variant, width, height, options.rays);
            sums[i].square += errors.square * share;
            sums[i].bias += errors.bias * share;
            sums[i].p99 += errors.p99 * share;
            each[i] += fmt::format(" {:.4f}", std::sqrt(errors.square));
            if (options.runs == 0) continue;
            frames.push_back(stage.render(view, variant, width, height));
            layer_ms[i] += layer_ms_of(frames.back()) * share;
        }
        if (options.runs == 0) continue;
        for (int run = 0; run < options.runs + 2; ++run) {
            for (std::size_t i = 0; i < options.asked.size(); ++i) {
                const renderer::Variant variant = on_view(options.asked[i].variant, view, study);
                // Once untimed: what ran before it leaves other caches and another clock.
                (void)stage.render_again(view, frames[i], variant);
                const auto passes = stage.render_again(view, frames[i], variant);
                if (run < 2) continue;
                times[i].push_back(ms_of(passes));
                std::size_t step = 0;
                for (const renderer::PassTime& pass : passes) {
                    if (!is_of_the_variant(pass.phase)) continue;
                    by_step[i][fmt::format("{} {}", ++step, pass.name)].push_back(ms_of(pass));
                }
            }
        }
        for (std::size_t i = 0; i < times.size(); ++i) ms[i] += median(times[i]) * share;
    }
    fmt::print("{}, steps as {}\n", renderer::gpu_description(),
               in_words(renderer::steps_by_device()));
    fmt::print("{:>7} {:>7} {:>7} {:>8} {:>6} {:>8}  each\n", "RMSE", "bias", "p99", "ms", "ratio",
               "layer ms");
    for (std::size_t i = 0; i < options.asked.size(); ++i) {
        fmt::print("{:7.4f} {:+7.3f} {:7.3f} {:8.2f} {:6.3f} {:8.2f} {}  {}\n",
                   std::sqrt(sums[i].square), sums[i].bias, sums[i].p99, ms[i],
                   ms[0] > 0.0 ? ms[i] / ms[0] : 0.0, layer_ms[i], each[i], options.asked[i].text);
        if (!options.steps) continue;
        for (const auto& [name, times] : by_step[i]) {
            fmt::print("{:24}{:8.2f}  {}\n", "", median(times), name);
        }
    }
}

}  // namespace

int main(int count, char** arguments) {
    const Wanted options = options_of(count, arguments);
    if (options.asked.empty()) return 2;
    MeasureRequest request;
    request.quiet = true;
    request.study = options.study;
    request.cache = "obscura-data/cache/reference";
    const stimuli::Study study = stimuli::load_study(options.study);
    const std::vector<MeasuredView> views =
        one_a_scene(views_of(request, study, stimuli::builtin_scenes()));
    const renderer::HeadlessContext context;
    if (options.evaluations > 0) {
        fit(options, request, study, views);
    } else {
        measure_front(options, request, study, views);
    }
    return 0;
}
