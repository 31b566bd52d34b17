// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/gltf_check.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "renderer/base/error.h"
#include "renderer/import/files_read.h"
#include "renderer/import/gltf_component.h"
#include "renderer/import/import.h"

namespace obscura::renderer::import_detail {
namespace {

constexpr std::int64_t kMostBytes = std::int64_t{1} << 40U;  // far above what any buffer may hold

// A parsed document takes up to twenty times its text.
constexpr std::size_t kMostJsonBytes = std::size_t{64} << 20U;

// Required extensions that are shown in full, or as near as the notes say.
constexpr std::array<std::string_view, 10> kKnownExtensions = {
    "KHR_lights_punctual",
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_materials_unlit",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_emissive_strength",
    "KHR_materials_pbrSpecularGlossiness",
    "EXT_texture_webp",
    "KHR_materials_clearcoat"};

/// Extensions without which meshes are missing.
struct GeometryExtension {
    std::string_view name;
    std::string_view left_out;
};
constexpr std::array<GeometryExtension, 5> kGeometryExtensions = {
    {{"EXT_mesh_gpu_instancing", "of the copies that it makes of a mesh one is shown"},
     {"KHR_draco_mesh_compression", "meshes that have no other form are not shown"},
     {"EXT_meshopt_compression", "meshes that have no other form are not shown"},
     {"KHR_meshopt_compression", "meshes that have no other form are not shown"},
     {"KHR_gaussian_splatting", "its splats are not shown"}}};

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

int component_type_of(const JsonCursor& accessor) {
    const auto type = static_cast<int>(accessor.at("componentType").integer(0, 65535));
    if (type < 5120 || type > 5126 || type == 5124) {
        accessor.at("componentType")
            .fail(fmt::format("is {}, allowed are 5120, 5121, 5122, 5123, 5125 and 5126", type));
    }
    return type;
}

/// Throws unless `count` elements fit.
void check_span(const JsonCursor& where, const GltfView& view, std::size_t offset,
                std::size_t stride, std::size_t count, std::size_t element) {
    const std::size_t have = view.bytes.size();
    const bool fits = offset <= have && element <= have - offset &&
                      (count - 1) <= (have - offset - element) / std::max<std::size_t>(stride, 1);
    if (!fits) {
        where.fail(
            fmt::format("{} elements of {} bytes, {} apart, from byte {} on do not fit into "
                        "its bufferView of {} bytes",
                        count, element, stride, offset, have));
    }
}

/// `count` and `element` (bytes) are the accessor's.
GltfSparse read_sparse(const JsonCursor& cursor, std::size_t count, std::size_t element,
                       const std::vector<GltfView>& views) {
    GltfSparse sparse;
    sparse.count =
        static_cast<std::size_t>(cursor.at("count").integer(1, static_cast<std::int64_t>(count)));
    const JsonCursor indices = cursor.at("indices");
    sparse.indices = views[indices.at("bufferView").index(views.size(), "bufferViews")];
    sparse.indices_offset =
        static_cast<std::size_t>(indices.integer("byteOffset", 0, 0, kMostBytes));
    sparse.indices_type = component_type_of(indices);
    const std::size_t bytes = component_bytes(sparse.indices_type);
    check_span(indices, sparse.indices, sparse.indices_offset, bytes, sparse.count, bytes);
    for (std::size_t k = 0; k < sparse.count; ++k) {
        const std::uint32_t index = integer_at(
            sparse.indices.bytes.data() + sparse.indices_offset + k * bytes, sparse.indices_type);
        if (index >= count) {
            indices.fail(fmt::format("index {} is {}, allowed is 0 to {}", k, index, count - 1));
        }
    }
    const JsonCursor values = cursor.at("values");
    sparse.values = views[values.at("bufferView").index(views.size(), "bufferViews")];
    sparse.values_offset = static_cast<std::size_t>(values.integer("byteOffset", 0, 0, kMostBytes));
    check_span(values, sparse.values, sparse.values_offset, element, sparse.count, element);
    return sparse;
}

struct TypeShape {
    const char* name;
    int components;
    bool is_matrix;
};
constexpr std::array<TypeShape, 7> kTypes = {{{"SCALAR", 1, false},
                                              {"VEC2", 2, false},
                                              {"VEC3", 3, false},
                                              {"VEC4", 4, false},
                                              {"MAT2", 4, true},
                                              {"MAT3", 9, true},
                                              {"MAT4", 16, true}}};

void check_version(const JsonCursor& root) {
    const std::string version = root.at("asset").text("version", "");
    if (!version.starts_with("2.")) {
        root.at("asset").fail(fmt::format("version is \"{}\", allowed is 2.0", one_line(version)));
    }
}

void check_extensions(const JsonCursor& root, Notes& notes) {
    const auto each = [&root](const char* key, const auto& use) {
        const auto list = root.find(key);
        if (!list) return;
        for (std::size_t i = 0; i < list->count(); ++i) {
            const JsonCursor item = list->item(i);
            if (!item.json().is_string()) item.fail("allowed is an extension's name");
            const auto name = item.json().get<std::string>();
            const bool known = std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) !=
                               kKnownExtensions.end();
            if (!known) use(item, one_line(name));
        }
    };
    each("extensionsRequired", [](const JsonCursor& item, const std::string& name) {
        item.fail(
            fmt::format("{} is required to show this file and not known here; export it "
                        "without, for example without compression",
                        name));
    });
    each("extensionsUsed", [&notes](const JsonCursor&, const std::string& name) {
        const auto* const geometry =
            std::find_if(kGeometryExtensions.begin(), kGeometryExtensions.end(),
                         [&name](const GeometryExtension& one) { return one.name == name; });
        if (geometry != kGeometryExtensions.end()) {
            notes.add(fmt::format("geometry is left out: {} is not known here, {}", name,
                                  geometry->left_out));
        } else {
            notes.add("extensions that are not known here are left out", name);
        }
    });
}

}  // namespace

GltfFile::GltfFile(std::string bytes, std::string name, const Reader& read, Notes& notes)
    : bytes_(std::move(bytes)), name_(std::move(name)) {
    open_container(notes);
    if (json_text_.size() > kMostJsonBytes) {
        throw base::bad_input(
            "{}: its JSON has {} bytes, allowed are {}; buffers and images belong into files of "
            "their own or a .glb",
            name_, json_text_.size(), kMostJsonBytes);
    }
    if (json_text_.empty() || json_text_.find_first_not_of(" \t\r\n") == std::string::npos) {
        throw base::bad_input("{}: it is empty", name_);
    }
    if (json_text_[json_text_.find_first_not_of(" \t\r\n")] != '{') {
        throw base::bad_input("{}: it is neither a binary glTF nor a JSON object", name_);
    }
    try {
        json_ = nlohmann::json::parse(json_text_);
    } catch (const nlohmann::json::exception& error) {
        throw base::bad_input("{}: not JSON: {}", name_, one_line(error.what()));
    }
    check_version(root());
    check_extensions(root(), notes);
    read_buffers(read);
    read_views();
    read_accessors();
}

void GltfFile::open_container(Notes& notes) {
    constexpr std::size_t kHeader = 12;
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::uint32_t kBin = 0x004E4942;
    json_text_ = bytes_;
    if (!std::string_view(bytes_).starts_with("glTF")) return;
    if (bytes_.size() < kHeader + 8) {
        throw base::bad_input("{}: cut off: a .glb has at least 20 bytes, this has {}", name_,
                              bytes_.size());
    }
    if (word_at(bytes_, 4) != 2) {
        throw base::bad_input("{}: a .glb of version {}, allowed is 2", name_, word_at(bytes_, 4));
    }
    const std::size_t length = word_at(bytes_, 8);
    if (length > bytes_.size() || length < kHeader + 8) {
        throw base::bad_input("{}: cut off: its header says {} bytes, it has {}", name_, length,
                              bytes_.size());
    }
    if (length < bytes_.size()) notes.add("bytes after the end that the header states are ignored");
    std::size_t at = kHeader;
    for (int chunk = 0; at + 8 <= length; ++chunk) {
        const std::size_t size = word_at(bytes_, at);
        const std::uint32_t type = word_at(bytes_, at + 4);
        at += 8;
        if (size > length - at) {
            throw base::bad_input("{}: chunk {} has {} bytes, {} are left", name_, chunk, size,
                                  length - at);
        }
        const std::string_view content = std::string_view(bytes_).substr(at, size);
        if (chunk == 0 && type != kJson) {
            throw base::bad_input("{}: the first chunk of a .glb must be JSON", name_);
        }
        if (chunk == 0) json_text_ = content;
        if (chunk == 1 && type == kBin) binary_ = content;
        at += size;
    }
}

std::optional<std::string> GltfFile::bytes_of_data_uri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) {
        return std::nullopt;
    }
    std::string text(uri.substr(comma + 1));
    while (text.size() % 4 != 0) text += '=';  // some writers leave the padding out
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') {
        ++padding;
    }
    const auto in_alphabet = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
               c == '+' || c == '/';
    };
    if (!std::all_of(text.begin(), text.end() - static_cast<std::ptrdiff_t>(padding),
                     in_alphabet)) {
        return std::nullopt;
    }
    std::string bytes(text.size() / 4 * 3, '\0');
    const int decoded = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                        reinterpret_cast<const unsigned char*>(text.data()),
                                        static_cast<int>(text.size()));
    if (decoded < 0) return std::nullopt;
    bytes.erase(bytes.size() - padding);
    return bytes;
}

void GltfFile::read_buffers(const Reader& read) {
    const JsonCursor document = root();
    const std::size_t count = document.count("buffers");
    owned_.reserve(count);  // views look into the strings
    for (std::size_t i = 0; i < count; ++i) {
        const JsonCursor buffer = document.at("buffers").item(i);
        const auto length =
            static_cast<std::size_t>(buffer.at("byteLength").integer(1, kMostBytes));
        std::string_view bytes;
        const auto uri = buffer.find("uri");
        if (!uri) {
            if (i != 0 || !binary_) {
                buffer.fail("it has no uri, and there is no binary chunk for it");
            }
            bytes = *binary_;
        } else {
            const std::string text = buffer.text("uri", "");
            std::string why = "its data URI is not base64";
            auto content = text.starts_with("data:") ? bytes_of_data_uri(text)
                                                     : read(percent_decoded(text), why);
            if (!content) {
                buffer.fail(text.starts_with("data:") ? why
                                                      : fmt::format("{}: {}", one_line(text), why));
            }
            owned_.push_back(std::move(*content));
            bytes = owned_.back();
        }
        if (length > bytes.size()) {
            buffer.fail(
                fmt::format("byteLength is {}, but there are {} bytes", length, bytes.size()));
        }
        buffers_.push_back(bytes.substr(0, length));
    }
}

void GltfFile::read_views() {
    const JsonCursor document = root();
    const std::size_t count = document.count("bufferViews");
    for (std::size_t i = 0; i < count; ++i) {
        const JsonCursor view = document.at("bufferViews").item(i);
        const std::string_view buffer =
            buffers_[view.at("buffer").index(buffers_.size(), "buffers")];
        const auto offset = static_cast<std::size_t>(view.integer("byteOffset", 0, 0, kMostBytes));
        const auto length = static_cast<std::size_t>(view.at("byteLength").integer(1, kMostBytes));
        if (offset > buffer.size() || length > buffer.size() - offset) {
            view.fail(fmt::format("{} bytes from byte {} on do not fit into its buffer of {} bytes",
                                  length, offset, buffer.size()));
        }
        views_.push_back({buffer.substr(offset, length),
                          static_cast<std::size_t>(view.integer("byteStride", 0, 4, 252))});
    }
}

void GltfFile::read_accessors() {
    const JsonCursor document = root();
    const std::size_t count = document.count("accessors");
    for (std::size_t i = 0; i < count; ++i) {
        const JsonCursor cursor = document.at("accessors").item(i);
        GltfAccessor accessor;
        accessor.component_type = component_type_of(cursor);
        accessor.normalized = cursor.truth("normalized", false);
        const std::string type = cursor.text("type", "");
        const auto shape = std::find_if(kTypes.begin(), kTypes.end(),
                                        [&type](const TypeShape& s) { return s.name == type; });
        if (shape == kTypes.end()) {
            cursor.fail(
                fmt::format("type is \"{}\", allowed are SCALAR, VEC2, VEC3, VEC4, MAT2, "
                            "MAT3 and MAT4",
                            one_line(type)));
        }
        accessor.components = shape->components;
        accessor.is_matrix = shape->is_matrix;
        constexpr std::size_t kMostFloats = (std::size_t{512} << 20U) / sizeof(float);
        accessor.count = static_cast<std::size_t>(cursor.at("count").integer(
            1, static_cast<std::int64_t>(kMostFloats /
                                         static_cast<std::size_t>(accessor.components))));
        const std::size_t element = element_bytes(accessor);
        accessor.offset = static_cast<std::size_t>(cursor.integer("byteOffset", 0, 0, kMostBytes));
        if (const auto view = cursor.index("bufferView", views_.size(), "bufferViews")) {
            accessor.view = views_[*view];
            accessor.stride = accessor.view->stride != 0 ? accessor.view->stride : element;
            if (accessor.stride < element) {
                cursor.fail(
                    fmt::format("elements of {} bytes overlap: its bufferView has a "
                                "byteStride of {}",
                                element, accessor.stride));
            }
            check_span(cursor, *accessor.view, accessor.offset, accessor.stride, accessor.count,
                       element);
        }
        if (const auto sparse = cursor.find("sparse")) {
            accessor.sparse = read_sparse(*sparse, accessor.count, element, views_);
        }
        accessors_.push_back(accessor);
    }
}

}  // namespace obscura::renderer::import_detail
