// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace obscura::app::kiosk {

/// Of repeated measurements.
struct Figures {
    int count = 0;
    double mean = 0.0;
    double sd = 0.0;     ///< of the sample; 0 for fewer than two
    double worst = 0.0;  ///< the one farthest from 0, with its sign
    bool operator==(const Figures&) const = default;
};
[[nodiscard]] Figures figures_of(const std::vector<double>& values);

/// What `obscura run --selftest` measured: an interval between two images again and again, and how
/// long a key takes to change the screen.
struct SelfTest {
    std::string time_utc;
    std::string display;  ///< monitor, resolution, refresh rate
    std::string gpu_renderer;
    std::string source;        ///< of the times, as SwapClock names it
    double told_hz = 0.0;      ///< refresh rate that the monitor tells; 0: none
    double frame_ms = 0.0;     ///< between two frames handed over one after the other, median
    bool waits = false;        ///< swapping waits for the refresh
    double interval_ms = 0.0;  ///< asked for
    Figures error_ms;          ///< measured minus asked for
    int dropped_frames = 0;
    Figures key_to_swap_ms;

    /// Whether intervals can be relied on: swapping waits for the refresh, and no frame was late.
    [[nodiscard]] bool holds() const { return waits && dropped_frames == 0; }
    bool operator==(const SelfTest&) const = default;
};

/// A JSON object with the members' names.
[[nodiscard]] std::string to_json(const SelfTest& test);
/// Throws bad input that names `where` for another text.
[[nodiscard]] SelfTest self_test_from(const std::string& json, const std::string& where);

/// For the operator, a few lines.
[[nodiscard]] std::string to_text(const SelfTest& test);

/// The last one made in that data folder; nothing: none was.
[[nodiscard]] std::optional<SelfTest> last_self_test(const std::filesystem::path& data);
/// Where it is kept.
[[nodiscard]] std::filesystem::path self_test_file(const std::filesystem::path& data);

/// How times came about in a session, as SessionRecord::timing: an object of JSON with source,
/// frame_ms, waits, self_test, the last one on this monitor and GPU or null, and where something is
/// known of the screen that, as screen_json() has it.
[[nodiscard]] std::string session_timing(const std::string& source, double frame_ms, bool waits,
                                         const std::optional<SelfTest>& last,
                                         const std::string& screen = {});

}  // namespace obscura::app::kiosk
