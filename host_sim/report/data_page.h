// SPDX-License-Identifier: MIT
// The page of `fixrad sweep`, and what is put into it.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/report/baked_mesh.h"
#include "host_sim/report/picture.h"

namespace fixrad::host {

/// The page with everything but its data: HTML with style and script inside, made from web/ when the tool is
/// built; empty if it was built without Node.js.
std::string_view page_template();

/// page_template() with `json` in its place; the page reads it as it starts. Throws InputError where there is
/// no template.
std::string page_with(const std::string& json, const std::string& title);

/// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// `data:image/png;base64,...` of the picture.
std::string png_data_url(const Image& image);

/// The file that write_glb() writes, as base64.
std::string glb_base64(const BakedMesh& mesh, const Display& display);

}  // namespace fixrad::host
