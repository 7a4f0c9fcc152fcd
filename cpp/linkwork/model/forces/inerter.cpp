#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// An inerter between two points. Reference: Smith (2002), IEEE Trans. Autom. Control 47, 1648-1662.
struct Inerter : InertiaOf<Length> {
  static KindInfo info() {
    return {
        .name = "inerter",
        .placement = Length::placement,
        .parameters = {{"inertance", "kg", "of the two points", Takes::number, {.example = 0.5, .bounds = positive}}},
        .documentation =
            "Inerter between a point of a and a point of b: the pull is b l_ddot [N], with the distance l of "
            "the points and the inertance b [kg]. Its kinetic energy is b l_dot^2 / 2; it weighs nothing."};
  }
};

LINKWORK_DEFINE_FORCE(inerter, Inerter)

}  // namespace linkwork
