#pragma once
// A picture in fewer bytes: a study has some thirty pictures of some hundred particles each.

#include <string>

namespace report {

// The same picture as Svg writes it, rounded to a tenth of a pixel: neighbours in the file that are
// polygons, polylines or lines of one style become one path, and circles of one style one group.
// A shape may also join shapes of its style further up, if all between them has the same colour, so
// that nothing is covered that was not before.
std::string compact_svg(const std::string& document);

}  // namespace report
