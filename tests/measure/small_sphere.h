#pragma once

#include <functional>
#include <string>
#include <vector>

#include <lobelia/host/image.h>
#include <lobelia/sphere.h>

namespace lobelia::test {

/// A few pixels of a sphere by which its methods are judged, seen from a side of the panorama's own
/// whatever others are measured beside it.
SphereView small_sphere(const std::string& panorama, const Material& material);

/// R G B of the pixels that the sphere covers.
std::vector<double> sphere_colours(const host::Image& picture);

/// The small sphere's colours by SphereMethod::reference: what `make` gives, or gave in an earlier
/// run that kept them in `folder`; an empty one keeps nothing. They are the same for every quality,
/// and for every exponent where the specular lobe is black.
std::vector<double> kept_reference(const std::string& folder, const std::string& panorama,
                                   const Material& material,
                                   const std::function<std::vector<double>()>& make);

} // namespace lobelia::test
