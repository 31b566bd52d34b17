// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/import/json_cursor.h"
#include "renderer/import/notes.h"

namespace obscura::renderer::import_detail {

/// Bytes of a buffer, after glTF 2.0, 3.6.2.2.
struct GltfView {
    std::string_view bytes;
    std::size_t stride = 0;  ///< 0: elements lie close together
};

/// Elements that differ from what their accessor's view holds (glTF 2.0, 3.6.2.3).
struct GltfSparse {
    std::size_t count = 0;
    GltfView indices;  ///< each is below the accessor's count
    std::size_t indices_offset = 0;
    int indices_type = 5125;
    GltfView values;
    std::size_t values_offset = 0;
};

/// Elements of one type, after glTF 2.0, 3.6.2: every one lies within its view.
struct GltfAccessor {
    std::optional<GltfView> view;  ///< none: all elements are zero, but for the sparse ones
    std::size_t offset = 0;
    std::size_t stride = 0;
    std::size_t count = 0;
    int component_type = 5126;  ///< 5120 to 5126, as in OpenGL
    int components = 1;         ///< 1 to 4, 9 or 16
    bool normalized = false;
    bool is_matrix = false;
    std::optional<GltfSparse> sparse;
};

/// A glTF document whose container, buffers, views and accessors were checked: what they span is
/// there. The rest of the JSON is checked where it is read. Does not move: views look into it.
class GltfFile {
  public:
    /// The bytes of a file that the document names, or nothing and why.
    using Reader =
        std::function<std::optional<std::string>(const std::string& name, std::string& why)>;

    /// Takes the bytes of a .gltf or .glb file, told apart by the first four. `name` stands for it
    /// in messages. Throws bad input naming place, value and what is allowed, where
    /// - the container is cut off or its lengths contradict each other,
    /// - the text is no JSON, or no glTF of version 2,
    /// - an extension is required that this importer does not know,
    /// - a buffer is missing or short, a view or an accessor reaches beyond what it lies in.
    GltfFile(std::string bytes, std::string name, const Reader& read, Notes& notes);
    GltfFile(const GltfFile&) = delete;
    GltfFile& operator=(const GltfFile&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] JsonCursor root() const { return {json_, "", name_}; }
    [[nodiscard]] const std::vector<GltfView>& views() const { return views_; }
    [[nodiscard]] const std::vector<GltfAccessor>& accessors() const { return accessors_; }

    /// All components as floats, normalised integers mapped to [0, 1] or [-1, 1] (3.6.2.2).
    [[nodiscard]] std::vector<float> floats(const GltfAccessor& accessor) const;
    /// All components as integers; throws bad input naming `place` for floats and signed ones.
    [[nodiscard]] std::vector<std::uint32_t> integers(const GltfAccessor& accessor,
                                                      const std::string& place) const;

    /// The bytes of a data URI (RFC 2397), or nothing where they are not base64.
    [[nodiscard]] static std::optional<std::string> bytes_of_data_uri(std::string_view uri);

  private:
    void open_container(Notes& notes);
    void read_buffers(const Reader& read);
    void read_views();
    void read_accessors();

    std::string bytes_;
    std::string name_;
    nlohmann::json json_;
    std::string_view json_text_;
    std::optional<std::string_view> binary_;  ///< the second chunk of a .glb
    std::vector<std::string> owned_;          ///< of buffers outside the container
    std::vector<std::string_view> buffers_;
    std::vector<GltfView> views_;
    std::vector<GltfAccessor> accessors_;
};

}  // namespace obscura::renderer::import_detail
