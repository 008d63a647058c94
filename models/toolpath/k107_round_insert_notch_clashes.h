#pragma once
// Turning shaped profiles with round CBN inserts (K107): the feeds and depths that a slope forbids because
// the point of the edge that forms the surface would land on a notch worn by an earlier segment.
//
// Manovytsky 2011, eqs. (1)-(4); (C1)-(C4) are completions. Angles in degrees, lengths in mm, feed in mm/rev
// along the generatrix, depth normal to it. Insert radius r 2..16, feed 0 < s < 2r, depth 0 < t <= r.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k107 {

struct Engagement {
  double radius_mm = 0;
  double feed_mm_rev = 0;
  double depth_mm = 0;
};
struct NotchAngles {
  double trail_deg;
  double lead_deg;
};
/// Angles from the tip to the two notches, sin(theta_trail) = S/(2r), cos(theta_lead) = (r - t)/r.
/// K107 eqs. (1), (2) read backwards.
[[nodiscard]] NotchAngles notch_angles(const Engagement& in);

struct EntrySlope {
  double radius_mm = 0;
  double slope_deg = 0;
};
struct ForbiddenFeed {
  double feed_mm_rev;
};
/// Feed that brings the tip onto the trailing notch on a descending slope, S = 2 r sin(omega). K107 eq. (3).
[[nodiscard]] ForbiddenFeed forbidden_feed(const EntrySlope& in);

struct ExitSlope {
  double radius_mm = 0;
  double slope_deg = 0;
};
struct ForbiddenDepth {
  double depth_mm;
};
/// Depth that brings the tip onto the leading notch on an ascending slope, t = r (1 - cos(omega)). K107 eq.
/// (4), with the subscript "out" that the print lacks.
[[nodiscard]] ForbiddenDepth forbidden_depth(const ExitSlope& in);

struct EntryBand : EntrySlope {
  double half_width_mm = 0.05;  // of the notch zone, along the edge; 0 <= w < r
};
struct FeedInterval {
  double low_mm_rev;
  double high_mm_rev;
};
/// Open interval of forbidden feeds with the guard half-angle w/r, arguments clipped to 0..90 deg.
/// COMPLETION (C1).
[[nodiscard]] FeedInterval forbidden_feed_interval(const EntryBand& in);

struct ExitBand : ExitSlope {
  double half_width_mm = 0.05;
};
struct DepthInterval {
  double low_mm;
  double high_mm;
};
/// Open interval of forbidden depths. COMPLETION (C1).
[[nodiscard]] DepthInterval forbidden_depth_interval(const ExitBand& in);

struct WantedFeed {
  double feed_mm_rev = 0;
  double radius_mm = 0;
  std::vector<double> slopes_deg;  // 0 < omega <= 90; may be empty
  double half_width_mm = 0.05;
};
struct AllowedFeed {
  double feed_mm_rev;
};
/// Largest feed not above the wanted one and outside every forbidden interval; 0 when there is none.
/// COMPLETION (C1).
[[nodiscard]] AllowedFeed allowed_feed(const WantedFeed& in);

struct WantedDepth {
  double depth_mm = 0;
  double radius_mm = 0;
  std::vector<double> slopes_deg;
  double half_width_mm = 0.05;
};
struct AllowedDepth {
  double depth_mm;
};
/// Largest depth not above the wanted one and outside every forbidden interval; 0 when there is none.
/// COMPLETION (C1).
[[nodiscard]] AllowedDepth allowed_depth(const WantedDepth& in);

enum class NotchZone { lead, trail };
/// A segment whose tip lands on a notch that another segment has worn; written [0, 3, "lead"].
struct Clash {
  std::int64_t marking = 0;
  std::int64_t clashing = 0;
  NotchZone zone = NotchZone::lead;
  friend bool operator==(const Clash&, const Clash&) = default;
};
struct Profile {
  std::vector<double> slopes_deg;  // in order of machining, ascending positive; at least two
  double radius_mm = 0;
  double feed_mm_rev = 0;
  double depth_mm = 0;
  double half_width_mm = 0.05;
  bool persistent = false;  // the edge has already cut whole parts: every pair marks, both ways
};
struct ProfileClashes {
  std::vector<Clash> clashes;  // by marking segment, then clashing segment, lead before trail
  double margin_deg;           // smallest distance of a tip from a notch, less the guard; negative = clash
};
/// Pairs of straight segments whose tip and notch angles coincide within the guard. COMPLETION (C2).
[[nodiscard]] ProfileClashes profile_clashes(const Profile& in);

struct EdgeLength {
  double length_mm;
};
/// Active edge b = r (theta_lead + theta_trail). COMPLETION (C3).
[[nodiscard]] EdgeLength active_edge_length(const Engagement& in);

struct ScallopInputs {
  double radius_mm = 0;
  double feed_mm_rev = 0;
};
struct Scallop {
  double height_um;
};
/// Theoretical height of the ridges, r - sqrt(r^2 - S^2/4). COMPLETION (C4).
[[nodiscard]] Scallop scallop_height(const ScallopInputs& in);

struct ConcaveRadius {
  double radius_mm = 0;
  double least_concave_radius_mm = 0;
};
struct ConcaveFit {
  bool ok;
};
/// Whether the insert fits the profile: its smallest concave radius must exceed the insert radius.
[[nodiscard]] ConcaveFit concave_radius_ok(const ConcaveRadius& in);

struct NoInputs {};
struct InsertSize {
  double diameter_mm;
  double thickness_mm;
  double radius_mm;
};
/// Dimensions of the insert RNUN 070300 of the paper.
[[nodiscard]] InsertSize insert_rnun_070300(const NoInputs& in);

}  // namespace verstat::models::k107

template <>
struct verstat::models::EnumNames<verstat::models::k107::NotchZone> {
  static constexpr std::array names{std::pair{k107::NotchZone::lead, "lead"},
                                    std::pair{k107::NotchZone::trail, "trail"}};
};

// A clash is a short list, not an object with names: [marking segment, clashing segment, zone].
template <>
struct verstat::models::detail::Binding<verstat::models::k107::Clash> {
  using Clash = k107::Clash;
  static void read(Clash& to, const Value& v, const Field& f) {
    const Value::List* list = v.list();
    if (list == nullptr || list->size() != 3)
      wrong_type(f, v, "a list [marking segment, clashing segment, zone]");
    Binding<std::int64_t>::read(to.marking, (*list)[0], f);
    Binding<std::int64_t>::read(to.clashing, (*list)[1], f);
    Binding<k107::NotchZone>::read(to.zone, (*list)[2], f);
  }
  static Value write(const Clash& x) {
    return Value::List{x.marking, x.clashing, Binding<k107::NotchZone>::write(x.zone)};
  }
  static void check(const Clash& x, const Field& f) { Binding<k107::NotchZone>::check(x.zone, f); }
  static bool finite(const Clash&) { return true; }
  static TypeInfo type() {
    return {.kind = TypeInfo::Kind::list, .element = {{.kind = TypeInfo::Kind::text}}};  // of mixed entries
  }
};
