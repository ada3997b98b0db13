// Geometry from links and joints: poses, masses, wheels, chains, against numbers worked out by hand.
#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "generator/geometry/allocation.hpp"
#include "generator/geometry/angle.hpp"
#include "generator/geometry/cause.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/fit.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/mass.hpp"
#include "generator/geometry/range.hpp"
#include "generator/geometry/rolling.hpp"
#include "generator/model/device_frames.hpp"

using namespace finemote::gen;

namespace {

Joint joint(const std::string& name, const std::string& parent, const std::string& child, std::array<double, 3> xyz,
            std::array<double, 3> axis, std::array<double, 3> rpy = {}) {
  Joint j;
  j.name = name;
  j.type = "revolute";
  j.parent_link = parent;
  j.child_link = child;
  j.origin = {xyz, rpy};
  j.axis = axis;
  return j;
}

constexpr double kDegree = M_PI / 180;

Link link(const std::string& name, double mass = 0, std::array<double, 3> centre = {}) {
  Link l;
  l.name = name;
  if (mass > 0) l.inertial = Inertial{{centre, {}}, mass, {0.1, 0, 0, 0.2, 0, 0.3}};
  return l;
}

void check(const Eigen::Vector3d& is, const Eigen::Vector3d& wanted) {
  INFO(is.transpose() << " for " << wanted.transpose());
  CHECK((is - wanted).norm() < 1e-12);
}

}  // namespace

TEST_CASE("a pose follows the joints from the root, and ends where they do not") {
  const std::vector<Link> links{link("base"), link("a"), link("b")};
  std::vector<Joint> joints{joint("to_b", "a", "b", {1, 0, 0}, {0, 0, 1}),
                            joint("to_a", "base", "a", {0, 0, 2}, {1, 0, 0}, {0, 0, M_PI / 2})};
  const Mechanism mechanism(links, joints);
  CHECK(mechanism.root() == "base");
  CHECK(mechanism.way_to("b")->size() == 2);
  check(mechanism.pose("b", "base")->translation(), {0, 1, 2});
  check(mechanism.pose("base", "b")->translation(), {-1, 0, -2});
  check(joint_axis(mechanism, "to_a", "base")->direction, {0, 1, 0});
  CHECK_FALSE(joint_axis(mechanism, "to_c", "base"));
  joints[1].parent_link = "b";  // a ring
  CHECK_FALSE(mechanism.pose("a", "base"));
  CHECK_FALSE(joint_axis(mechanism, "to_b", "base"));
  CHECK(mechanism.root() == "base");
}

TEST_CASE("masses add up in the link's frame, without what is left out") {
  const std::vector<Link> links{link("base"), link("a", 2, {0, 0, 0.5}), link("b", 1, {0.2, 0, 0})};
  const std::vector<Joint> joints{joint("to_a", "base", "a", {5, 5, 5}, {0, 1, 0}),
                                  joint("to_b", "a", "b", {0, 0, 1}, {0, 1, 0}, {0, 0, M_PI / 2})};
  const Mechanism mechanism(links, joints);
  const Mass all = mass_behind(mechanism, "a");
  CHECK(all.mass == Approx(3));
  check(all.centre(), {0, 0.2 / 3, 2.0 / 3});
  // About x: 0.1 + 2 * 0.25 of a; b's own y axis lies along x, 0.2, and 1 kg at (0, 0.2, 1).
  CHECK(all.inertia(0, 0) == Approx(0.1 + 0.5 + 0.2 + 1.04));
  const Mass alone = mass_behind(mechanism, "a", {"to_b"});
  CHECK(alone.mass == Approx(2));
  check(alone.centre(), {0, 0, 0.5});
  CHECK(mass_behind(mechanism, "base").mass == Approx(3));
  check(mass_behind(mechanism, "nowhere").centre(), {0, 0, 0});
}

TEST_CASE("wheels roll as their places, axes and rollers say") {
  const std::vector<Axis> wheels{{{0.2, 0.3, -0.1}, {0, 1, 0}},
                                 {{0.2, -0.3, -0.1}, {0, -1, 0}},  // its axis points to the right
                                 {{-0.2, 0.3, -0.1}, {0, 1, 0}},
                                 {{-0.2, -0.3, -0.1}, {0, 1, 0}}};
  for (const Axis& wheel : wheels) CHECK(wheel_problem(wheel, kDegree).empty());
  CHECK_FALSE(leave_a_motion_free(wheels));
  const Rolling all = rolling(wheels);
  const double rows[4][3] = {{1, -1, -0.5}, {-1, -1, -0.5}, {1, 1, -0.5}, {1, -1, 0.5}};
  for (int n = 0; n < 4; ++n) {
    for (int k = 0; k < 3; ++k) {
      CHECK(all.rows(n, k) == Approx(rows[n][k]));
      CHECK(all.columns(k, n) == Approx(rows[n][k] / (k == 2 ? 1 : 4)));
    }
  }
  CHECK((all.columns * all.rows - Eigen::Matrix3d::Identity()).norm() < 1e-12);

  std::vector<Axis> from_bumper = wheels;  // the same base, its origin ahead of all wheels
  for (Axis& wheel : from_bumper) wheel.point.x() -= 0.5;
  CHECK((rolling(from_bumper).rows.leftCols(2) - all.rows.leftCols(2)).norm() < 1e-12);
}

TEST_CASE("what cannot be a mecanum wheel is said") {
  CHECK(wheel_problem({{0.2, 0.2, 0}, {0, 0, 1}}, kDegree).find("points 90 degrees away") != std::string::npos);
  CHECK(wheel_problem({{0.2, 0.2, 0}, {1, 0, 0}}, kDegree).find("points 90 degrees away") != std::string::npos);
  CHECK(wheel_problem({{0.2, 0.2, 0}, {0.6, 0.8, 0}}, kDegree).find("points 36.9 degrees away") != std::string::npos);
  const auto base = [](double first_x, double first_y) {
    const Eigen::Vector3d left{0, 1, 0};
    return std::vector<Axis>{
        {{first_x, first_y, 0}, left}, {{0.2, -0.2, 0}, left}, {{-0.2, 0.2, 0}, left}, {{-0.2, -0.2, 0}, left}};
  };
  CHECK(corner_problems(base(0.2, 0.2))[0].empty());
  CHECK(corner_problems(base(0, 0.2))[0].find("rollers") != std::string::npos);
  CHECK(corner_problems(base(0.2, 0))[0].find("rollers") != std::string::npos);
  CHECK(corner_problems(base(-0.3, 0.2))[2].find("same corner") != std::string::npos);
  const auto turned = [](double degrees) {
    return Axis{{0.2, 0.2, 0}, {std::sin(radians(degrees)), std::cos(radians(degrees)), 0}};
  };
  CHECK(wheel_problem(turned(0.99), kDegree).empty());
  CHECK_FALSE(wheel_problem(turned(1.01), kDegree).empty());
}

TEST_CASE("wheels that leave a motion free are found") {
  const Eigen::Vector3d across(0, 1, 0);
  CHECK(leave_a_motion_free({{{0.2, 0.2, 0}, across}, {{-0.2, -0.2, 0}, across}}));  // two for three motions
  CHECK(leave_a_motion_free({{{0.2, 0.2, 0}, across},
                             {{0.3, 0.1, 0}, across},
                             {{-0.2, -0.2, 0}, across},
                             {{-0.3, -0.1, 0}, across}}));  // all rollers one way
  CHECK_FALSE(leave_a_motion_free({}));                     // every joint is wrong: that was said
}

TEST_CASE("a chain says what each joint carries, in axes of the base") {
  const std::vector<Link> links{link("base"), link("upper", 2, {0.3, 0, 0}), link("bracket", 1, {0, 0, 0.1}),
                                link("fore", 0.5, {0, 0, 0.2})};
  std::vector<Joint> joints{joint("shoulder", "base", "upper", {0, 0, 1}, {0, 1, 0}, {0, 0, M_PI / 2}),
                            joint("weld", "upper", "bracket", {0.6, 0, 0}, {1, 0, 0}),
                            joint("elbow", "bracket", "fore", {0, 0, 0.2}, {0, 0, 2})};
  const Mechanism mechanism(links, joints);
  for (std::size_t i = 0; i < 2; ++i) CHECK(chain_problem(mechanism, {"shoulder", "elbow"}, i).empty());
  const auto all = chain(mechanism, {"shoulder", "elbow"}, "base");
  REQUIRE(all.size() == 2);
  check(all[0].offset, {0, 0, 1});
  check(all[0].axis, {-1, 0, 0});
  CHECK(all[0].mass == Approx(3));
  check(all[0].centre, {0, (2 * 0.3 + 0.6) / 3, 0.1 / 3});
  check(all[1].offset, {0, 0.6, 0.2});
  check(all[1].axis, {0, 0, 1});
  check(all[1].centre, {0, 0, 0.2});
  CHECK(chain_problem(mechanism, {"elbow", "shoulder"}, 1).find("behind joint 'elbow'") != std::string::npos);
  CHECK_FALSE(chain_problem(mechanism, {"elbow", "elbow"}, 1).empty());
  GeometrySpec geometry;
  geometry.kind = "chain";
  joints[2].type = "prismatic";
  CHECK(joint_problems(place(mechanism, geometry, "base", {"shoulder", "elbow"}))[1].find("it is prismatic") == 0);
}

TEST_CASE("a wrench is about the link that carries most of the joints") {
  const std::vector<Link> links{link("world"), link("hull"), link("pod_1"), link("pod_2"), link("a"),
                                link("b"),     link("c"),    link("d"),     link("e")};
  std::vector<Joint> joints{joint("swim", "world", "hull", {1, 2, -5}, {0, 0, 1}),
                            joint("to_1", "hull", "pod_1", {0, 1, 0}, {0, 0, 1}),
                            joint("to_2", "hull", "pod_2", {0, -1, 0}, {0, 0, 1}),
                            joint("a", "pod_1", "a", {}, {1, 0, 0}),
                            joint("b", "pod_1", "b", {}, {1, 0, 0}),
                            joint("c", "pod_2", "c", {}, {1, 0, 0}),
                            joint("d", "pod_2", "d", {}, {1, 0, 0}),
                            joint("e", "world", "e", {}, {1, 0, 0})};
  joints[0].type = "floating";
  const Mechanism mechanism(links, joints);
  CHECK(mechanism.base() == "hull");
  CHECK(carrier(mechanism, {"a", "b", "c"}) == "pod_1");
  CHECK(carrier(mechanism, {"a", "b", "c", "d"}) == "hull");  // as many each
  CHECK(carrier(mechanism, {"d", "a"}) == "hull");
  CHECK(carrier(mechanism, {"a", "e"}) == "world");
  CHECK(carrier(mechanism, {}).empty());
  const auto base_of = [](std::vector<Link> all, std::vector<Joint> on) { return Mechanism(all, on).base(); };
  Joint ball = joint("ball", "base_link", "payload", {}, {0, 0, 1}),
        arm = joint("arm", "base_link", "arm", {}, {0, 0, 1});
  ball.type = "floating";
  CHECK(base_of({link("base_link"), link("payload"), link("arm")}, {arm, ball}) == "base_link");
  CHECK(base_of({link("base_link", 3), link("payload")}, {ball}) == "base_link");
  CHECK(base_of({link("base_link"), link("payload")}, {ball}) == "payload");
  Device device;
  GeometrySpec geometry;
  geometry.kind = "allocation";
  geometry.role = "thrusters";
  CHECK(geometry_link(mechanism, device.link, geometry, {"a", "b"}) == "pod_1");
  device.link = "hull";
  CHECK(geometry_link(mechanism, device.link, geometry, {"a", "b"}) == "hull");
  CHECK(body_problem(mechanism, "hull", {"a", "b"}).empty());
  CHECK(body_problem(mechanism, "world", {"a"}) == "link 'world' is the world, which does not move");
  CHECK(body_problem(mechanism, "e", {"a"}) == "link 'e' is the world, which does not move");
  CHECK(body_problem(mechanism, "a", {"b", "a"}) == "joint 'a' moves link 'a' against the body");
}

TEST_CASE("what is ahead is said by the body, not by the ground or the world below it") {
  const auto body_of = [](const std::string& root, std::array<double, 3> rpy, const std::string& type = "fixed") {
    std::vector<Link> links{link(root), link("base_link", 3), link("arm")};
    std::vector<Joint> joints{joint("stand", root, "base_link", {0, 0, 0.1}, {0, 0, 1}, rpy),
                              joint("arm", "base_link", "arm", {}, {0, 0, 1})};
    joints[0].type = type;
    return Mechanism(links, joints).body();
  };
  CHECK(body_of("world", {0, 0, 1.5}) == "base_link");
  CHECK(body_of("base_footprint", {0, 0, M_PI}) == "base_link");
  CHECK(body_of("hero/base_footprint", {0, 0, 0.1}) == "base_link");
  CHECK(body_of("base_footprint", {M_PI / 2, 0, 0}) == "base_footprint");  // only there up is up
  CHECK(body_of("base_footprint", {M_PI, 0, 0}) == "base_footprint");
  CHECK(body_of("world", {0, 0.5, 0}) == "world");
  CHECK(body_of("stand", {0, 0, 1.5}) == "stand");
  CHECK(body_of("base_footprint", {0, 0, 1.5}, "continuous") == "base_footprint");
  CHECK(body_of("world", {1, 2, 3}, "floating") == "base_link");
}

TEST_CASE("worlds in a row are worlds, and what stands still beside the robot is not ahead") {
  const std::vector<Link> links{link("map"),          link("odom"), link("base_footprint"),
                                link("base_link", 3), link("arm"),  link("laser", 1)};
  std::vector<Joint> joints{joint("a", "map", "odom", {1, 2, 0}, {0, 0, 1}, {0, 0, 3}),
                            joint("b", "odom", "base_footprint", {1, 0, 0}, {0, 0, 1}, {0, 0, 1}),
                            joint("c", "base_footprint", "base_link", {0, 0, 0.1}, {0, 0, 1}, {0, 0, M_PI}),
                            joint("d", "base_link", "arm", {}, {0, 0, 1}),
                            joint("e", "base_footprint", "laser", {}, {0, 0, 1})};
  joints[1].type = "floating";
  joints[2].type = joints[4].type = "fixed";
  for (const char* type : {"planar", "floating", "fixed"}) {
    joints[0].type = type;
    CHECK(Mechanism(links, joints).base() == "base_footprint");
    CHECK(Mechanism(links, joints).body() == "base_link");
  }
  joints[4].type = "continuous";  // now something moves beside it
  CHECK(Mechanism(links, joints).body() == "base_footprint");
}

TEST_CASE("a sensor's data are in the axes that whoever uses it computes in") {
  DeviceType sensor, chassis, box;
  sensor.geometry.push_back({});
  sensor.geometry[0].kind = "mount";
  chassis.roles.resize(1);
  chassis.roles[0].name = "wheels";
  chassis.geometry.push_back({});
  chassis.geometry[0].kind = "rolling";
  chassis.geometry[0].role = "wheels";
  Robot robot;
  robot.links = {link("base_footprint"), link("base_link", 3), link("frame"), link("wheel"), link("imu")};
  robot.joints = {joint("stand", "base_footprint", "base_link", {}, {0, 0, 1}, {0, 0, 1}),
                  joint("to_frame", "base_link", "frame", {}, {0, 0, 1}, {0, 0, 2}),
                  joint("to_wheel", "frame", "wheel", {}, {0, 1, 0}), joint("to_imu", "frame", "imu", {}, {0, 0, 1})};
  robot.joints[0].type = robot.joints[1].type = robot.joints[3].type = "fixed";
  robot.devices.resize(4);
  const DeviceId imu_id{0}, wheel_id{1}, base_id{2}, group_id{3};
  Device &imu = robot.devices[imu_id], &wheel = robot.devices[wheel_id];
  Device &base = robot.devices[base_id], &group = robot.devices[group_id];
  imu.type = wheel.type = &sensor;
  base.type = &chassis;
  group.type = &box;
  wheel.joint = "to_wheel";
  wheel.role = 0;
  wheel.parent = base_id;
  base.children = {wheel_id};
  CHECK(mount_link(robot, imu_id) == "base_link");
  base.reads.push_back({imu_id, 0, {}});
  CHECK(mount_link(robot, imu_id) == "frame");
  base.link = "base_footprint";
  CHECK(mount_link(robot, imu_id) == "base_footprint");
  imu.parent = group_id;
  group.children = {imu_id};
  CHECK(mount_link(robot, imu_id) == "base_footprint");  // a group computes nothing
  group.link = "base_link";
  CHECK(mount_link(robot, imu_id) == "base_link");  // unless it says of what
  group.link.clear();
  group.parent = base_id;
  base.reads.clear();
  CHECK(mount_link(robot, imu_id) == "base_footprint");
}

TEST_CASE("a servo turns within the joint's limits and its own travel") {
  Joint turning = joint("pan", "base", "head", {}, {0, 0, 1});
  turning.lower = -1.5;
  turning.upper = 3;
  const Range range = within_travel(limits_of(turning).value(), 3);
  CHECK(range.lower == Approx(-1.5));
  CHECK(range.upper == Approx(1.5));
  turning.lower = 2;
  CHECK(within_travel(*limits_of(turning), 3).lower >= within_travel(*limits_of(turning), 3).upper);
  turning.type = "continuous";
  CHECK_FALSE(limits_of(turning));
}

namespace {

/// A hull with thrusters anywhere, some on pods, pointing anywhere.
struct RandomHull {
  explicit RandomHull(std::mt19937& random, std::size_t thrusters) {
    std::uniform_real_distribution<double> place(-1, 1), angle(-M_PI, M_PI);
    links = {link("hull"), link("pod")};
    joints = {joint("to_pod", "hull", "pod", {place(random), place(random), place(random)}, {0, 0, 1},
                    {angle(random), angle(random), angle(random)})};
    for (std::size_t n = 0; n < thrusters; ++n) {
      const std::string name = "t" + std::to_string(n);
      names.push_back(name);
      links.push_back(link(name));
      joints.push_back(joint(name, n % 3 == 2 ? "pod" : "hull", name, {place(random), place(random), place(random)},
                             {place(random), place(random), place(random)},
                             {angle(random), angle(random), angle(random)}));
    }
  }
  [[nodiscard]] std::vector<Axis> axes(const std::string& of) const {
    const Mechanism mechanism(links, joints);
    std::vector<Axis> axes;
    for (const std::string& name : names) axes.push_back(joint_axis(mechanism, name, of).value());
    return axes;
  }
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<std::string> names;
};

/// By another way than the product's: A^T (A A^T)^+ from the eigenvectors of A A^T, and for few thrusters (A^T A)^+
/// A^T.
Eigen::MatrixXd inverse_by_eigenvectors(const Eigen::MatrixXd& a) {
  const bool wide = a.cols() >= a.rows();
  const Eigen::MatrixXd square = wide ? Eigen::MatrixXd(a * a.transpose()) : Eigen::MatrixXd(a.transpose() * a);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(square);
  Eigen::VectorXd values = solver.eigenvalues();
  const double least = 1e-12 * values.maxCoeff();
  for (double& value : values) value = value > least ? 1 / value : 0;
  const Eigen::MatrixXd inverse = solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
  return wide ? Eigen::MatrixXd(a.transpose() * inverse) : Eigen::MatrixXd(inverse * a.transpose());
}

}  // namespace

TEST_CASE("an allocation is the pseudo-inverse, finite, wherever the thrusters are") {
  std::mt19937 random(13);
  for (std::size_t round = 0; round < 400; ++round) {
    const RandomHull hull(random, 1 + round % 10);
    const std::vector<Axis> axes = hull.axes("hull");
    const Eigen::MatrixXd matrix = allocation(axes);
    REQUIRE(matrix.allFinite());
    const Eigen::MatrixXd other = inverse_by_eigenvectors(wrench_matrix(axes));
    INFO("round " << round << "\n" << matrix << "\n" << other);
    CHECK((matrix - other).norm() <= 1e-6 * std::max(1.0, matrix.squaredNorm()));
    const Eigen::MatrixXd produced = wrench_matrix(axes) * matrix;
    const auto yields = axis_yields(axes);
    for (Eigen::Index k = 0; k < 6; ++k)
      CHECK(yields[static_cast<std::size_t>(k)].fraction == Approx(produced(k, k)).margin(1e-9));
  }
}

TEST_CASE("an allocation stays the same, to the bit, when the hull floats in a world") {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> far(-1e6, 1e6);
  for (int round = 0; round < 50; ++round) {
    RandomHull hull(random, 8);
    const Eigen::MatrixXd before = allocation(hull.axes("hull"));
    hull.links.insert(hull.links.begin(), link("world"));
    hull.joints.insert(hull.joints.begin(),
                       joint("swim", "world", "hull", {far(random), far(random), far(random)}, {1, 0, 0}, {1, 2, 3}));
    hull.joints[0].type = "floating";
    const Mechanism mechanism(hull.links, hull.joints);
    CHECK(carrier(mechanism, hull.names) == "hull");
    CHECK(allocation(hull.axes("hull")) == before);
  }
}

TEST_CASE("an allocation turns with the robot") {
  std::mt19937 random(15);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  for (int round = 0; round < 50; ++round) {
    RandomHull hull(random, 8);
    hull.links.push_back(link("turned"));
    hull.joints.push_back(
        joint("turn", "hull", "turned", {}, {0, 0, 1}, {angle(random), angle(random), angle(random)}));
    const Eigen::Matrix3d to_hull = Mechanism(hull.links, hull.joints).pose("turned", "hull")->linear();
    Eigen::Matrix<double, 6, 6> wrench = Eigen::Matrix<double, 6, 6>::Zero();
    wrench.topLeftCorner<3, 3>() = wrench.bottomRightCorner<3, 3>() = to_hull;
    const Eigen::MatrixXd there = allocation(hull.axes("turned")), here = allocation(hull.axes("hull"));
    CHECK((there - here * wrench).norm() <= 1e-6 * std::max(1.0, here.squaredNorm()));
  }
}

TEST_CASE("what actuators cannot do is said as a fraction of the command") {
  const Eigen::Vector3d up(0, 0, 1);
  const std::vector<Axis> quad{{{0.2, 0.2, 0}, up}, {{0.2, -0.2, 0}, up}, {{-0.2, 0.2, 0}, up}, {{-0.2, -0.2, 0}, up}};
  const double fractions[6] = {0, 0, 1, 1, 1, 0};
  for (std::size_t k = 0; k < 6; ++k) CHECK(axis_yields(quad)[k].fraction == Approx(fractions[k]).margin(1e-12));
  CHECK(axis_yields({{{0, 0, 0}, up}, {{0, 0, 0}, up}})[2].fraction == Approx(1));
  CHECK(axis_yields({{{0, 0, 0}, up}, {{0, 0, 0}, up}})[3].fraction == 0);
  CHECK(axis_yields({})[0].fraction == 0);
  // half a degree of tilt makes fx with 1 / sin(0.5 degrees) times the force of each pair
  const Eigen::Vector3d tilted(std::sin(kDegree / 2), 0, std::cos(kDegree / 2));
  const auto yields = axis_yields({{{0, 0, 0}, up}, {{0, 0, 0}, tilted}});
  CHECK(yields[0].fraction == Approx(1));
  CHECK(yields[0].effort == Approx(1 / std::tan(kDegree / 2)).epsilon(0.01));
}

TEST_CASE("what hardly produces an axis is named: axes or origins") {
  const Eigen::Vector3d up(0, 0, 1), tilted(std::sin(kDegree / 2), 0, std::cos(kDegree / 2));
  const std::vector<Axis> by_axes{{{0.2, 0, 0}, up}, {{-0.2, 0, 0}, up}, {{0, 0, 0}, tilted}};
  CHECK(comes_from_axes(by_axes, 0, kDegree));
  CHECK(near_origins(by_axes, 0, kDegree).coordinate == 0);
  const std::vector<Axis> by_origins{{{0.5, 0.001, 0}, up}, {{-0.5, 0.001, 0}, up}, {{0, -0.001, 0}, up}};
  CHECK(axis_yields(by_origins)[3].effort > 57);
  CHECK_FALSE(comes_from_axes(by_origins, 3, kDegree));
  const NearOrigins near = near_origins(by_origins, 3, kDegree);
  CHECK(near.coordinate == 'y');
  CHECK(near.apart == Approx(0.002));
}

TEST_CASE("limits about an axis are those of the joint, turned with it, and cut to what the params allow") {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  const std::vector<Link> links{link("base"), link("turret"), link("head")};
  ParamSpec lowest, highest;
  lowest.name = "lowest";
  highest.name = "highest";
  GeometrySpec range;
  range.kind = "range";
  range.role = "pitch";
  range.along = "y";
  range.lowest = "lowest";
  range.highest = "highest";
  for (int round = 0; round < 200; ++round) {
    const double tilt = round % 2 == 0 ? 0 : M_PI, a = angle(random), b = angle(random), c = angle(random);
    std::vector<Joint> joints{joint("yaw", "base", "turret", {}, {0, 0, 1}),
                              joint("pitch", "turret", "head", {}, {0, 1, 0}, {tilt, a, 0})};
    joints[1].lower = std::min(a, b);
    joints[1].upper = std::max(a, b);
    Device device;
    device.params = {{&lowest, c - 0.5, true}, {&highest, c + 0.5, true}};
    const Range is = role_ranges(Mechanism(links, joints), device.link, device.params, range, {"pitch"}).at(0);
    // an angle is in it where the joint, turned by it, is within its limits, and the params allow it
    for (int probe = 0; probe < 20; ++probe) {
      const double about_y = angle(random), own = tilt == 0 ? about_y : -about_y;
      const bool reached = own >= joints[1].lower && own <= joints[1].upper && std::fabs(about_y - c) <= 0.5;
      CHECK(reached == (about_y >= is.lower && about_y <= is.upper));
    }
    joints[1].type = "continuous";
    CHECK(role_ranges(Mechanism(links, joints), device.link, device.params, range, {"pitch"}).empty());
  }
}

TEST_CASE("a gimbal's axes point where its loops think, one behind the other") {
  const std::vector<Link> links{link("base"), link("turret"), link("head")};
  const std::vector<Joint> joints{joint("yaw", "base", "turret", {}, {0, 0, -1}),
                                  joint("pitch", "turret", "head", {}, {0, 1, 0.01})};
  const Mechanism mechanism(links, joints);
  GeometrySpec yaw, pitch;
  yaw.kind = pitch.kind = "axes";
  yaw.role = "yaw";
  yaw.along = "z";
  pitch.role = "pitch";
  pitch.along = "y";
  pitch.behind = "yaw";
  CHECK(joint_problems(place(mechanism, yaw, "base", {"yaw"}, {}))[0].empty());
  CHECK(joint_problems(place(mechanism, pitch, "base", {"pitch"}, "yaw"))[0].empty());
  CHECK(joint_problems(place(mechanism, yaw, "base", {"pitch"}, {}))[0].find("points 89.4 degrees away") !=
        std::string::npos);
  CHECK(joint_problems(place(mechanism, pitch, "base", {"pitch"}, "pitch"))[0] ==
        "it does not hang behind joint 'pitch', which turns the yaw");
}
