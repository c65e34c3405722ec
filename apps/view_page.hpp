/// \file
/// \brief A recorded run as a page for a browser.
#pragma once

#include "tumble/base/types.hpp"

#include <string>
#include <string_view>

namespace tumble::app {

/// The text of apps/view.html, which the build has put into the program.
extern const std::string_view kViewPage;

/// Makes a page that plays an animated scene and needs nothing else, no network and no other file.
/// \param title        of the run, as a reader sees it
/// \param direction_w  [-] from the boxes to the camera at the start
std::string view_page(std::string_view title, const std::string& gltf, const Vec3& direction_w);

}  // namespace tumble::app
