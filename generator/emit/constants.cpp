#include "generator/emit/constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/printable.hpp"
#include "generator/emit/number.hpp"
#include "generator/geometry/allocation.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/geometry/rolling.hpp"
#include "generator/model/device_frames.hpp"

namespace finemote::gen {
namespace {

/// Numbers that stand together: a vector in braces of its own, or some of a row.
Data cell(std::initializer_list<double> values, bool is_vector = false) {
  std::string numbers;
  for (const double value : values) numbers += (numbers.empty() ? "" : ", ") + float_literal(value);
  Data data;
  data.set("numbers", numbers);
  data.set("is_vector", is_vector);
  return data;
}
Data vector(const Eigen::Vector3d& v) { return cell({v.x(), v.y(), v.z()}, true); }

Data row(DataList cells) { return Data("cells", enumerated(std::move(cells))); }

/// What every constant says: its kind is a section of the template, without `is_`.
Data constant_of_kind(const std::string& kind, const std::string& name, const std::string& owner,
                      const DataList& rows) {
  Data data, list(Data::type::list);
  for (const Data& entry : rows) list.push_back(entry);
  set_choice(data, {"is_allocation", "is_rolling", "is_chain", "is_axes", "is_mount", "is_range", "is_role_range"},
             "is_" + kind);
  data.set("name", name);
  data.set("owner", printable(owner));
  data.set("count", std::to_string(rows.size()));
  data.set("rows", list);
  return data;
}

/// What every kind is written from.
struct Request {
  const Mechanism& mechanism;
  const std::string& owner;  ///< as in the URDF
  const std::string& role;
  const std::string& name;  ///< of the constant
  const std::vector<std::string>& joints;
  const std::string link;  ///< whose frame it is in
  [[nodiscard]] Data constant(const std::string& kind, const DataList& rows) const {
    Data data = constant_of_kind(kind, name, owner, rows);
    data.set("role", printable(role));
    data.set("link", printable(link));
    return data;
  }
  [[nodiscard]] std::vector<Axis> axes() const {
    std::vector<Axis> axes;
    for (const std::string& joint : joints) axes.push_back(joint_axis(mechanism, joint, link).value());
    return axes;
  }
};

Data allocation_fields(const Request& request) {
  const Eigen::MatrixXd m = allocation(request.axes());
  DataList rows;
  for (Eigen::Index n = 0; n < m.rows(); ++n)
    rows.push_back(row({cell({m(n, 0), m(n, 1), m(n, 2), m(n, 3), m(n, 4), m(n, 5)})}));
  return request.constant("allocation", rows);
}

Data rolling_fields(const Request& request) {
  const Rolling all = rolling(request.axes());
  DataList rows;
  for (Eigen::Index n = 0; n < all.rows.rows(); ++n)
    rows.push_back(row({cell({all.rows(n, 0), all.rows(n, 1), all.rows(n, 2)}),
                        cell({all.columns(0, n), all.columns(1, n), all.columns(2, n)})}));
  return request.constant("rolling", rows);
}

Data chain_fields(const Request& request) {
  DataList rows;
  for (const ChainLink& link : chain(request.mechanism, request.joints, request.link))
    rows.push_back(row({vector(link.offset), vector(link.axis), vector(link.centre), cell({link.mass})}));
  return request.constant("chain", rows);
}

Data axes_fields(const Request& request) {
  DataList rows;
  for (const Axis& axis : request.axes())
    rows.push_back(row({cell({axis.direction.x(), axis.direction.y(), axis.direction.z()})}));
  return request.constant("axes", rows);
}

/// None where the device has no link, or one that is not turned.
std::optional<Data> mount_fields(const Robot& robot, const Mechanism& mechanism, DeviceId index,
                                 const std::string& name) {
  const Device& device = robot.devices[index];
  const std::string link = mount_link(robot, index);
  const auto pose = device.link.empty() ? std::nullopt : mechanism.pose(device.link, link);
  if (!pose || pose->linear().isIdentity(1e-9)) return {};
  DataList rows;
  for (int i = 0; i < 3; ++i) rows.push_back(vector(pose->linear().row(i).transpose()));
  Data data = constant_of_kind("mount", name, device.name.text, {row(rows)});
  data.set("link", printable(link));
  return data;
}

/// None where the device has no joint, or one without limits.
std::optional<Data> range_fields(const Mechanism& mechanism, const Device& device, const GeometrySpec& spec,
                                 const std::string& name) {
  const Joint* joint = mechanism.joint(device.joint);
  const auto limits = joint == nullptr ? std::nullopt : limits_of(*joint);
  if (!limits) return {};
  const Range range = within_travel(*limits, geometry_param(device.params, spec));
  Data data = constant_of_kind("range", name, device.name.text, {row({cell({range.lower, range.upper})})});
  data.set("joint", printable(device.joint));
  return data;
}

/// None where none of the joints has limits.
std::optional<Data> role_range_fields(const Request& request, const Device& device, const GeometrySpec& spec) {
  DataList rows;
  for (const Range& range : role_ranges(request.mechanism, device.link, device.params, spec, request.joints))
    rows.push_back(row({cell({range.lower, range.upper})}));
  if (rows.empty()) return {};
  Data data = request.constant("role_range", rows);
  data.set("has_along", !spec.along.empty());
  data.set("along", spec.along);
  return data;
}

std::optional<Data> fields_of(const Plan& plan, DeviceId owner, const GeometrySpec& spec, const std::string& name) {
  const Mechanism mechanism(plan.robot.links, plan.robot.joints);
  const Device& device = plan.robot.devices[owner];
  if (spec.kind == "mount") return mount_fields(plan.robot, mechanism, owner, name);
  if (spec.kind == "range" && spec.role.empty()) return range_fields(mechanism, device, spec, name);
  const std::vector<std::string> joints = role_joints(plan.robot, device, spec);
  if (joints.empty()) return {};
  const std::string link = geometry_link(mechanism, device.link, spec, joints);
  const Request request{mechanism, device.name.text, spec.role, name, joints, link};
  if (spec.kind == "rolling") return rolling_fields(request);
  if (spec.kind == "chain") return chain_fields(request);
  if (spec.kind == "axes") return axes_fields(request);
  if (spec.kind == "range") return role_range_fields(request, device, spec);
  return allocation_fields(request);  // the descriptor's schema allows no other
}

/// `rov_allocation`; with its role where the type asks for the kind more than once: `head_yaw_axes`.
std::string name_of(const Device& device, const GeometrySpec& spec) {
  const auto& all = device.type->geometry;
  const auto same = std::count_if(all.begin(), all.end(), [&](const GeometrySpec& s) { return s.kind == spec.kind; });
  return device.name.cpp + "_" + (same > 1 ? spec.role + "_" : "") + spec.kind;
}

}  // namespace

std::vector<Constant> make_constants(const Plan& plan, Diagnostics& diagnostics) {
  std::vector<Constant> constants;
  for (const DeviceId owner : plan.forest.order) {
    const Device& device = plan.robot.devices[owner];
    for (const GeometrySpec& spec : device.type->geometry) {
      const std::string name = name_of(device, spec);
      const char* header = spec.kind == "allocation" ? "" : "<finemote/geometry.hpp>";
      try {
        constants.push_back({owner, name, fields_of(plan, owner, spec, name), false, header});
      } catch (const NoFloat& problem) {
        diagnostics
            .error(code::geometry_number, device.at,
                   fmt::format("the constant '{}' of device '{}' holds {}", name, device.name.text, problem.what()))
            .underline(7)
            .note(
                "it is computed from the links and joints of the robot: one of their numbers is far from any real one");
      }
    }
  }
  return constants;
}

}  // namespace finemote::gen
