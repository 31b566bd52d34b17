// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace obscura::app::kiosk {

/// A response box on a serial line that sends a line of text for each press.
struct ResponseBoxOptions {
    std::string device;     ///< /dev/ttyUSB0; empty: there is none
    int bits_per_s = 9600;  ///< eight bits, no parity, one stop bit
    /// The key that a line stands for, by the line; a line that is not here is a key's own name, in
    /// capitals or not.
    std::map<std::string, std::string> keys = {};
};

/// `LINE=KEY` into the keys. Throws bad input naming --box-key for another text, a line that is
/// there already, and what is no key.
void add_box_key(ResponseBoxOptions& options, const std::string& text);

/// Reads a response box on a thread of its own, which stamps each line as it comes.
class ResponseBox {
  public:
    struct Press {
        std::string key;  ///< its name in a study file
        double time_s = 0.0;
    };
    /// `wake` is called on that thread when something came. Throws bad input naming the device
    /// where it cannot be opened, is no serial line, or has not that rate.
    ResponseBox(const ResponseBoxOptions& options, std::function<void()> wake);
    ~ResponseBox();
    ResponseBox(const ResponseBox&) = delete;
    ResponseBox& operator=(const ResponseBox&) = delete;

    /// What came since the last call, in order.
    [[nodiscard]] std::vector<Press> take();
    /// Whether the line ended: the box was unplugged.
    [[nodiscard]] bool lost() const;

  private:
    struct Reader;
    std::unique_ptr<Reader> reader_;
};

}  // namespace obscura::app::kiosk
