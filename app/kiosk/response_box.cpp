// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/response_box.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "app/kiosk/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "stimuli/presentation_reader.h"

namespace obscura::app::kiosk {

/// A file descriptor that is closed with this.
struct LineHandle {
    explicit LineHandle(int opened) : value(opened) {}
    ~LineHandle() {
        if (value >= 0) ::close(value);
    }
    LineHandle(const LineHandle&) = delete;
    LineHandle& operator=(const LineHandle&) = delete;
    int value;
};

namespace {

constexpr std::size_t kLongestLine = 100;

constexpr std::array<std::pair<int, speed_t>, 8> kRates{{{1200, B1200},
                                                         {2400, B2400},
                                                         {4800, B4800},
                                                         {9600, B9600},
                                                         {19200, B19200},
                                                         {38400, B38400},
                                                         {57600, B57600},
                                                         {115200, B115200}}};

[[nodiscard]] std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

[[nodiscard]] speed_t rate_of(const ResponseBoxOptions& options) {
    std::string known;
    for (const auto& [rate, speed] : kRates) {
        if (rate == options.bits_per_s) return speed;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", rate);
    }
    throw base::bad_input("--box-rate {}: allowed are {} bits a second", options.bits_per_s, known);
}

[[nodiscard]] int open_line(const ResponseBoxOptions& options) {
    const speed_t speed = rate_of(options);
    const int line = ::open(options.device.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (line < 0) {
        throw base::bad_input(
            "--response-box {}: {}; allowed is a serial line such as "
            "/dev/ttyUSB0 that this user may read (group dialout)",
            options.device, std::strerror(errno));
    }
    termios settings{};
    if (::tcgetattr(line, &settings) != 0) {
        ::close(line);
        throw base::bad_input(
            "--response-box {}: it is no serial line, allowed is one such as "
            "/dev/ttyUSB0",
            options.device);
    }
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | PARENB);
    ::cfsetispeed(&settings, speed);
    ::cfsetospeed(&settings, speed);
    ::tcsetattr(line, TCSANOW, &settings);
    // What was pressed before anybody looked at anything.
    ::tcflush(line, TCIFLUSH);
    return line;
}

}  // namespace

void add_box_key(ResponseBoxOptions& options, const std::string& text) {
    const auto at = text.rfind('=');
    const std::string key = at == std::string::npos ? "" : text.substr(at + 1);
    if (at == std::string::npos || at == 0 || !stimuli::is_key_name(key)) {
        throw base::bad_input(
            "--box-key {}: allowed is LINE=KEY with a key as a study file names it: space, enter, "
            "left, right, up, down, page-up, page-down, a letter a to z or a digit",
            text);
    }
    if (!options.keys.emplace(text.substr(0, at), key).second) {
        throw base::bad_input("--box-key {}: that line has a key already, {}", text,
                              options.keys.at(text.substr(0, at)));
    }
}

struct ResponseBox::Reader {
    Reader(const ResponseBoxOptions& chosen, std::function<void()> waking)
        : options(chosen),
          wake(std::move(waking)),
          line(open_line(chosen)),
          stop(::eventfd(0, EFD_CLOEXEC)),
          thread([this] { read(); }) {}
    ~Reader() {
        const std::uint64_t one = 1;
        (void)!::write(stop.value, &one, sizeof one);
        thread.join();
    }

    void read() {
        std::string text;
        while (!lost) {
            std::array<pollfd, 2> waited{{{line.value, POLLIN, 0}, {stop.value, POLLIN, 0}}};
            if (::poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) break;
            if (waited[1].revents != 0) return;
            if (waited[0].revents == 0) continue;
            std::array<char, 256> bytes{};
            const ssize_t count = ::read(line.value, bytes.data(), bytes.size());
            const double now_s = monotonic_s();
            if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
            if (count <= 0) lost = true;
            for (ssize_t i = 0; i < count; ++i)
                take_byte(bytes[static_cast<std::size_t>(i)], text, now_s);
            wake();
        }
        base::log::error("the response box {} is gone: keyboard and mouse go on", options.device);
    }

    /// A line ends with a carriage return, a line feed, or both.
    void take_byte(char byte, std::string& text, double now_s) {
        if (byte != '\n' && byte != '\r') {
            if (text.size() < kLongestLine) text += byte;
            return;
        }
        if (text.empty()) return;
        const auto chosen = options.keys.find(text);
        const std::string key = chosen != options.keys.end() ? chosen->second : lower(text);
        if (stimuli::is_key_name(key)) {
            const std::lock_guard lock(mutex);
            presses.push_back({key, now_s});
        } else if (unknown.insert(text).second) {
            base::log::warn(
                "the response box sends \"{}\", which is no key: --box-key \"{}=KEY\" "
                "makes it one",
                text, text);
        }
        text.clear();
    }

    const ResponseBoxOptions options;
    const std::function<void()> wake;
    LineHandle line;
    LineHandle stop;
    std::mutex mutex;
    std::vector<Press> presses;
    std::set<std::string> unknown;  ///< lines that were said to be none; of the thread alone
    std::atomic<bool> lost{false};
    std::thread thread;  ///< last: it uses all of the others
};

ResponseBox::ResponseBox(const ResponseBoxOptions& options, std::function<void()> wake)
    : reader_(std::make_unique<Reader>(options, std::move(wake))) {}

ResponseBox::~ResponseBox() = default;

std::vector<ResponseBox::Press> ResponseBox::take() {
    const std::lock_guard lock(reader_->mutex);
    return std::exchange(reader_->presses, {});
}

bool ResponseBox::lost() const { return reader_->lost; }

}  // namespace obscura::app::kiosk
