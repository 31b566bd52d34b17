// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "tests/app/kiosk/virtual_display.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

namespace obscura::app::kiosk {
namespace {

constexpr int kServerStart_ms = 20000;

[[noreturn]] void become(const std::vector<std::string>& command, const std::string& log) {
    const std::string file = log.empty() ? "/dev/null" : log;
    const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
}

void run(const std::vector<std::string>& command) {
    int exit_code = 0;
    ChildProcess child(command, -1, "");
    if (!child.wait(20.0, exit_code) || exit_code != 0) {
        throw std::runtime_error(fmt::format("{} gave {}", command[0], exit_code));
    }
}

/// A connection to the X server that DISPLAY names.
using Connection = std::unique_ptr<Display, decltype(&XCloseDisplay)>;
[[nodiscard]] Connection connect() {
    Connection connection(XOpenDisplay(nullptr), &XCloseDisplay);
    if (!connection) throw std::runtime_error("cannot connect to the X server");
    return connection;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, int descriptor,
                           const std::string& log) {
    id_ = ::fork();
    if (id_ < 0) throw std::runtime_error("cannot fork");
    if (id_ == 0) {
        if (descriptor >= 0) ::fcntl(descriptor, F_SETFD, 0);
        become(command, log);
    }
}

ChildProcess::~ChildProcess() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

void ChildProcess::kill(int signal) const {
    if (id_ > 0) ::kill(id_, signal);
}

bool ChildProcess::wait(double seconds, int& exit_code) {
    for (double waited_s = 0.0; waited_s <= seconds; waited_s += 0.01) {
        int status = 0;
        if (::waitpid(id_, &status, WNOHANG) == id_) {
            id_ = 0;
            exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

VirtualDisplay::VirtualDisplay(int width, int height) : width_(width), height_(height) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
    // Without -noreset the server starts anew when its last client leaves, and refuses the next one
    // that comes meanwhile.
    server_ = ChildProcess({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                            fmt::format("{}x{}x24", width, height), "-nolisten", "tcp", "-noreset"},
                           ends[1], "");
    ::close(ends[1]);
    std::string number;
    pollfd ready{ends[0], POLLIN, 0};
    while (number.find('\n') == std::string::npos) {
        std::array<char, 16> bytes{};
        const bool came = ::poll(&ready, 1, kServerStart_ms) == 1;
        const ssize_t count = came ? ::read(ends[0], bytes.data(), bytes.size()) : 0;
        if (count <= 0) throw std::runtime_error("Xvfb does not start; is xvfb installed?");
        number.append(bytes.data(), static_cast<std::size_t>(count));
    }
    ::close(ends[0]);
    number.erase(number.find('\n'));
    ::setenv("DISPLAY", (":" + number).c_str(), 1);
}

stimuli::RgbImage VirtualDisplay::screen() const {
    const Connection connection = connect();
    const Window root = DefaultRootWindow(connection.get());
    XImage* image = XGetImage(connection.get(), root, 0, 0, static_cast<unsigned>(width_),
                              static_cast<unsigned>(height_), AllPlanes, ZPixmap);
    if (image == nullptr || image->bits_per_pixel != 32) {
        throw std::runtime_error("cannot read the screen");
    }
    stimuli::RgbImage screen{width_, height_, {}};
    screen.rgb.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
    auto* to = screen.rgb.data();
    for (int y = 0; y < height_; ++y) {
        const char* row = image->data + static_cast<std::ptrdiff_t>(y) * image->bytes_per_line;
        for (int x = 0; x < width_; ++x, to += 3) {
            // Xvfb's depth of 24 comes as blue, green, red and nothing, on machines like ours.
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, row + static_cast<std::ptrdiff_t>(x) * 4, 4);
            to[0] = static_cast<std::uint8_t>(pixel >> 16);
            to[1] = static_cast<std::uint8_t>(pixel >> 8);
            to[2] = static_cast<std::uint8_t>(pixel);
        }
    }
    XDestroyImage(image);
    return screen;
}

void VirtualDisplay::tool(const std::vector<std::string>& command) const { run(command); }

void VirtualDisplay::start_window_manager(const std::string& config) {
    std::vector<std::string> command{"openbox"};
    if (!config.empty()) command.insert(command.end(), {"--config-file", config});
    manager_ = ChildProcess(command, -1, "");
    const Connection connection = connect();
    const Atom sign = XInternAtom(connection.get(), "_NET_SUPPORTING_WM_CHECK", False);
    for (int i = 0; i < 2000; ++i) {
        Atom type = 0;
        int format = 0;
        unsigned long count = 0;
        unsigned long left = 0;
        unsigned char* value = nullptr;
        XGetWindowProperty(connection.get(), DefaultRootWindow(connection.get()), sign, 0, 1, False,
                           AnyPropertyType, &type, &format, &count, &left, &value);
        if (value != nullptr) XFree(value);
        if (count == 1) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("openbox does not start; is it installed?");
}

OtherWindow::OtherWindow(int left, int top, int width, int height) {
    Display* display = connect().release();
    connection_ = display;
    XSetWindowAttributes attributes{};
    attributes.override_redirect = True;
    attributes.background_pixel = 0xFF00FF;
    window_ =
        XCreateWindow(display, DefaultRootWindow(display), left, top, static_cast<unsigned>(width),
                      static_cast<unsigned>(height), 0, CopyFromParent, InputOutput, nullptr,
                      CWOverrideRedirect | CWBackPixel, &attributes);
    XMapRaised(display, window_);
    XSync(display, False);
}

OtherWindow::~OtherWindow() { XCloseDisplay(static_cast<Display*>(connection_)); }

void OtherWindow::take_focus() const {
    auto* display = static_cast<Display*>(connection_);
    XSetInputFocus(display, window_, RevertToPointerRoot, CurrentTime);
    XSync(display, False);
}

void VirtualDisplay::key(const std::string& name) const { run({"xdotool", "key", name}); }

void VirtualDisplay::keys(const std::vector<std::string>& names) const {
    std::vector<std::string> command{"xdotool", "key", "--delay", "60"};
    command.insert(command.end(), names.begin(), names.end());
    run(command);
}

void VirtualDisplay::click(int x, int y) const {
    run({"xdotool", "mousemove", std::to_string(x), std::to_string(y), "sleep", "0.1", "mousedown",
         "1", "sleep", "0.05", "mouseup", "1"});
}

void VirtualDisplay::double_click(int x, int y) const {
    run({"xdotool", "mousemove", std::to_string(x), std::to_string(y), "sleep", "0.2", "click",
         "--repeat", "2", "--delay", "110", "1"});
}

void VirtualDisplay::hold(const std::string& key, double seconds) const {
    run({"xdotool", "keydown", key, "sleep", fmt::format("{}", seconds), "keyup", key});
}

void VirtualDisplay::ask_windows_to_close() const {
    const Connection connection = connect();
    Window root = 0;
    Window parent = 0;
    Window* windows = nullptr;
    unsigned count = 0;
    XQueryTree(connection.get(), DefaultRootWindow(connection.get()), &root, &parent, &windows,
               &count);
    for (unsigned i = 0; i < count; ++i) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = windows[i];
        event.xclient.message_type = XInternAtom(connection.get(), "WM_PROTOCOLS", False);
        event.xclient.format = 32;
        event.xclient.data.l[0] =
            static_cast<long>(XInternAtom(connection.get(), "WM_DELETE_WINDOW", False));
        XSendEvent(connection.get(), windows[i], False, NoEventMask, &event);
    }
    if (windows != nullptr) XFree(windows);
    XSync(connection.get(), False);
}

}  // namespace obscura::app::kiosk
