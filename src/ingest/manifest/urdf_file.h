#pragma once
// An arm's masses from its description in URDF (http://wiki.ros.org/urdf/XML): what gravity does to
// each of its joints follows from them.
//
// Of it are read: <link> with <inertial><mass value/><origin xyz rpy/></inertial>; <joint> with its
// name, type (revolute, continuous, prismatic, fixed), <parent>, <child>, <origin xyz rpy>, <axis
// xyz> (1 0 0 where there is none) and <mimic>. A link without <inertial> has no mass. Links that
// are fixed to each other are one; those that are fixed to the base carry nothing. All else
// (shapes, limits, transmissions, plugins) is passed over.

#include <cstdint>
#include <string>
#include <string_view>

#include "robot/weighted_arm.h"

namespace tribolog::ingest::manifest {

inline constexpr std::uint64_t largest_urdf_bytes = std::uint64_t{1} << 24;

/// By the end of its name, ".urdf".
bool is_urdf(const std::string& file);

/// The joints that move, each behind the one that carries it, in the file's order where it leaves
/// a choice.
/// @param file its name, for messages.
/// @throw InputError at file:line:column: no XML, a document type or entities, xacro that was not
///        expanded, no <robot>, two links or joints of one name, a link that no link is or that two
///        joints carry, a ring of links, several bases, a joint that floats, an axis without
///        direction, numbers that are none or are those of another unit, and an arm without a mass
///        or a joint.
robot::WeightedArm parse_urdf(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::manifest
