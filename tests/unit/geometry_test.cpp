// Geometry from links and joints: poses, masses, wheels, chains, against numbers worked out by hand.
#include <cmath>

#include "catch.hpp"
#include "generator/geometry/allocation.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/mass.hpp"
#include "generator/geometry/rolling.hpp"

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
  check(mechanism.pose("b")->translation(), {0, 1, 2});
  check(joint_axis(mechanism, "to_a")->direction, {0, 1, 0});
  CHECK_FALSE(joint_axis(mechanism, "to_c"));
  joints[1].parent_link = "b";  // a ring
  CHECK_FALSE(mechanism.pose("a"));
  CHECK_FALSE(joint_axis(mechanism, "to_b"));
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
  for (const Axis& wheel : wheels) CHECK(wheel_problem(wheel).empty());
  const Rolling all = rolling(wheels);
  const double rows[4][3] = {{1, -1, -0.5}, {-1, -1, -0.5}, {1, 1, -0.5}, {1, -1, 0.5}};
  for (int n = 0; n < 4; ++n) {
    for (int k = 0; k < 3; ++k) {
      CHECK(all.rows(n, k) == Approx(rows[n][k]));
      CHECK(all.columns(k, n) == Approx(rows[n][k] / (k == 2 ? 1 : 4)));
    }
  }
  CHECK((all.columns * all.rows - Eigen::Matrix3d::Identity()).norm() < 1e-12);
}

TEST_CASE("what cannot be a mecanum wheel is said") {
  CHECK(wheel_problem({{0.2, 0.2, 0}, {0, 0, 1}}).find("level") != std::string::npos);
  CHECK(wheel_problem({{0.2, 0.2, 0}, {1, 0, 0}}).find("across") != std::string::npos);
  CHECK(wheel_problem({{0, 0.2, 0}, {0, 1, 0}}).find("rollers") != std::string::npos);
  CHECK(wheel_problem({{0.2, 0, 0}, {0, 1, 0}}).find("rollers") != std::string::npos);
}

TEST_CASE("a chain says what each joint carries, in axes of the base") {
  const std::vector<Link> links{link("base"), link("upper", 2, {0.3, 0, 0}), link("bracket", 1, {0, 0, 0.1}),
                                link("fore", 0.5, {0, 0, 0.2})};
  std::vector<Joint> joints{joint("shoulder", "base", "upper", {0, 0, 1}, {0, 1, 0}, {0, 0, M_PI / 2}),
                            joint("weld", "upper", "bracket", {0.6, 0, 0}, {1, 0, 0}),
                            joint("elbow", "bracket", "fore", {0, 0, 0.2}, {0, 0, 2})};
  const Mechanism mechanism(links, joints);
  for (std::size_t i = 0; i < 2; ++i) CHECK(chain_problem(mechanism, {"shoulder", "elbow"}, i).empty());
  const auto all = chain(mechanism, {"shoulder", "elbow"});
  REQUIRE(all.size() == 2);
  check(all[0].offset, {0, 0, 1});
  check(all[0].axis, {-1, 0, 0});
  CHECK(all[0].mass == Approx(3));
  check(all[0].centre, {0, (2 * 0.3 + 0.6) / 3, 0.1 / 3});
  check(all[1].offset, {0, 0.6, 0.2});
  check(all[1].axis, {0, 0, 1});
  check(all[1].centre, {0, 0, 0.2});
  CHECK(chain_problem(mechanism, {"elbow", "shoulder"}, 1).find("behind joint 'elbow'") != std::string::npos);
  joints[2].type = "prismatic";
  CHECK(chain_problem(mechanism, {"shoulder", "elbow"}, 1).find("prismatic") != std::string::npos);
}
